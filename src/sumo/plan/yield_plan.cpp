#include "sumo/plan/yield_plan.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "sumo/plan/late_braking.hpp"
#include "sumo/plan/right_of_way.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kMoment = 1.0;       // [s] assumed: a driver expects people to walk on so long
constexpr double kWalksThere = 60.0;  // [m] numerical: nobody comes from farther meanwhile, nor
                                      // over a longer crossing
constexpr double kSample = 0.25;      // [m] numerical: sampling of the swept area
constexpr double kCleared = 2.0;      // [m/s] numerical: faster than this a jam is over
constexpr double kClaimAfter =
    2.0;                        // [s] assumed: slowed for so long, a vehicle asks people for room
constexpr double kClaim = 8.0;  // [m] recorded onset of avoidance, median
constexpr double kDriveOff = 3.0;      // [s] assumed: people leave it the room for so long at most
constexpr double kHasDrivenOff = 0.5;  // assumed: at this share of what it may drive it has
constexpr double kObeyed = 0.05;  // [m/s] numerical: slower than told by more, traffic holds it
constexpr double kEase = 5.0;     // [m/s³] assumed: from braking to driving off in less than 1.5 s
constexpr double kTouch = 0.01;   // [m] numerical
constexpr double kEdgesPastAfter = 60.0;  // [s] assumed: three times creepAfter's default
constexpr double kFreeAhead = 1.0;        // [m] assumed: it stops for who steps before it meanwhile
constexpr double kCreepMargin = 0.05;     // [m] numerical: a creeping vehicle passes people close

/// Whether the body comes within `margin` of a person when its front has gone `travelled`.
bool touches(const FleetVehicle& vehicle, double travelled, const Vec2& person, double reach) {
  return body_after(vehicle, travelled).signed_distance(person) < reach;
}

/// [m] just before the body touches that person, which it does at `travelled` and not a sample ago.
double last_clear(const FleetVehicle& vehicle, double travelled, const Vec2& person, double reach) {
  double clear = travelled - kSample;
  for (double half = 0.5 * kSample; half > kTouch; half *= 0.5) {
    if (!touches(vehicle, clear + half, person, reach)) clear += half;
  }
  return clear;
}

/// How far the front may go before the body touches a disc of `reach` [m] round a point; nothing
/// when it does not within `distance`. `cut` [m]: by which the body leaves its front's way at most.
std::optional<double> contact_distance(const FleetVehicle& vehicle, double cut, const Vec2& point,
                                       double reach, double distance) {
  // Where the chord of its way is short, in a sharp bend, the rear hangs over behind it.
  const double widest = std::max(0.0, 0.5 * vehicle.traits.width + reach + 2.0 * cut);
  const auto near = stretch_within(vehicle.way, point, widest);
  if (!near) return std::nullopt;
  const double begin = std::max(0.0, near->first - vehicle.traits.length);
  const double end = std::min(distance, near->last);
  for (double travelled = begin; travelled <= end + kSample; travelled += kSample) {
    if (touches(vehicle, travelled, point, reach))
      return travelled > begin ? last_clear(vehicle, travelled, point, reach) : begin;
  }
  return std::nullopt;
}

/// [m] from the front to where it must come to have its rear out of the junction, and room before
/// somebody there.
double room_behind(const FleetVehicle& vehicle, double keep) {
  return vehicle.junction.end + vehicle.traits.length + keep;
}

/// Whether it stays out of a junction since people would make it stand there, in the way of other
/// vehicles. SUMO's vehicles take it for granted that whoever enters gets through: they run into
/// one that does not. No longer so once it creeps, and not where it could not stop in comfort.
bool waits_before_junction(const FleetVehicle& vehicle, const Obstruction& ahead, double keep) {
  const double begin = vehicle.junction.begin;
  if (!vehicle.junction.shared || vehicle.creeping || begin <= 0.0) return false;
  if (vehicle.speed * vehicle.speed > 2.0 * vehicle.traits.decel * begin) return false;
  return ahead.distance > begin && ahead.distance < room_behind(vehicle, keep);
}

