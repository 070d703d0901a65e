// The command line as a whole.
#pragma once

namespace pedzone {

/// Does what the words ask for; returns the exit code. Errors are printed, not thrown.
int command_line(int argc, char** argv);

}  // namespace pedzone
