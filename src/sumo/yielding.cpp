#include "sumo/yielding.hpp"

#include <algorithm>

#include "sumo/api.hpp"

namespace pedzone {
namespace {

constexpr double kMoment = 1.0;        // [s] assumed: a driver expects people to walk on so long
constexpr double kSample = 0.25;       // [m] numerical: sampling of the swept area
constexpr double kStanding = 0.1;      // [m/s] SUMO's own threshold for waiting
constexpr double kPersonDecel = 5.0;   // [m/s²] assumed: a walker stops within half a metre
constexpr double kCleared = 2.0;       // [m/s] numerical: faster than this a jam is over
constexpr double kCourtesy = 2.0;      // [s] assumed: people ask no room of themselves for so long
constexpr double kClaim = 8.0;         // [m] recorded onset of avoidance, median
constexpr double kCreepMargin = 0.05;  // [m] numerical: a creeping vehicle passes people close
constexpr int kSpeedModeDefault = 31;  // SUMO: all checks
constexpr int kSpeedModeEmergency = 27;  // the same without the bound of comfortable braking

/// Whether the body comes within `margin` of a person when its front has gone `travelled`.
bool touches(const FleetVehicle& vehicle, double travelled, const Vec2& person, double reach) {
  return body_after(vehicle, travelled).distance(person) < reach;
}

/// How far the front may go before the body touches a disc of `reach` [m] round a point; nothing
/// when it does not within `distance`.
std::optional<double> contact_distance(const FleetVehicle& vehicle, const Vec2& point, double reach,
                                       double distance) {
  const double length = vehicle.traits.length;
  const LineProjection at = project_on(vehicle.way, point);
  // A corner-cutting body leaves its front's way by less than this.
  const double sideways = 0.5 * vehicle.traits.width + reach + 1.0;
  if (std::abs(at.lateral) > sideways) return std::nullopt;
  double begin = std::max(0.0, at.offset - length - reach - kSample);
  if (begin > distance) return std::nullopt;
  const double end = std::min(distance, at.offset + reach);
  for (double travelled = begin; travelled <= end + kSample; travelled += kSample) {
    if (touches(vehicle, travelled, point, reach)) return std::max(0.0, travelled - kSample);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Obstruction> first_in_way(const FleetVehicle& vehicle,
                                        std::span<const PersonAhead> people, double margin,
                                        double distance) {
  if (vehicle.way.size() < 3) return std::nullopt;
  const Body body = body_of(vehicle);
  std::optional<Obstruction> first;
  const double range = distance + vehicle.traits.length + 2.0;
  for (const PersonAhead& person : people) {
    if ((person.position - vehicle.front).norm() > range) continue;
    const Vec2 soon = person.position + person.velocity * kMoment;
    // Only who is in the way or about to step into it: a person that stands beside is passed.
    auto contact = contact_distance(vehicle, person.position, person.radius + margin, distance);
    const auto later = contact_distance(vehicle, soon, person.radius + margin, distance);
    if (!contact && later && (soon - person.position).norm() > kSample) contact = later;
    if (!contact) continue;
    const double clearance = body.distance(person.position) - person.radius;
    // Beside the body already and not before it: driving on does not bring them closer.
    const Vec2 to = person.position - vehicle.front;
    if (to.dot(unit(vehicle.heading)) < 0.0 && clearance > 0.0 &&
        !touches(vehicle, *contact + 2.0 * kSample, person.position, person.radius)) {
      continue;
    }
    const double allowed = std::max(0.0, *contact);
    if (first && first->distance <= allowed) continue;
    const LineProjection at = project_on(vehicle.way, person.position);
    first = Obstruction{allowed, person.velocity.dot(point_on(vehicle.way, at.offset).direction),
                        clearance};
  }
  return first;
}

double Yielding::safe_speed(const FleetVehicle& vehicle, const Obstruction& ahead,
                            double dt) const {
  const Parameters& parameters = zones_[vehicle.zone].parameters;
  const double keep = vehicle.creeping ? parameters.creep_gap : parameters.yield_gap;
  const double gap = std::max(0.0, ahead.distance - keep);
  double safe =
      ahead.speed > kStanding
          ? api::Vehicle::getFollowSpeed(vehicle.id, vehicle.speed, gap, ahead.speed, kPersonDecel)
          : api::Vehicle::getStopSpeed(vehicle.id, vehicle.speed, gap);
  if (vehicle.creeping) {
    // What is left to the person must be left after the step, too.
    safe = std::min({std::max(safe, ahead.distance > keep ? parameters.creep_speed : 0.0),
                     parameters.creep_speed, gap / std::max(dt, 1e-3)});
  }
  return std::max(0.0, safe);
}

void Yielding::command(FleetVehicle& vehicle, double speed, bool emergency) {
  if (emergency && in_emergency_.insert(vehicle.id).second) {
    api::Vehicle::setSpeedMode(vehicle.id, kSpeedModeEmergency);
  } else if (!emergency && in_emergency_.erase(vehicle.id) > 0) {
    api::Vehicle::setSpeedMode(vehicle.id, kSpeedModeDefault);
  }
  api::Vehicle::setSpeed(vehicle.id, speed);
  vehicle.commanded = speed;
  held_.insert(vehicle.id);
}

void Yielding::give_back(FleetVehicle& vehicle) {
  vehicle.commanded = -1.0;
  if (held_.erase(vehicle.id) == 0) return;
  api::Vehicle::setSpeed(vehicle.id, -1.0);
  if (in_emergency_.erase(vehicle.id) > 0) {
    api::Vehicle::setSpeedMode(vehicle.id, kSpeedModeDefault);
  }
}

void Yielding::yield(FleetVehicle& vehicle, std::span<const PersonAhead> people, double dt) {
  const Parameters& parameters = zones_[vehicle.zone].parameters;
  vehicle.claim = 0.0;
  const double braking = vehicle.speed * vehicle.speed / (2.0 * vehicle.traits.decel);
  const auto ahead =
      first_in_way(vehicle, people, vehicle.creeping ? kCreepMargin : parameters.yield_margin,
                   braking + vehicle.speed + parameters.yield_horizon);
  if (!ahead) {
    vehicle.creeping = false;
    vehicle.held_up = vehicle.slowed = 0.0;
    give_back(vehicle);
    return;
  }
  const bool held = vehicle.commanded >= 0.0;
  if (held && vehicle.speed < kStanding) vehicle.held_up += dt;
  if (vehicle.speed > kCleared) vehicle.held_up = 0.0;
  vehicle.creeping = vehicle.held_up >= parameters.creep_after;
  const double safe = safe_speed(vehicle, *ahead, dt);
  if (safe >= vehicle.allowed_speed) {
    vehicle.slowed = 0.0;
    give_back(vehicle);
    return;
  }
  vehicle.slowed += dt;
  if (vehicle.slowed > kCourtesy) vehicle.claim = kClaim;
  const double comfortable = std::max(0.0, vehicle.speed - vehicle.traits.decel * dt);
  const bool emergency = safe < comfortable && vehicle.speed * vehicle.speed >
                                                   2.0 * vehicle.traits.decel * ahead->distance;
  command(vehicle,
          emergency ? std::max(0.0, vehicle.speed - vehicle.traits.emergency_decel * dt) : safe,
          emergency);
  yielded_.insert(vehicle.id);
}

void Yielding::apply(Fleet& fleet, std::span<const PersonAhead> people, double dt) {
  for (FleetVehicle& vehicle : fleet.vehicles()) {
    if (!vehicle.traits.yields || vehicle.traits.external || vehicle.stopped) {
      if (!vehicle.traits.external) give_back(vehicle);
      continue;
    }
    yield(vehicle, people, dt);
  }
}

}  // namespace pedzone
