#include "sumo/plan/yielding.hpp"

#include <algorithm>
#include <cmath>

#include "sumo/plan/junction_clearance.hpp"
#include "sumo/plan/lane_end.hpp"
#include "sumo/plan/late_braking.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kStandsAfter = 5.0;    // [s] assumed: a driver looks after whom it has run into
constexpr double kLongestAtEnd = 30.0;  // [s] assumed: then it goes on, whoever else comes
constexpr double kNobodyComes = 1.0;    // [s] numerical: nobody comes any more
constexpr double kStopsIn = 5.0;        // [s] assumed: so long those behind take to stop
constexpr double kOnce = 1.0;           // [s] numerical: braking again so soon is the same braking

/// Towards a speed that is `safe` [m/s], where that is less than what is planned for the vehicle or
/// than it may reach by itself.
void slow_to(double safe, FleetVehicle& vehicle, double dt, std::optional<YieldOrder>& planned) {
  if (safe < (planned ? planned->speed : vehicle.speed + vehicle.traits.accel * dt)) {
    planned = comfortable_order(vehicle, safe, dt);
  }
}

}  // namespace

/// Nothing where the vehicle has run into nobody, or has stood for long enough since.
std::optional<YieldOrder> Yielding::plan_stop(FleetVehicle& vehicle, double dt) {
  const auto found = stopping_.find(vehicle.id);
  if (found == stopping_.end()) return std::nullopt;
  double& stood = found->second;
  if (vehicle.speed <= kHaltingSpeed) stood += dt;
  if (stood > kStandsAfter) {
    stopping_.erase(found);
    vehicle.commanded = kOwnSpeed;  // nobody in its way holds it
    return std::nullopt;
  }
  const double next = std::max(0.0, vehicle.speed - vehicle.traits.emergency_decel * dt);
  return YieldOrder{next, true};
}

/// One at a stop of its own on the road may drive off in the next step, whenever SUMO ends the
/// stop: it stands for whom it would reach then. Nothing where that is nobody.
std::optional<YieldOrder> Yielding::plan_start(FleetVehicle& vehicle, const PeopleNear& near,
                                               double dt) const {
  const VehicleTraits& traits = vehicle.traits;
  vehicle.claim = vehicle.blocked_time = vehicle.slowed = 0.0;
  vehicle.creeping = false;
  const bool passes = vehicle.speed > kHaltingSpeed;  // it does not have to stand at its stop
  if (!traits.yields || traits.external || passes) return std::nullopt;
  const Parameters& parameters = zones_[vehicle.zone].parameters;
  const double way = traits.accel * dt * dt + parameters.yield_gap;
  const auto people = near.at(vehicle.front, traits.length + way);
  if (!first_in_way(vehicle, people, parameters.yield_margin, way)) return std::nullopt;
  return YieldOrder{};
}

/// Slows those that would run into another in a junction, since one of them was held by people.
void Yielding::keep_junctions_clear(std::span<FleetVehicle> vehicles, const SafeSpeeds& safe_speeds,
                                    double dt, std::vector<std::optional<YieldOrder>>& planned) {
  const std::vector<const FleetVehicle*> inside = in_junctions(vehicles);
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    FleetVehicle& vehicle = vehicles[i];
    if (!gives_way(vehicle) || (planned[i] && planned[i]->emergency)) continue;
    const auto ahead = first_in_junction(vehicle, inside);
    if (!ahead) continue;
    const double safe = safe_speeds.before(vehicle, *ahead, ahead->distance);
    slow_to(safe, vehicle, dt, planned[i]);
  }
}

/// Whether the vehicle leaves room at its lane's end for who comes into the zone or leaves it
/// there: where it could stop in comfort when somebody came, until nobody comes any more, or it has
/// stood for long.
bool Yielding::leaves_room(const FleetVehicle& vehicle, std::span<const PersonAhead> people,
                           std::span<const PersonAhead> outside, double dt) {
  if (!gives_way(vehicle) || std::isinf(vehicle.tight_end)) {
    at_end_.erase(vehicle.id);
    return false;
  }
  const bool comes = comes_in(vehicle, outside) || goes_out(vehicle, people);
  const auto found = at_end_.find(vehicle.id);
  if (found == at_end_.end()) {
    if (!comes || way_to_room(vehicle) < braking_distance(vehicle) + vehicle.speed * dt) {
      return false;
    }
    at_end_[vehicle.id] = {};
    return true;
  }
  StandsAtEnd& one = found->second;
  if (vehicle.speed < kHaltingSpeed) one.stood += dt;
  one.alone = comes ? 0.0 : one.alone + dt;
  if (one.alone <= kNobodyComes) return one.stood <= kLongestAtEnd;
  at_end_.erase(found);
  return false;
}

/// Stops those that would keep SUMO's people out of the zone, or in it.
void Yielding::keep_lane_ends_free(std::span<FleetVehicle> vehicles,
                                   std::span<const PersonAhead> people,
                                   std::span<const PersonAhead> outside,
                                   const SafeSpeeds& safe_speeds, double dt,
                                   std::vector<std::optional<YieldOrder>>& planned) {
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    FleetVehicle& vehicle = vehicles[i];
    if (!leaves_room(vehicle, people, outside, dt) || (planned[i] && planned[i]->emergency))
      continue;
    const double safe = safe_speeds.stop(vehicle, std::max(0.0, way_to_room(vehicle)));
    slow_to(safe, vehicle, dt, planned[i]);
  }
}

