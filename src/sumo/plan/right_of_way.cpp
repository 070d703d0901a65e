#include "sumo/plan/right_of_way.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {
namespace {

constexpr double kFastWalk = 2.0;   // [m/s] assumed: nobody comes over a crossing faster
constexpr double kSlowest = 3.0;    // [m/s] assumed: a vehicle that is let through speeds up to it
constexpr double kBefore = 1.0;     // [s] assumed: left between the vehicle's rear and the person
constexpr double kPatience = 10.0;  // [s] assumed: drivers who have waited longer push in. Where
                                    // people wait for these, too, junctions lock (spider.py: 2.3
                                    // times plain SUMO's vehicle time instead of 1.7)
constexpr double kBeside = 0.5;     // [m] assumed: between the body and who has come past it

struct Meeting {
  double way = 0.0;     ///< [m] of the front to the crossing
  double across = 0.0;  ///< [m] along the crossing from its begin to the vehicle's way
};

bool gives_way_at(const FleetVehicle& vehicle, const Crosswalk& crosswalk) {
  if (crosswalk.priority) return true;
  return vehicle.gave_way < kPatience && is_among(crosswalk, vehicle.yields_at);
}

/// Nothing: the way does not lead over it, or the front is on it already.
std::optional<Meeting> meeting(const FleetVehicle& vehicle, const Crosswalk& crosswalk) {
  const auto over = way_over(vehicle.way, crosswalk);
  if (!over) return std::nullopt;
  const double front = vehicle.traits.length;  // the way begins at the rear
  const double way = over->way - front - 0.5 * crosswalk.width;
  if (way < 0.0) return std::nullopt;
  return Meeting{way, over->across};
}

/// Whether the person comes to the vehicle's way before the vehicle is over the crossing. Only on a
/// zebra crossing this holds for somebody who is about to enter it, too, as in SUMO.
bool comes_first(const FleetVehicle& vehicle, const PersonAhead& person, const Meeting& at) {
  const Crosswalk& crosswalk = *person.crosswalk;
  const Vec2 along = (crosswalk.end - crosswalk.begin).normalized();
  const double gone = (person.position - crosswalk.begin).dot(along), left = at.across - gone;
  if (gone < 0.0 && !crosswalk.priority) return false;
  const double room = 0.5 * vehicle.traits.width + person.radius + kBeside;
  if (left < -room) return false;  // has come past
  const double over =
      (at.way + crosswalk.width + vehicle.traits.length) / std::max(vehicle.speed, kSlowest);
  return (left - room) / kFastWalk < over + kBefore;
}

}  // namespace

std::optional<double> way_to_used_crosswalk(const FleetVehicle& vehicle,
                                            std::span<const PersonAhead> people, double distance) {
  std::optional<double> nearest;
  for (const PersonAhead& person : people) {
    if (!person.crosswalk || !gives_way_at(vehicle, *person.crosswalk)) continue;
    const auto at = meeting(vehicle, *person.crosswalk);
    if (!at || at->way > distance || (nearest && at->way >= *nearest)) continue;
    if (comes_first(vehicle, person, *at)) nearest = at->way;
  }
  return nearest;
}

}  // namespace pedzone
