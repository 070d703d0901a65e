// `pedzone attach`: a client of a SUMO that runs, beside an automated vehicle's controller.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

void add_attach(CLI::App& app, int& code);

}  // namespace pedzone
