// Text that comes from users on the command lines of shells.
#pragma once

#include <string>

namespace pedzone {

/// As one word of a shell, whatever it holds; quoted where it has to be.
std::string shell_word(const std::string& text);

}  // namespace pedzone
