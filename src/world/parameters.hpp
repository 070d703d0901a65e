// Every number that the user can set, once: value, unit, range, source. The README's table and
// the checks of the zone file are made from this list.
#pragma once

#include <span>
#include <string_view>

namespace pedzone {

/// Walking and yielding parameters. Defaults and ranges stand in parameter_list().
struct Parameters {
  double sight, field_of_view, candidate_field, relaxation_time, collision_time, hearing;
  double equation, waypoint_radius, patience, heading_noise, heading_noise_time;
  double wait_distance, wait_time, near_distance;
  double turned_width, turn_time, jam_time;
  double group_preferred_distance, group_maximum_distance;
  double vehicle_sight, discomfort, discomfort_margin, discomfort_margin_time, discomfort_horizon;
  double slowing_cost, hurry_cost, margin_spread, room_behind, letting_pass, meeting;
  double crossing_start_up, crossing_margin, crossing_margin_least, crossing_margin_time;
  double crossing_aversion, crossing_insists;
  double yield_gap, yield_margin, yield_horizon, creep_after, creep_speed, creep_gap;

  Parameters();  ///< the defaults of parameter_list()
};

/// One parameter, for tables, checks and `<param key="..." value="..."/>`.
struct ParameterInfo {
  std::string_view key;  ///< as in the zone file
  double Parameters::*member;
  double value, least, most;  ///< default and closed range, in `unit`
  std::string_view unit;
  std::string_view meaning;  ///< one line
  std::string_view source;   ///< paper and equation, data, or "assumed"
};

std::span<const ParameterInfo> parameter_list();

/// The entry of that key, or nullptr.
const ParameterInfo* find_parameter(std::string_view key);

}  // namespace pedzone
