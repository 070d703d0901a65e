// `pedzone conflicts`: the conflicts in SUMO's floating-car data, whoever walked its persons.
#pragma once

#include <CLI/CLI.hpp>

namespace pedzone {

void add_conflicts(CLI::App& app, int& code);

}  // namespace pedzone
