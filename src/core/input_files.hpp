// What this program has read, so that nothing it writes takes the place of that.
#pragma once

#include <string>

namespace pedzone {

/// The file is read, or about to be. Nothing for what is no plain file.
void note_input(const std::string& file);

/// Whether it is one that was noted, by whatever name.
bool is_input(const std::string& file);

}  // namespace pedzone
