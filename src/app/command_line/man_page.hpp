// The manual page, made of the commands themselves.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace pedzone {

/// man(7).
std::string man_page(const CLI::App& app);

}  // namespace pedzone
