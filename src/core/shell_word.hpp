// Text that comes from users on the command lines of shells.
#pragma once

#include <string>
#include <vector>

namespace pedzone {

/// As one word of a shell, whatever it holds; quoted where it has to be.
std::string shell_word(const std::string& text);

/// A program and its arguments as such words.
std::string shell_command(const std::vector<std::string>& words);

}  // namespace pedzone
