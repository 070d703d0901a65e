// How fast people walk who have nobody to interact with: what makes models a fair pair.
#pragma once

#include <map>
#include <string>

namespace pedzone::study {

/// Free speed [m/s] by person id, from a free-speed run: distance over time from SUMO's own
/// floating-car data while the person moves, where the model itself walks it.
///  - `trajectories` of pedzone: between steps in both of which pedzone had the person.
///  - Empty, for SUMO's own models: on edges between junctions. Over a walking area striping draws
///    a curve up to a tenth longer than the way on which it moves the person, so that positions
///    there seem too fast; nonInteracting jumps over it.
/// Persons of whom less than 10 s are known are left out. Throws InputError where a file is
/// missing, cut off or something else.
std::map<std::string, double> free_speeds_of(const std::string& fcd,
                                             const std::string& trajectories);

}  // namespace pedzone::study
