// Waiting for a child process.
#pragma once

#include <sys/types.h>

namespace pedzone {

/// Waits until the child has ended, however often a signal interrupts that: its status, as of
/// waitpid().
int wait_for_child(pid_t child);

}  // namespace pedzone
