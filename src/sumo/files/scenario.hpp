// A SUMO scenario as files: read before SUMO starts, so that bad input is told apart from a SUMO
// that fails, and so that `pedzone inspect` needs no running SUMO.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "zone/network.hpp"

namespace pedzone {

struct Scenario {
  std::string config;    ///< the .sumocfg as the user named it
  std::string net_file;  ///< resolved against the configuration's folder
  std::vector<std::string> additional_files, route_files;
  std::vector<std::string> sumo_options;  ///< what the user gave after `--`
};

/// Reads a configuration; options in `sumo_options` (as on SUMO's command line) win over it.
/// Throws InputError when it is missing, malformed, names no network or files that do not exist,
/// selects a pedestrian model other than striping, or names no person.
Scenario read_scenario(const std::string& config, const std::vector<std::string>& sumo_options);

/// The same whatever the pedestrian model: for what a run without pedzone has written.
Scenario read_any_scenario(const std::string& config, const std::vector<std::string>& sumo_options);

/// Network, polygons and waypoints of a scenario.
/// Throws InputError when malformed or when no lane admits persons.
Network read_scenario_network(const Scenario& scenario);

/// Throws InputError when no route or additional file of the scenario has a person or person flow.
void require_persons(const Scenario& scenario);

/// What SUMO will take for some of its options, before it is started: given to it on the command
/// line, else in the configuration, else its default. Throws InputError for what is no number.
struct ScenarioNumbers {
  std::uint64_t seed;
  double begin;     ///< [s]
  double dawdling;  ///< of striping, [0, 1]
};
ScenarioNumbers read_numbers(const Scenario& scenario);

/// Has SUMO read one more additional file.
void add_additional_file(Scenario& scenario, const std::string& file);

}  // namespace pedzone