/// [m/s] before that one.
double safe_speed(const FleetVehicle& vehicle, const Obstruction& ahead,
                  const Parameters& parameters, const SafeSpeeds& safe_speeds, double dt) {
  const double keep = vehicle.creeping ? parameters.creep_gap : parameters.yield_gap;
  // Who comes towards it is nearer by then: in a step of 1 s by as much as it keeps.
  const double comes = std::max(0.0, -ahead.speed) * dt;
  const double gap = std::max(0.0, ahead.distance - keep - comes);
  double safe = safe_speeds.before(vehicle, ahead, gap);
  if (waits_before_junction(vehicle, ahead, keep)) {
    safe = std::min(safe, safe_speeds.stop(vehicle, vehicle.junction.begin));
  }
  if (vehicle.creeping) {
    // What is left to the person must be left after the step, too.
    safe = std::min({std::max(safe, ahead.distance > keep ? parameters.creep_speed : 0.0),
                     parameters.creep_speed, gap / std::max(dt, 1e-3)});
  }
  return std::max(0.0, safe);
}

/// [m] how far a vehicle looks for people: as far as it needs to stop, and farther; where it comes
/// to a junction, as far as it must go to be out of it again.
double look_ahead(const FleetVehicle& vehicle, const Parameters& parameters) {
  const double usual = braking_distance(vehicle) + vehicle.speed + parameters.yield_horizon;
  if (!vehicle.junction.shared || vehicle.junction.begin > usual) return usual;
  return std::max(usual, room_behind(vehicle, parameters.yield_gap));
}

/// Whether something else than what it was told makes it slow.
bool is_held_by_traffic(const FleetVehicle& vehicle) {
  return vehicle.commanded >= 0.0 && vehicle.commanded > vehicle.speed + kObeyed;
}

bool has_driven_off(const FleetVehicle& vehicle) {
  return vehicle.speed >= std::min(kCleared, kHasDrivenOff * vehicle.allowed_speed);
}

/// Whether it has claimed room, and has not yet driven off into it.
bool drives_off(const FleetVehicle& vehicle) {
  return vehicle.slowed > kClaimAfter && !has_driven_off(vehicle) && !is_held_by_traffic(vehicle);
}

/// After people have held it: it is let go step by step. Until it has driven off it claims the room
/// that they made, for no longer than it took them: they would step in again before it, and hold it
/// up as before.
std::optional<YieldOrder> let_go(FleetVehicle& vehicle, double dt) {
  if (drives_off(vehicle)) {
    vehicle.slowed = std::min(vehicle.slowed, kClaimAfter + kDriveOff) - dt;
    vehicle.claim = kClaim;
    return comfortable_order(vehicle, vehicle.allowed_speed, dt);
  }
  vehicle.slowed = 0.0;
  if (vehicle.commanded < 0.0 || vehicle.pull + kEase * dt >= vehicle.traits.accel) return {};
  return comfortable_order(vehicle, vehicle.allowed_speed, dt);
}

/// Before a crossing that people use, and at which it gives way: it waits, and claims nothing,
/// where it can in comfort. Behind a junction that others use, too, it waits before that, in
/// nobody's way.
std::optional<YieldOrder> give_way(FleetVehicle& vehicle, double way, const SafeSpeeds& safe_speeds,
                                   double dt) {
  const double needs = stopping_distance(vehicle, dt), begin = vehicle.junction.begin;
  if (needs > way + kSample) return std::nullopt;
  const bool inside = way > begin && way < room_behind(vehicle, 0.0);
  if (vehicle.junction.shared && inside && begin > 0.0 && needs <= begin + kSample) way = begin;
  const double safe = safe_speeds.stop(vehicle, way);
  vehicle.creeping = false;
  vehicle.blocked_time = vehicle.slowed = 0.0;
  return comfortable_order(vehicle, std::min(safe, vehicle.allowed_speed), dt);
}

/// How a vehicle passes people who have stepped aside.
struct Pass {
  BodyWidth width;
  double most;  ///< [m/s]
};

