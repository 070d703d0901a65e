// Where SUMO writes its floating-car data, if the user wants it.
#pragma once

#include <optional>
#include <string>

#include "sumo/files/scenario.hpp"

namespace pedzone {

/// The fcd-output that the user has SUMO write; nothing: none. Throws InputError where it could not
/// be read afterwards.
std::optional<std::string> fcd_output_of(const Scenario& scenario);

/// Has SUMO write everybody to `file`, as can be read, whatever else the user says of such data. An
/// output-prefix is put before its name. Throws InputError where the user lists edges: SUMO cannot
/// be told of all again.
void write_everybody(Scenario& scenario, const std::string& file);

}  // namespace pedzone
