#include "core/gzip_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"
#include "core/input_files.hpp"

namespace pedzone {

struct GzipFile::Stream {
  // gzopen reads plain files as they are.
  explicit Stream(const std::string& file) : handle(gzopen(file.c_str(), "rb")) {}
  ~Stream() { gzclose(handle); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  gzFile handle;
};

GzipFile::GzipFile(std::string file)
    : file_(std::move(file)), stream_(std::make_unique<Stream>(file_)) {
  if (stream_->handle == nullptr || std::filesystem::is_directory(file_)) {
    throw InputError("cannot be opened", {.file = file_});
  }
  note_input(file_);
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file_, unknown);
  if (!unknown && size > 0) size_ = size;
}

GzipFile::~GzipFile() = default;

int GzipFile::read(void* space, int most) {
  const int got = gzread(stream_->handle, space, static_cast<unsigned>(most));
  int code = Z_OK;
  const char* reason = gzerror(stream_->handle, &code);
  if (got < 0 || (code != Z_OK && code != Z_STREAM_END)) {
    throw InputError(std::string("cannot be read (") + reason + ")", {.file = file_});
  }
  return got;
}

void GzipFile::tell(const ReadProgress& progress) const {
  if (!progress || !size_) return;
  const auto read = static_cast<double>(gzoffset(stream_->handle));
  progress(std::min(1.0, read / static_cast<double>(*size_)));
}

}  // namespace pedzone
