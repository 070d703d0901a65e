// Where SUMO writes its floating-car data, if the user wants it.
#pragma once

#include <optional>
#include <string>

#include "sumo/files/scenario.hpp"

namespace pedzone {

/// The fcd-output that the user has SUMO write; nothing: none. Throws InputError where it could not
/// be read afterwards.
std::optional<std::string> fcd_output_of(const Scenario& scenario);

}  // namespace pedzone
