// The people that a panel asks for, planned before the simulation begins: who they are, where and
// when they walk. The same seed gives the same people, another seed others with the same
// statistics.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "zone/zone.hpp"

namespace pedzone {

/// Where a walk begins or ends.
struct PlannedPlace {
  int edge = -1;          ///< Network index
  double position = 0.0;  ///< [m] along the lane that persons walk on
  double lateral = 0.0;   ///< [m] to the left of its centre line
};

struct PlannedPerson {
  std::string id;  ///< ID.0, ID.1, ... of the panel ID
  const Profile* profile = nullptr;
  double speed = 0.0;   ///< [m/s] preferred
  double depart = 0.0;  ///< [s]
  PlannedPlace from, to;
  std::string group;                    ///< empty: alone
  Activity activity = Activity::kNone;  ///< what it does now and then
  const PanelSpec* panel = nullptr;
};

/// What people are planned for. All of it must outlive them.
struct DemandInput {
  const Network& network;
  const std::vector<Zone>& zones;
  const Profiles& profiles;
  const std::vector<PanelSpec>& panels;
  std::uint64_t seed = 0;
  double begin = 0.0;  ///< [s] of the simulation
};

/// Plans the people of all panels, by departure; those of one moment in the order of their panels
/// and ids. Preferred speeds: the profile's normal distribution, truncated to (0.1, topSpeed] and
/// the panel's range. Profiles: independent draws with the panel's shares; a guarded one is only
/// drawn for somebody who has an unguarded one in its group. Places: uniform over the area of the
/// edges' walking lanes; members of a group begin within a metre or so of each other, at once, and
/// go to one place. Arrivals by the hour: a Poisson process of groups and single persons.
/// Throws InputError for unknown zones and edges, edges that nobody may walk on, and where no way
/// on foot leads from any origin to any destination.
std::vector<PlannedPerson> plan_people(const DemandInput& input);

}  // namespace pedzone
