// A file read piece by piece, gzipped or not.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace pedzone {

/// Told now and then how much of a file has been read, [0, 1].
using ReadProgress = std::function<void(double share)>;

class GzipFile {
 public:
  static constexpr int kPiece = 1 << 18;  ///< [bytes] numerical: a good size to read at a time

  /// Throws InputError when the file is missing or cannot be opened.
  explicit GzipFile(std::string file);
  ~GzipFile();

  /// Reads up to `most` bytes; fewer only at the file's end. Throws InputError.
  int read(void* space, int most);
  /// Tells how much has been read, where the file's size is known.
  void tell(const ReadProgress& progress) const;

 private:
  struct Stream;

  std::string file_;
  std::unique_ptr<Stream> stream_;
  std::optional<std::uintmax_t> size_;  ///< [bytes] > 0, as it lies on the disk
};

}  // namespace pedzone
