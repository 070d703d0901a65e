// The demand of a free-speed run: a few of the scenario's people, each alone on the way, and no
// vehicle. With nobody to interact with, models must walk them equally fast; where they do not, a
// difference between them in the full scenario may be just that.
#pragma once

#include <string>
#include <unordered_set>

#include "sumo/files/scenario.hpp"

namespace pedzone::study {

struct FreeSpeedInput {
  const Scenario& scenario;
  const Network& network;
  const std::unordered_set<int>& zone_edges;  ///< Network indices
  std::string panel;   ///< a route file's text with more people; may be empty
  double begin = 0.0;  ///< [s] of the simulation
};

struct FreeSpeedDemand {
  std::string routes;       ///< text of a route file: types, and persons with their ids
  double end = 0.0;         ///< [s] by which everybody has long arrived
  std::size_t persons = 0;  ///< at most kFreeSpeedPersons
};

inline constexpr std::size_t kFreeSpeedPersons = 12;  ///< assumed: enough for a mean within 1 %

/// Chooses from persons and flows that only walk, with way enough in the zones, spread over the
/// files. Each departs when the one before has had twice the time that it needs, and more. Groups
/// are dissolved. Throws InputError where nobody walks through a zone.
FreeSpeedDemand free_speed_demand(const FreeSpeedInput& input);

}  // namespace pedzone::study
