// The reference table of all parameters, made from the code's own list.
#pragma once

#include <string>

namespace pedzone {

/// Markdown, one row a parameter.
std::string parameter_table();

}  // namespace pedzone
