#include "results/complete_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <stdexcept>

#include "core/error.hpp"
#include "core/input_files.hpp"

namespace pedzone {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // Linux follows no more

/// The file that a symbolic link leads to, be it there or not.
fs::path target_of(fs::path path) {
  std::error_code none;
  for (int k = 0; k < kMostLinks && fs::is_symlink(path, none); ++k) {
    const fs::path target = fs::read_symlink(path, none);
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  return path;
}

/// The descriptor of this process that the path names; −1: none.
int descriptor_of(const std::string& path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    int descriptor = -1;
    const char* const end = path.data() + path.size();
    if (path.starts_with(folder) &&
        std::from_chars(path.data() + folder.size(), end, descriptor).ptr == end) {
      return descriptor;
    }
  }
  return -1;
}

/// Whether there is something that must not be replaced by a file.
bool is_special(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return false;
  return !S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode);
}

/// Written to at once: the descriptor, or −1 with errno.
int open_special(const std::string& path) {
  const int descriptor = descriptor_of(path);
  if (descriptor < 0) return open(path.c_str(), O_WRONLY | O_CLOEXEC);
  std::fflush(nullptr);
  return dup(descriptor);
}

bool is_compressed(const std::string& path) { return fs::path(path).extension() == ".gz"; }

InputError cannot_be_written(const std::string& path, const std::string& option,
                             const std::string& why) {
  return {"cannot be written (" + why + ")",
          {"", 0, "option " + option, path, "a file in a folder that can be written"}};
}

void require_no_input(const std::string& path, const std::string& option) {
  if (!is_input(path)) return;
  throw InputError("names a file that is read",
                   {"", 0, "option " + option, path, "another file, which may be a new one"});
}

/// The outputs that are being written, by where they lie till then, and the option of each.
class Claims {
 public:
  void claim(const std::string& place, const std::string& path, const std::string& option) {
    const std::scoped_lock lock(mutex_);
    const auto [other, is_new] = options_.emplace(place, option);
    if (is_new) return;
    throw InputError("names the same file as " + other->second,
                     {"", 0, "option " + option, path, "a file for each output"});
  }
  void release(const std::string& place) {
    const std::scoped_lock lock(mutex_);
    options_.erase(place);
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::string> options_;
};

Claims& claims() {
  static Claims all;
  return all;
}

}  // namespace

Claim::Claim(const std::string& path, const std::string& option)
    : place_(CompleteFile::place(path)) {
  if (!place_.empty()) claims().claim(place_, path, option);
}

Claim::~Claim() {
  if (!place_.empty()) claims().release(place_);
}

std::string CompleteFile::partial(const std::string& path) {
  if (descriptor_of(path) >= 0 || is_special(path)) return "";
  return target_of(path).string() + ".partial";
}

bool CompleteFile::is_standard_output(const std::string& path) {
  return descriptor_of(path) == STDOUT_FILENO;
}

std::string CompleteFile::place(const std::string& path) {
  if (is_standard_output(path)) return "-";
  const std::string plain = partial(path);
  return plain.empty() ? "" : fs::weakly_canonical(fs::absolute(plain)).string();
}

PendingFile::PendingFile(const std::string& path, const std::string& option)
    : claim_(path, option), path_(path), option_(option), partial_(CompleteFile::partial(path)) {
  require_no_input(path, option);
  if (partial_.empty()) throw cannot_be_written(path, option, "it is no plain file");
  std::error_code ignored;  // a failure shows when the file is opened
  if (fs::is_directory(path, ignored)) throw cannot_be_written(path, option, "it is a folder");
  const fs::path folder = fs::path(partial_).parent_path();
  if (!folder.empty()) fs::create_directories(folder, ignored);
  const int file = open(partial_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw cannot_be_written(path, option, std::strerror(errno));
  close(file);
}

PendingFile::~PendingFile() {
  if (!partial_.empty()) std::remove(partial_.c_str());
}

void PendingFile::finish() {
  require_no_input(path_, option_);
  std::error_code error;
  fs::rename(partial_, target_of(path_), error);
  if (error) throw std::runtime_error("cannot write " + path_ + ": " + error.message());
  partial_.clear();
}

CompleteFile::CompleteFile(const std::string& path, const std::string& option) : path_(path) {
  const char* mode = is_compressed(path) ? "wb" : "wbT";  // T: not compressed
  errno = 0;
  if (partial(path).empty()) {
    claim_ = std::make_unique<Claim>(path, option);
    const int descriptor = open_special(path);
    if (descriptor >= 0) file_ = gzdopen(descriptor, mode);
  } else {
    pending_ = std::make_unique<PendingFile>(path, option);
    file_ = gzopen(pending_->name().c_str(), mode);
  }
  if (file_ == nullptr) throw cannot_be_written(path, option, std::strerror(errno));
}

CompleteFile::~CompleteFile() {
  if (file_ != nullptr) gzclose(file_);
}

void CompleteFile::write(std::string_view text) {
  if (text.empty()) return;
  if (gzfwrite(text.data(), 1, text.size(), file_) != text.size()) {
    throw std::runtime_error("cannot write " + path_ + ": " + std::strerror(errno));
  }
}

void CompleteFile::finish() {
  errno = 0;
  const bool closed = gzclose(file_) == Z_OK;
  const std::string why = closed || errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  file_ = nullptr;
  if (!closed) {
    pending_.reset();
    throw std::runtime_error("cannot write " + path_ + why);
  }
  if (pending_) pending_->finish();
}

void write_complete_file(const std::string& path, std::string_view text,
                         const std::string& option) {
  CompleteFile file(path, option);
  file.write(text);
  file.finish();
}

}  // namespace pedzone
