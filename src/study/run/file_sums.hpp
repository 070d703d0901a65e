// Checksums of files, as sha256sum prints them.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace pedzone::study {

/// SHA-256 of a file's content. Throws InputError where it cannot be read.
std::string sha256_of_file(const std::string& file);

/// Checksums of files that many runs share: each file is read once.
class FileSums {
 public:
  /// Throws InputError where it cannot be read.
  const std::string& of(const std::string& file);
  /// Takes them from somebody who has read the files.
  void learn(const std::map<std::string, std::string>& sums) {
    known_.insert(sums.begin(), sums.end());
  }
  /// The first of these files that has another checksum, or is gone; unset: none.
  std::optional<std::string> changed(const std::map<std::string, std::string>& sums);
  /// Whether all these files are there and have these checksums.
  bool match(const std::map<std::string, std::string>& sums) { return !changed(sums); }

 private:
  std::map<std::string, std::string> known_;
};

}  // namespace pedzone::study
