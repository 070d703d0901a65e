// A SUMO scenario as files: read before SUMO starts, so that bad input is told apart from a SUMO
// that fails, and so that `pedzone inspect` needs no running SUMO.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
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
/// selects a pedestrian model other than striping, or names an option that pedzone cannot go along
/// with (--mesosim, saved states, --help).
Scenario read_scenario(const std::string& config, const std::vector<std::string>& sumo_options);

/// The same whatever the pedestrian model: for what a run without pedzone has written.
Scenario read_any_scenario(const std::string& config, const std::vector<std::string>& sumo_options);

/// The words that SUMO is started with after its configuration: what the user says wins, what
/// pedzone adds is left out where the user says it. Throws InputError where a seed or end that was
/// given to pedzone is said to SUMO, too.
std::vector<std::string> words_for_sumo(const Scenario& scenario,
                                        const std::optional<std::uint64_t>& seed,
                                        const std::optional<double>& end);

/// Whether the user wants SUMO to print its steps.
bool has_step_log(const Scenario& scenario);

/// Network, polygons and waypoints of a scenario.
/// Throws InputError when malformed.
Network read_scenario_network(const Scenario& scenario);

/// Whether a route or additional file of the scenario has a person or person flow.
bool names_person(const Scenario& scenario);
/// To be thrown where it has to.
InputError no_person(const Scenario& scenario);

/// What SUMO will take for some of its options, before it is started: given to it on the command
/// line, else in the configuration, else its default. Throws InputError for what is no number.
struct ScenarioNumbers {
  std::uint64_t seed;
  double begin;     ///< [s]
  double dawdling;  ///< of striping, [0, 1]
};
ScenarioNumbers read_numbers(const Scenario& scenario);

/// Throws InputError where a run that ends at `end` [s] would end before it begins. `what`: where
/// the user says so.
void require_later_end(const Scenario& scenario, double end, const InputPlace& what);

/// Has SUMO read one more additional file.
void add_additional_file(Scenario& scenario, const std::string& file);

}  // namespace pedzone
