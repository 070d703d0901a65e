// Keeps two drivers off one directory. Locks belong to a process: when it closes a file on which it
// has one, opened by whom ever, the lock is gone.
#pragma once

#include <string>

namespace pedzone::study {

/// Holds the file `lock` of a directory as long as it lives. The kernel lets it go when the process
/// ends, whatever it dies of; processes that it forks do not hold it.
class DirectoryLock {
 public:
  /// `what`: who this is, for others' messages. Throws InputError, naming who holds it, where
  /// somebody does.
  DirectoryLock(const std::string& folder, const std::string& what);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

 private:
  int file_;
};

/// What the holder said of itself; empty where nobody else holds the directory's lock. Not to be
/// asked by the holder.
std::string lock_holder(const std::string& folder);

/// Takes a lock on an open file for this process until it closes it or ends; false where another
/// process has it.
bool lock_file(int file);
/// Whether another process has a lock on it; false where it is not there. Not to be asked by one
/// that has.
bool is_locked(const std::string& file);

/// Of this machine.
std::string host_name();

}  // namespace pedzone::study
