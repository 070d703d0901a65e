// Ending a run early on request, so that what was simulated is not lost.
#pragma once

#include <sys/types.h>

namespace pedzone {

/// From now on the first SIGINT, SIGTERM or SIGHUP is only noted. A later one ends the process.
/// (One request may come twice: from the terminal and from the parent. What comes within half a
/// second is one request.)
void note_interrupts();

/// The signal noted; 0: none.
int noted_interrupt();

/// Passes these signals on to the child from now on.
void pass_interrupts_to(pid_t child);

}  // namespace pedzone
