// How people walk who have nobody to interact with: what makes models a fair pair, and how much of
// a difference is that of their ways.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace pedzone::study {

/// Somebody alone.
struct FreeWalk {
  std::optional<double> speed;  ///< [m/s] while moving, where the model itself walks the person
  std::optional<double> way;    ///< [m] from place to place over the whole trip
  std::optional<double> time;   ///< [s] of the whole trip
};

/// Free walks by person id, from a free-speed run's floating-car data. The speed is distance over
/// time while the person moves:
///  - `trajectories` of pedzone: between steps in both of which pedzone had the person.
///  - Empty, or without a row, where SUMO walks: on edges between junctions. Over a walking area
///  striping draws
///    a curve up to a tenth longer than the way on which it moves the person, so that positions
///    there seem too fast; nonInteracting jumps over it.
/// Unset where less than 10 s are known. Way and time are unset of who is still there at the end.
/// Throws InputError where a file is missing, cut off or something else.
std::map<std::string, FreeWalk> free_walks_of(const std::string& fcd,
                                              const std::string& trajectories);

/// As a record has them: "speed:ID", "way:ID", "time:ID".
std::map<std::string, double> free_walk_values(const std::map<std::string, FreeWalk>& walks);

}  // namespace pedzone::study