/// [m/s] past people who have stepped aside where there is little room. Whom the body would touch,
/// or nearly so, it stops for all the same.
double speed_beside(const FleetVehicle& vehicle, std::span<const PersonAhead> people,
                    const Obstruction& ahead, double distance, const Pass& pass,
                    const Parameters& parameters, const SafeSpeeds& safe_speeds, double dt) {
  const auto close = first_in_way(vehicle, people, kCreepMargin, distance, pass.width);
  if (close && close->distance <= ahead.distance) return 0.0;
  const double safe = close ? safe_speed(vehicle, *close, parameters, safe_speeds, dt) : pass.most;
  return std::min(safe, pass.most);
}

/// Whether the front of a vehicle, whose body that is, is past the point.
bool is_past(const FleetVehicle& vehicle, const VehicleBody& body, const Vec2& point) {
  return (point - vehicle.front).dot(body.first().axis) < 0.0;
}

/// Whether it stands or creeps, and somebody is beside its body, nearer than one could be who has
/// not turned its shoulders.
bool is_squeezed_past(const FleetVehicle& vehicle, std::span<const PersonAhead> people) {
  if (!lets_squeeze_past(vehicle.speed)) return false;
  const VehicleBody body = body_of(vehicle);
  return std::ranges::any_of(people, [&](const PersonAhead& person) {
    return body.signed_distance(person.position) < person.radius &&
           is_past(vehicle, body, person.position);
  });
}

/// Whether nobody it stands for is before it, and it has stood for very long: who is beside it,
/// where it is about to turn, has nowhere to go. It goes on, no faster than people are squeezed
/// past: they get out of its way as it comes.
bool edges_past(const FleetVehicle& vehicle, std::span<const PersonAhead> people) {
  if (!vehicle.creeping || vehicle.blocked_time < kEdgesPastAfter) return false;
  const VehicleBody body = body_of(vehicle);
  std::vector<PersonAhead> before;
  std::ranges::copy_if(people, std::back_inserter(before), [&](const PersonAhead& person) {
    return !is_past(vehicle, body, person.position);
  });
  return !first_in_way(vehicle, before, kCreepMargin, kFreeAhead);
}

}  // namespace

double reach_for_people(const FleetVehicle& vehicle, const Parameters& parameters) {
  return look_ahead(vehicle, parameters) + vehicle.traits.length + kWalksThere;
}

double SafeSpeeds::before(const FleetVehicle& vehicle, const Obstruction& ahead, double gap) const {
  return ahead.speed > kHaltingSpeed ? follow(vehicle, gap, ahead.speed) : stop(vehicle, gap);
}

YieldOrder comfortable_order(FleetVehicle& vehicle, double safe, double dt) {
  const VehicleTraits& traits = vehicle.traits;
  const double eased = vehicle.commanded < 0.0 ? traits.accel : vehicle.pull + kEase * dt;
  const double most = vehicle.speed + std::min(eased, traits.accel) * dt;
  const double least = speed_if_braked(vehicle, dt);
  const double speed = std::max(least, std::min(safe, most));
  vehicle.pull = dt > 0.0 ? (speed - vehicle.speed) / dt : 0.0;
  return {speed, false};
}

std::optional<Obstruction> first_in_way(const FleetVehicle& vehicle,
                                        std::span<const PersonAhead> people, double margin,
                                        double distance, BodyWidth width) {
  if (!goes_on(vehicle)) return std::nullopt;
  const VehicleBody body = body_of(vehicle);
  std::optional<Obstruction> first;
  const double range = distance + vehicle.traits.length + 2.0;
  const double cut =
      most_cut(vehicle.way, longest_part(vehicle.traits.parts, vehicle.traits.length));
  const auto contact_with = [&](const Vec2& point, double reach) {
    return contact_distance(vehicle, cut, point, reach, distance);
  };
  for (const PersonAhead& person : people) {
    if ((person.position - vehicle.front).norm() > range) continue;
    const double radius =
        width == BodyWidth::kStraight ? person.radius : person.radius - person.narrower;
    const Vec2 soon = person.position + person.velocity * kMoment;
    // Only who is in the way or about to step into it: a person that stands beside is passed.
    auto contact = contact_with(person.position, radius + margin);
    const auto later = contact_with(soon, radius + margin);
    if (!contact && later && (soon - person.position).norm() > kSample) contact = later;
    if (!contact) continue;
    // Beside the body already and not before it: passed, unless the rear will swing over them.
    // Who has turned its shoulders and squeezes past is nearer than its disc: no nearer then.
    const double beside = body.signed_distance(person.position) - kTouch;
    if (is_past(vehicle, body, person.position) &&
        !contact_with(person.position, std::min(radius, beside))) {
      continue;
    }
    const double allowed = std::max(0.0, *contact);
    if (first && first->distance <= allowed) continue;
    const LineProjection at = project_on(vehicle.way, person.position);
    first = Obstruction{allowed, person.velocity.dot(point_on(vehicle.way, at.offset).direction)};
  }
  return first;
}

