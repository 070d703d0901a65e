// What counts as yes in SUMO's options and in parameters of persons and vehicles.
#pragma once

#include <string_view>

namespace pedzone {

/// Whether a text means true, as SUMO reads it: 1, yes, true, on, x, t, in capitals, too.
bool is_true(std::string_view text);
/// The same for false: 0, no, false, off, -, f.
bool is_false(std::string_view text);

}  // namespace pedzone
