#include "sumo/plan/junction_clearance.hpp"

#include <algorithm>
#include <vector>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kRecently = 5.0;  // [s] assumed: longer than anybody takes through a junction
constexpr double kDisc = 1.0;      // [m] numerical: between discs that stand for a body
// assumed: so far, of two inside, the way of the other is looked at.
constexpr double kForeseen = 2.0;  // [s]
constexpr double kWholeWay = 1e3;  // [s]
constexpr double kBetween = 0.5;   // [m] assumed: left between two
constexpr double kAtLine = 1.0;    // [m] assumed: one so far in is in nobody's way

bool was_told(const FleetVehicle& vehicle) {
  return vehicle.commanded >= 0.0 || vehicle.left_alone < kRecently;
}

bool stands(const FleetVehicle& vehicle) { return vehicle.speed < kHaltingSpeed; }

/// Whether it has not come so far into a junction that it would be in the way of others.
bool is_outside(const FleetVehicle& vehicle) { return vehicle.junction.begin > -kAtLine; }

/// Whether the vehicle has to let `other`, inside the same junction, go first.
bool goes_first(const FleetVehicle& other, const FleetVehicle& vehicle) {
  // One that stands by itself waits for somebody, and SUMO's vehicles mind it.
  if (is_outside(vehicle)) return !stands(other) || other.commanded >= 0.0;
  // Of two that are inside nobody waits for one that stands: they might for each other.
  if (stands(other) || stands(vehicle)) return !stands(other);
  if (other.junction.end == vehicle.junction.end) return other.id < vehicle.id;
  return other.junction.end < vehicle.junction.end;
}

/// Adds discs that cover the body, and where it gets to in the junction within `time` [s]; 0: the
/// body alone.
void add_discs(const FleetVehicle& vehicle, double time, std::vector<PersonAhead>& discs) {
  const double radius = 0.5 * vehicle.traits.width;
  const auto add = [&](const VehicleBody& body, const Vec2& velocity) {
    for (const Rectangle& part : body.parts()) {
      const Vec2 front = part.centre + part.axis * part.half.x();
      for (double back = radius; back < 2.0 * part.half.x(); back += kDisc) {
        discs.push_back({front - part.axis * back, velocity, radius, {}});
      }
    }
  };
  add(body_of(vehicle), vehicle.velocity);
  const double most = (vehicle.speed + 0.5 * vehicle.traits.accel * time) * time;
  const double way = std::min(most, vehicle.junction.end + radius);
  for (double ahead = kDisc; ahead < way; ahead += kDisc) {
    add(body_after(vehicle, ahead), Vec2::Zero());
  }
}

/// Whether the way of `other` is free of the body of `vehicle`: of two in each other's way both
/// would wait.
bool could_go_on(const FleetVehicle& other, const FleetVehicle& vehicle) {
  std::vector<PersonAhead> body;
  add_discs(vehicle, 0.0, body);
  return !first_in_way(other, body, 0.0, other.junction.end + other.traits.length);
}

}  // namespace

std::vector<const FleetVehicle*> in_junctions(std::span<const FleetVehicle> vehicles) {
  std::vector<const FleetVehicle*> inside;
  for (const FleetVehicle& vehicle : vehicles) {
    if (!is_outside(vehicle)) inside.push_back(&vehicle);
  }
  return inside;
}

std::optional<Obstruction> first_in_junction(const FleetVehicle& vehicle,
                                             std::span<const FleetVehicle* const> inside) {
  const double braking = braking_distance(vehicle);
  const double near = braking + vehicle.speed + vehicle.traits.length;
  if (vehicle.junction.junction < 0 || vehicle.junction.begin > near) return std::nullopt;
  const bool outside = is_outside(vehicle);
  std::vector<PersonAhead> discs;
  for (const FleetVehicle* const other : inside) {
    if (other == &vehicle || other->lane == vehicle.lane) continue;
    if (other->junction.junction != vehicle.junction.junction) continue;
    if (!was_told(vehicle) && !was_told(*other)) continue;
    if (goes_first(*other, vehicle)) {
      add_discs(*other, outside ? kWholeWay : kForeseen, discs);
    } else if (!outside && stands(*other) && could_go_on(*other, vehicle)) {
      add_discs(*other, 0.0, discs);
    }
  }
  if (discs.empty()) return std::nullopt;
  const double through = vehicle.junction.end + vehicle.traits.length;
  auto first = first_in_way(vehicle, discs, 0.0, outside ? through : near);
  if (!first) return std::nullopt;
  first->distance = std::max(0.0, first->distance - kBetween);
  // It comes in when it gets through, and else waits at the line, if it can stop there.
  const double line = vehicle.junction.begin;
  if (outside && line >= braking) first->distance = std::min(first->distance, line);
  return first;
}

}  // namespace pedzone