/// Whether it brakes harder than it likes to, or did so shortly ago that those behind may still be
/// driving.
bool Yielding::braked_just_now(const FleetVehicle& vehicle, double time) const {
  if (stopping_.contains(vehicle.id)) return true;
  const auto found = braked_late_.find(vehicle.id);
  return found != braked_late_.end() && time <= found->second + kStopsIn;
}

/// Slows those behind one that brakes late, and those behind them: SUMO's vehicles keep a distance
/// that is enough if nobody brakes harder than it likes to.
void Yielding::keep_behind_late_brakers(std::span<FleetVehicle> vehicles,
                                        const SafeSpeeds& safe_speeds, double time, double dt,
                                        std::vector<std::optional<YieldOrder>>& planned) {
  for (bool found = true; found;) {
    found = false;
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
      FleetVehicle& vehicle = vehicles[i];
      if (!gives_way(vehicle) || !vehicle.leader || (planned[i] && planned[i]->emergency)) continue;
      const FleetVehicle& leader = vehicles[vehicle.leader->index];
      if (!braked_just_now(leader, time)) continue;
      const auto& order = planned[vehicle.leader->index];
      const double next = order ? order->speed : speed_if_braked(leader, dt),
                   gap = vehicle.leader->gap;
      const double needed = needed_deceleration_behind(vehicle, gap, leader.traits, next, dt);
      if (needed > vehicle.traits.decel) {
        vehicle.pull = -needed;
        planned[i] = YieldOrder{std::max(0.0, vehicle.speed - needed * dt), true};
        note(vehicle, time);
        found = true;
      } else if (order && order->emergency) {
        // SUMO takes the leader to brake as it likes to, and might let this one speed up.
        const double room = std::max(0.0, gap - vehicle.traits.min_gap);
        slow_to(safe_speeds.follow(vehicle, room, next), vehicle, dt, planned[i]);
      }
    }
  }
}

void Yielding::command(FleetVehicle& vehicle, const YieldOrder& order,
                       std::vector<SpeedOrder>& out) {
  if (order.emergency && in_emergency_.insert(vehicle.id).second) {
    out.push_back({vehicle.id, SpeedMode::kEmergency});
  } else if (!order.emergency && in_emergency_.erase(vehicle.id) > 0) {
    out.push_back({vehicle.id, SpeedMode::kOwn});
  }
  out.push_back({vehicle.id, order.speed});
  vehicle.commanded = order.speed;
  commanded_.insert(vehicle.id);
}

void Yielding::give_back(FleetVehicle& vehicle, std::vector<SpeedOrder>& out) {
  vehicle.commanded = kOwnSpeed;
  if (commanded_.erase(vehicle.id) == 0) return;
  out.push_back({vehicle.id, kOwnSpeed});
  if (in_emergency_.erase(vehicle.id) > 0) out.push_back({vehicle.id, SpeedMode::kOwn});
}

void Yielding::note(const FleetVehicle& vehicle, double time) {
  const auto [last, is_new] = braked_late_.try_emplace(vehicle.id, time);
  if (is_new || time > last->second + kOnce) {
    late_brakings_.push_back({time, vehicle.id, vehicle.front, -vehicle.pull});
  }
  last->second = time;
}

/// For the people in its way; nothing: none of them holds it.
std::optional<YieldOrder> Yielding::plan_for_people(FleetVehicle& vehicle, const PeopleNear& near,
                                                    const SafeSpeeds& safe_speeds, double time,
                                                    double dt) {
  if (vehicle.stopped && !vehicle.parks) return plan_start(vehicle, near, dt);
  if (!gives_way(vehicle)) return std::nullopt;
  const Parameters& parameters = zones_[vehicle.zone].parameters;
  const auto people = near.at(vehicle.front, reach_for_people(vehicle, parameters));
  const auto order = plan_yield(vehicle, people, parameters, safe_speeds, dt);
  if (order && order->emergency) note(vehicle, time);
  if (order) yielded_.insert(vehicle.id);
  return order;
}

void Yielding::forget(const std::string& vehicle) {
  commanded_.erase(vehicle);
  in_emergency_.erase(vehicle);
  stopping_.erase(vehicle);
  braked_late_.erase(vehicle);
  at_end_.erase(vehicle);
}

std::vector<SpeedOrder> Yielding::plan(std::span<FleetVehicle> vehicles, const PeopleNear& people,
                                       std::span<const PersonAhead> outside,
                                       const SafeSpeeds& safe_speeds, double time, double dt) {
  std::vector<std::optional<YieldOrder>> planned(vehicles.size());
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    FleetVehicle& vehicle = vehicles[i];
    const auto stop = plan_stop(vehicle, dt);
    planned[i] = stop && !vehicle.traits.external
                     ? stop
                     : plan_for_people(vehicle, people, safe_speeds, time, dt);
  }
  keep_junctions_clear(vehicles, safe_speeds, dt, planned);
  keep_lane_ends_free(vehicles, people.all(), outside, safe_speeds, dt, planned);
  keep_behind_late_brakers(vehicles, safe_speeds, time, dt, planned);
  std::vector<SpeedOrder> orders;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    if (planned[i]) command(vehicles[i], *planned[i], orders);
    if (!planned[i] && !vehicles[i].traits.external) give_back(vehicles[i], orders);
  }
  return orders;
}

}  // namespace pedzone
