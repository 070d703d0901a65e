// A file that is either complete or absent: written beside its place under the name with
// `.partial`, renamed when all is there.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace pedzone {

class CompleteFile {
 public:
  /// Makes missing folders. Throws InputError when the place cannot be written.
  /// `option`: what the user named it with, for the message.
  CompleteFile(std::string path, const std::string& option);
  /// Not finished: the partial file is removed.
  ~CompleteFile();
  CompleteFile(const CompleteFile&) = delete;
  CompleteFile& operator=(const CompleteFile&) = delete;

  /// Throws std::runtime_error when the disk is full and the like.
  void write(std::string_view text);
  /// Flushes and moves the file to its place. Throws std::runtime_error.
  void finish();

  /// The name under which an unfinished file lies.
  static std::string partial(const std::string& path) { return path + ".partial"; }

 private:
  std::string path_;
  std::FILE* file_ = nullptr;
};

/// Writes a whole file at once. Throws as CompleteFile.
void write_complete_file(const std::string& path, std::string_view text, const std::string& option);

}  // namespace pedzone
