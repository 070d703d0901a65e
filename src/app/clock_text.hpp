// How long something takes, for people.
#pragma once

#include <string>

namespace pedzone {

/// 0:07, 12:34 or 1:02:03. `seconds` at least 0.
std::string clock_text(double seconds);

}  // namespace pedzone
