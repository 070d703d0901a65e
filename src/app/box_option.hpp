// Options that take a rectangle of the network.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "zone/shapes.hpp"

namespace pedzone {

/// LEFT BOTTOM RIGHT TOP [m].
CLI::Option* add_box_option(CLI::App& command, const std::string& name, std::vector<double>& sides,
                            const std::string& what);

/// The box; empty where no sides are given. Throws InputError, which names the option, where they
/// are none of a box.
Box box_of_sides(const std::vector<double>& sides, const std::string& option);

}  // namespace pedzone
