#include "results/complete_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "core/error.hpp"

namespace pedzone {

CompleteFile::CompleteFile(std::string path, const std::string& option) : path_(std::move(path)) {
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  std::error_code ignored;  // a failure shows when the file is opened
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  if (!std::filesystem::is_directory(path_)) file_ = std::fopen(partial(path_).c_str(), "wb");
  if (file_ == nullptr) {
    const std::string why =
        std::filesystem::is_directory(path_) ? "it is a folder" : std::strerror(errno);
    throw InputError("cannot be written (" + why + ")",
                     {"", 0, "option " + option, path_, "a file in a folder that can be written"});
  }
}

CompleteFile::~CompleteFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(partial(path_).c_str());
}

void CompleteFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
    throw std::runtime_error("cannot write " + path_ + ": " + std::strerror(errno));
  }
}

void CompleteFile::finish() {
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  std::error_code error;
  if (closed) std::filesystem::rename(partial(path_), path_, error);
  if (!closed || error) {
    std::remove(partial(path_).c_str());
    throw std::runtime_error("cannot write " + path_);
  }
}

void write_complete_file(const std::string& path, std::string_view text,
                         const std::string& option) {
  CompleteFile file(path, option);
  file.write(text);
  file.finish();
}

}  // namespace pedzone
