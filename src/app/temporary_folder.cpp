#include "app/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace pedzone {

TemporaryFolder::TemporaryFolder()
    : path_((std::filesystem::temp_directory_path() / "pedzone-XXXXXX").string()) {
  if (mkdtemp(path_.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), "cannot make the folder " + path_);
  }
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;  // what cannot be removed is left
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace pedzone
