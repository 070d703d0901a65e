#include "study/run/file_sums.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "study/plan/checksum.hpp"

namespace pedzone::study {

std::string sha256_of_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream content;
  // An empty file has nothing to insert, which is no failure; a folder opens, but cannot be read.
  if (in.peek() != std::ifstream::traits_type::eof()) content << in.rdbuf();
  if (!in.is_open() || in.bad() || content.fail()) {
    throw InputError("cannot be read (" + std::string(std::strerror(errno)) + ")",
                     {.value = file, .allowed = "a file"});
  }
  return sha256_hex(content.view());
}

const std::string& FileSums::of(const std::string& file) {
  const auto found = known_.find(file);
  if (found != known_.end()) return found->second;
  return known_.emplace(file, sha256_of_file(file)).first->second;
}

std::optional<std::string> FileSums::changed(const std::map<std::string, std::string>& sums) {
  for (const auto& [file, sum] : sums) {
    try {
      if (of(file) != sum) return file;
    } catch (const InputError&) {
      return file;
    }
  }
  return std::nullopt;
}

}  // namespace pedzone::study
