// What a scenario can say of a person beyond what SUMO knows, as parameters pedzone.*: what their
// values mean, and whether those in its files mean something, known before SUMO starts, with file
// and line.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sumo/files/scenario.hpp"
#include "world/activities.hpp"
#include "world/profiles.hpp"
#include "zone/paths.hpp"

namespace pedzone {

struct PersonHints {
  const Profile* profile = nullptr;         ///< pedzone.profile; null: none
  std::optional<bool> aware;                ///< pedzone.aware, of vehicles; unset: by the profile
  std::uint64_t group = 0;                  ///< of pedzone.group; 0: alone
  std::array<double, kActivities> rates{};  ///< [1/min] of pedzone.activities
  const WaypointPath* path = nullptr;       ///< pedzone.path; null: none
};

inline constexpr std::string_view kHintKeys[] = {
    "pedzone.profile", "pedzone.aware", "pedzone.group", "pedzone.activities", "pedzone.path"};

/// What hints may refer to; outlives them.
struct HintContext {
  const Profiles& profiles;
  const std::vector<WaypointPath>& paths;
};

/// What is wrong with a value.
struct HintProblem {
  std::string problem, value, allowed;
};

/// Takes the value of one of the keys in; an empty one says nothing. Throws HintProblem.
void take_hint(std::string_view key, const std::string& value, const HintContext& context,
               PersonHints& hints);

/// Throws InputError for a <param> of a route or additional file of the scenario whose value means
/// nothing, or that makes a group of one.
void require_known_hints(const Scenario& scenario, const HintContext& context);

}  // namespace pedzone
