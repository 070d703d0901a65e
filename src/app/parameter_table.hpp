// The reference tables of what a zone file can say, made from the code's own lists.
#pragma once

#include <string>

namespace pedzone {

/// Markdown: a row for each parameter of a zone, then one for each attribute of <pedestrians>.
std::string parameter_tables();

}  // namespace pedzone
