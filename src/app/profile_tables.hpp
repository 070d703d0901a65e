// Tables of who people are, what they do and what the weather does, as the README shows them.
#pragma once

#include <string>

namespace pedzone {

/// Markdown.
std::string profile_tables();

}  // namespace pedzone