std::optional<YieldOrder> plan_yield(FleetVehicle& vehicle, std::span<const PersonAhead> people,
                                     const Parameters& parameters, const SafeSpeeds& safe_speeds,
                                     double dt) {
  vehicle.claim = 0.0;
  if (has_driven_off(vehicle)) vehicle.gave_way = 0.0;
  const double distance = look_ahead(vehicle, parameters);
  const auto ahead = first_in_way(
      vehicle, people, vehicle.creeping ? kCreepMargin : parameters.yield_margin, distance);
  const auto crosswalk = way_to_used_crosswalk(vehicle, people, distance);
  if (crosswalk && (!ahead || *crosswalk <= ahead->distance)) {
    if (const auto order = give_way(vehicle, *crosswalk, safe_speeds, dt)) {
      if (vehicle.speed < kHaltingSpeed) vehicle.gave_way += dt;
      return order;
    }
  }
  const double most = is_squeezed_past(vehicle, people) ? kSqueezeSpeed : vehicle.allowed_speed;
  if (!ahead) {
    vehicle.creeping = false;
    vehicle.blocked_time = 0.0;
    if (most >= vehicle.allowed_speed) return let_go(vehicle, dt);
    return comfortable_order(vehicle, most, dt);
  }
  const bool by_traffic = is_held_by_traffic(vehicle);
  const bool by_people = vehicle.commanded >= 0.0 && !by_traffic;
  if (by_people && vehicle.speed < kHaltingSpeed) vehicle.blocked_time += dt;
  if (vehicle.speed > kCleared) vehicle.blocked_time = 0.0;
  vehicle.creeping = vehicle.blocked_time >= parameters.creep_after;
  double safe = safe_speed(vehicle, *ahead, parameters, safe_speeds, dt);
  // One that stays out of a junction would not use the room that it claims: people beside it would
  // wait for it while it waits for them.
  const bool stays_out = waits_before_junction(vehicle, *ahead, parameters.yield_gap);
  if (vehicle.slowed > kClaimAfter && !stays_out) {
    for (const Pass& pass : {Pass{BodyWidth::kStraight, parameters.creep_speed},
                             Pass{BodyWidth::kAsHeld, kSqueezeSpeed}}) {
      if (safe >= pass.most) continue;
      safe = std::max(
          safe, speed_beside(vehicle, people, *ahead, distance, pass, parameters, safe_speeds, dt));
    }
  }
  if (edges_past(vehicle, people)) safe = std::max(safe, kSqueezeSpeed);
  safe = std::min(safe, most);
  if (safe >= vehicle.allowed_speed) return let_go(vehicle, dt);
  // People who made room for one that traffic holds would wait for nothing, and for each other.
  vehicle.slowed = by_traffic ? 0.0 : vehicle.slowed + dt;
  if (vehicle.slowed > kClaimAfter && !stays_out) vehicle.claim = kClaim;
  if (safe < speed_if_braked(vehicle, dt)) {
    const double needed = needed_deceleration(vehicle, people, dt);
    if (needed > vehicle.traits.decel) {
      vehicle.pull = -needed;
      return YieldOrder{std::max(0.0, vehicle.speed - needed * dt), true};
    }
  }
  return comfortable_order(vehicle, safe, dt);
}

}  // namespace pedzone
