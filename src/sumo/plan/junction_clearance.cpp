#include "sumo/plan/junction_clearance.hpp"

#include <algorithm>
#include <vector>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kRecently = 5.0;  // [s] assumed: longer than anybody takes through a junction
constexpr double kDisc = 1.0;      // [m] numerical: between discs that stand for a body
constexpr double kForeseen = 2.0;  // [s] assumed: so far the way of one inside is looked at

bool was_told(const FleetVehicle& vehicle) {
  return vehicle.commanded >= 0.0 || vehicle.left_alone < kRecently;
}

bool stands(const FleetVehicle& vehicle) { return vehicle.speed < kHaltingSpeed; }

/// Whether `other`, inside a junction, is in that of `vehicle`, which has to let it go first.
bool goes_first(const FleetVehicle& other, const FleetVehicle& vehicle) {
  if (other.junction.junction != vehicle.junction.junction) return false;
  if (other.lane == vehicle.lane) return false;
  if (vehicle.junction.begin > 0.0) return true;
  // Of two that are inside nobody waits for one that stands: they might for each other.
  if (stands(other) || stands(vehicle)) return !stands(other);
  if (other.junction.end == vehicle.junction.end) return other.id < vehicle.id;
  return other.junction.end < vehicle.junction.end;
}

/// Adds discs that cover the body, and where its front gets to in the junction.
void add_discs(const FleetVehicle& vehicle, std::vector<PersonAhead>& discs) {
  const double radius = 0.5 * vehicle.traits.width, length = vehicle.traits.length;
  for (double back = radius; back < length; back += kDisc) {
    discs.push_back({vehicle.front - unit(vehicle.heading) * back, vehicle.velocity, radius, {}});
  }
  const double most = (vehicle.speed + 0.5 * vehicle.traits.accel * kForeseen) * kForeseen;
  const double way = std::min(most, vehicle.junction.end + radius);
  for (double ahead = kDisc; ahead < way; ahead += kDisc) {
    const Rectangle body = body_after(vehicle, ahead);
    discs.push_back({body.centre + body.axis * (0.5 * length - radius), Vec2::Zero(), radius, {}});
  }
}

}  // namespace

std::vector<const FleetVehicle*> in_junctions(std::span<const FleetVehicle> vehicles) {
  std::vector<const FleetVehicle*> inside;
  for (const FleetVehicle& vehicle : vehicles) {
    if (!is_in_junction(vehicle)) continue;
    // One that stands by itself waits for somebody, and SUMO's vehicles mind it.
    if (!stands(vehicle) || vehicle.commanded >= 0.0) inside.push_back(&vehicle);
  }
  return inside;
}

std::optional<Obstruction> first_in_junction(const FleetVehicle& vehicle,
                                             std::span<const FleetVehicle* const> inside) {
  const double reach = braking_distance(vehicle) + vehicle.speed + vehicle.traits.length;
  if (vehicle.junction.junction < 0 || vehicle.junction.begin > reach) return std::nullopt;
  std::vector<PersonAhead> discs;
  for (const FleetVehicle* const other : inside) {
    if (other == &vehicle || !goes_first(*other, vehicle)) continue;
    if (was_told(vehicle) || was_told(*other)) add_discs(*other, discs);
  }
  if (discs.empty()) return std::nullopt;
  return first_in_way(vehicle, discs, 0.0, reach);
}

}  // namespace pedzone
