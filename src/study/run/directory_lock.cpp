#include "study/run/directory_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <ctime>

#include "core/error.hpp"

namespace pedzone::study {
namespace {

// Locks of fcntl(), not of flock(): a forked process does not share them, and they reach across
// machines on a shared file system.
struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

std::string path_of(const std::string& folder) { return folder + "/lock"; }

std::string text_of(int file) {
  std::array<char, 1024> text{};
  const ssize_t size = pread(file, text.data(), text.size(), 0);
  return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

}  // namespace

std::string host_name() {
  std::array<char, HOST_NAME_MAX + 1> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

bool lock_file(int file) {
  struct flock lock = whole_file();
  return fcntl(file, F_SETLK, &lock) == 0;
}

bool is_locked(const std::string& file) {
  const int opened = open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (opened < 0) return false;
  struct flock lock = whole_file();
  const bool known = fcntl(opened, F_GETLK, &lock) == 0;
  close(opened);
  return known && lock.l_type != F_UNLCK;
}

DirectoryLock::DirectoryLock(const std::string& folder, const std::string& what)
    : file_(open(path_of(folder).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) {
    throw InputError("cannot be written (" + std::string(std::strerror(errno)) + ")",
                     {.value = path_of(folder), .allowed = "a folder that can be written"});
  }
  if (!lock_file(file_)) {
    const std::string holder = text_of(file_);
    close(file_);
    throw InputError("is in use by " + (holder.empty() ? "another process" : holder),
                     {.element = "results", .value = folder, .allowed = "one driver at a time"});
  }
  const std::string text = fmt::format("{}, process {} on {}, since {:%Y-%m-%d %H:%M:%S}", what,
                                       getpid(), host_name(), fmt::localtime(std::time(nullptr)));
  // Only for messages: a disk that is full shows elsewhere.
  if (ftruncate(file_, 0) != 0 || pwrite(file_, text.data(), text.size(), 0) < 0) return;
}

DirectoryLock::~DirectoryLock() { close(file_); }

std::string lock_holder(const std::string& folder) {
  if (!is_locked(path_of(folder))) return "";
  const int file = open(path_of(folder).c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return "";
  const std::string text = text_of(file);
  close(file);
  return text.empty() ? "another process" : text;
}

}  // namespace pedzone::study
