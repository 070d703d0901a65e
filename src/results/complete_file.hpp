// A file that is either complete or absent: written beside its place under the name with
// `.partial`, renamed when all is there.
#pragma once

#include <zlib.h>

#include <memory>
#include <string>
#include <string_view>

namespace pedzone {

/// That an output is being written, by one option only: a second one for the same file, or for
/// standard output, is an InputError.
class Claim {
 public:
  Claim(const std::string& path, const std::string& option);
  ~Claim();
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

 private:
  std::string place_;  ///< empty: a device, which may be shared
};

/// The place of a plain file that is being made, for libraries that write to a name. A symbolic
/// link stays one: the file that it names is made.
class PendingFile {
 public:
  /// Makes missing folders. Throws InputError when the place cannot be written, is no plain file or
  /// one that this program has read (core/input_files.hpp). `option`: what the user named it with,
  /// for the message.
  PendingFile(const std::string& path, const std::string& option);
  /// Not finished: what was written is removed.
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Where to write.
  const std::string& name() const { return partial_; }
  /// Moves what was written to its place. Throws std::runtime_error, and InputError where the
  /// program has read that one meanwhile.
  void finish();

 private:
  Claim claim_;
  std::string path_;  ///< as the user named it
  std::string option_;
  std::string partial_;  ///< empty: it is in its place
};

/// A symbolic link stays one: the file that it names is written. What is no plain file (a device, a
/// FIFO, standard output as `-` or `/dev/stdout`) is written to at once. A name that ends in `.gz`
/// is compressed.
class CompleteFile {
 public:
  /// Makes missing folders. Throws InputError when the place cannot be written, or is being written
  /// by another option. `option`: what the user named it with, for the message.
  CompleteFile(const std::string& path, const std::string& option);
  /// Not finished: the partial file is removed.
  ~CompleteFile();
  CompleteFile(const CompleteFile&) = delete;
  CompleteFile& operator=(const CompleteFile&) = delete;

  /// Throws std::runtime_error when the disk is full and the like.
  void write(std::string_view text);
  /// Flushes and moves the file to its place. Throws std::runtime_error.
  void finish();

  /// The name under which an unfinished file lies; empty where there is none.
  static std::string partial(const std::string& path);
  static bool is_standard_output(const std::string& path);
  /// What a path names, by whatever name: the same for two paths to one plain file, or to standard
  /// output; empty for what may be shared.
  static std::string place(const std::string& path);

 private:
  std::string path_;                      ///< as the user named it
  std::unique_ptr<PendingFile> pending_;  ///< null: it is written to at once
  std::unique_ptr<Claim> claim_;          ///< of what is written to at once
  gzFile file_ = nullptr;
};

/// Writes a whole file at once. Throws as CompleteFile.
void write_complete_file(const std::string& path, std::string_view text, const std::string& option);

}  // namespace pedzone
