#include "sumo/plan/vehicle.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {
namespace {

constexpr double kRounding = 1e-3;  // [m] numerical
constexpr double kChord = 0.1;      // [m] numerical: a shorter one has no direction

/// A part of `length` [m] with its rear at `rear` [m] of the vehicle's way.
Rectangle part_on_way(const FleetVehicle& vehicle, double rear, double length) {
  const Vec2 front = point_on(vehicle.way, rear + length).point;
  const Vec2 along = front - point_on(vehicle.way, rear).point;
  const double chord = along.norm();
  const Vec2 axis = chord > kChord ? Vec2(along / chord) : unit(vehicle.heading);
  return {front - axis * (0.5 * length), axis, {0.5 * length, 0.5 * vehicle.traits.width}};
}

}  // namespace

bool gives_way(const FleetVehicle& vehicle) {
  return vehicle.traits.yields && !vehicle.traits.external && !vehicle.stopped;
}

double braking_distance(const FleetVehicle& vehicle) {
  return vehicle.speed * vehicle.speed / (2.0 * vehicle.traits.decel);
}

double stopping_distance(const FleetVehicle& vehicle, double dt) {
  const double first = vehicle.traits.ballistic ? 0.0 : 0.5 * vehicle.speed * dt;
  return std::max(0.0, braking_distance(vehicle) - first);
}

double speed_if_braked(const FleetVehicle& vehicle, double dt) {
  return std::max(0.0, vehicle.speed - vehicle.traits.decel * dt);
}

double speed_within(const VehicleTraits& traits, double before, double after, double share) {
  return traits.ballistic ? std::lerp(before, after, share) : after;
}

bool is_in_junction(const FleetVehicle& vehicle) {
  return vehicle.junction.junction >= 0 && vehicle.junction.begin <= 0.0;
}

bool goes_on(const FleetVehicle& vehicle) {
  return length_of(vehicle.way) > vehicle.traits.length + kRounding;
}

bool came_from_ahead(const FleetVehicle& vehicle, const Vec2& front_before) {
  if (!goes_on(vehicle)) return false;
  const LineProjection at = project_on(vehicle.way, front_before);
  // Who drives fast towards a place to turn round in was nearest to the lane that leads back.
  const bool on_way = std::abs(at.lateral) < 0.5 * vehicle.traits.width;
  return on_way && at.offset > vehicle.traits.length + kShortMove;
}

VehicleBody body_of(const FleetVehicle& vehicle) { return body_after(vehicle, 0.0); }

VehicleBody body_after(const FleetVehicle& vehicle, double travelled) {
  const VehicleTraits& traits = vehicle.traits;
  const bool bends = traits.parts.bends();
  VehicleBody body;
  if (vehicle.way.size() < 2 || (travelled <= 0.0 && !bends)) {
    body.add({vehicle.centre(), unit(vehicle.heading), {0.5 * traits.length, 0.5 * traits.width}});
    return body;
  }
  for (int k = 0; k < traits.parts.count(); ++k) {
    const VehiclePart part = part_of(traits.parts, traits.length, k);
    body.add(part_on_way(vehicle, std::max(0.0, travelled) + part.rear, part.length));
  }
  return body;
}

}  // namespace pedzone
