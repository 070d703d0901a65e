// A folder for files that nobody is to see.
#pragma once

#include <string>

namespace pedzone {

class TemporaryFolder {
 public:
  /// An empty one where the system keeps such folders (TMPDIR). Throws std::system_error.
  TemporaryFolder();
  /// Removes it with all that is in it.
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace pedzone
