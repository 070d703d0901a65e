// `pedzone demand`: the people of a panel as a SUMO route file.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

void add_demand(CLI::App& app, int& code);

}  // namespace pedzone
