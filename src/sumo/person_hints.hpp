// What a scenario says of a person beyond what SUMO knows: parameters pedzone.* of the person, of
// its vType, or of the member that a vTypeDistribution gave it (the person's own first).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "world/activities.hpp"
#include "world/profiles.hpp"
#include "zone/paths.hpp"

namespace pedzone {

struct PersonHints {
  const Profile* profile = nullptr;       ///< pedzone.profile; null: none
  std::optional<bool> aware;              ///< pedzone.aware, of vehicles; unset: by the profile
  std::uint64_t group = 0;                ///< of pedzone.group; 0: alone
  std::array<double, kPastimes> rates{};  ///< [1/min] of pedzone.activities
  const WaypointPath* path = nullptr;     ///< pedzone.path; null: none
};

/// Reads them from SUMO for a person that is there now. `profiles` and `paths` must
/// outlive the result. Throws InputError naming the person, the key, the value and what is allowed.
PersonHints read_hints(const std::string& person, const Profiles& profiles,
                       const std::vector<WaypointPath>& paths);

}  // namespace pedzone
