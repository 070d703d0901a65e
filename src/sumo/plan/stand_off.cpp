#include "sumo/plan/stand_off.hpp"

#include <algorithm>
#include <cmath>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kBeside = 3.0;     // [m] assumed: SUMO stops for people who are nearer
constexpr double kFreeWay = 5.0;    // [m] assumed: so far it must be free
constexpr double kJunction = 20.0;  // [m] assumed: a junction's width and the way to it
constexpr double kBorder = 5.0;     // [m] assumed: a crossing beside a zone is no farther from it
constexpr double kTry = 2.0;        // [s] assumed: one that can creep past does so by then
constexpr double kRed = 120.0;      // [s] assumed: lights are red for no longer
constexpr double kSample = 0.5;     // [m] numerical
constexpr double kGap = 0.3;        // [m] assumed: kept to other vehicles
constexpr double kNoNearer = 0.05;  // [m] numerical: a way is made of chords
constexpr double kMargin = 0.05;    // [m] as a creeping vehicle's
constexpr double kDrives = 0.2;     // [m/s] numerical: told so much or more, it is to drive

/// [m] between the bodies, or less: the other's ends are taken to be round.
double clearance(const VehicleBody& body, const FleetVehicle& other) {
  double least = body.signed_distance(other.front);
  const VehicleBody others = body_of(other);
  for (const Rectangle& its : others.parts()) {
    for (double along = -its.half.x(); along <= its.half.x(); along += kSample) {
      least = std::min(least, body.signed_distance(its.centre + its.axis * along));
    }
  }
  return least - 0.5 * other.traits.width;
}

/// Whether it gets too near to no other. One that is near already may stay so near.
bool free_of_vehicles(const FleetVehicle& vehicle, std::span<const FleetVehicle> vehicles) {
  return std::none_of(vehicles.begin(), vehicles.end(), [&](const FleetVehicle& other) {
    const double reach = kFreeWay + vehicle.traits.length + other.traits.length;
    if (other.id == vehicle.id || (other.front - vehicle.front).norm() > reach) return false;
    const double enough = std::min(kGap, clearance(body_of(vehicle), other) - kNoNearer);
    for (double travelled = kSample; travelled <= kFreeWay; travelled += kSample) {
      if (clearance(body_after(vehicle, travelled), other) < enough) return true;
    }
    return false;
  });
}

/// Whether it is inside a junction with others that all stand, after people have held one of them.
/// Not where another is told to drive: two that are let go at once might meet.
bool is_in_gridlock(const FleetVehicle& vehicle, std::span<const FleetVehicle> vehicles) {
  if (!is_in_junction(vehicle)) return false;
  bool others = false, held = std::isfinite(vehicle.left_alone);
  for (const FleetVehicle& other : vehicles) {
    if (other.id == vehicle.id || !is_in_junction(other)) continue;
    if (other.junction.junction != vehicle.junction.junction) continue;
    if (other.speed > kHaltingSpeed || other.commanded >= kDrives) return false;
    others = true;
    held = held || std::isfinite(other.left_alone);
  }
  return others && held;
}

/// Whether it is before lights: it waits for these, whoever walks by.
bool is_before_lights(const FleetVehicle& vehicle) {
  const JunctionAhead& ahead = vehicle.junction;
  return ahead.signalled && ahead.begin > 0.0 && ahead.begin < kJunction;
}

}  // namespace

/// Whether the vehicle is in its zone, or comes by it soon: at a junction that a zone shares with
/// ordinary streets, SUMO's people and vehicles wait for each other on their side of the border.
bool StandOffs::meets_zone(const FleetVehicle& vehicle) const {
  const WallIndex& walls = zones_[vehicle.zone].walls;
  const auto near = [&](const Vec2& point) {
    return walls.inside(point) || walls.room(point, kBorder) < kBorder;
  };
  if (near(vehicle.centre())) return true;
  for (double ahead = 0.0; ahead <= kJunction; ahead += kSample) {
    if (near(point_on(vehicle.way, vehicle.traits.length + ahead).point)) return true;
  }
  return false;
}

/// What ends a stand-off with people beside a vehicle at a zone, or with other vehicles in a
/// junction there; to wait where it may be none.
StandOffs::Way StandOffs::way_out(const FleetVehicle& vehicle,
                                  std::span<const FleetVehicle> vehicles,
                                  std::span<const PersonAhead> people) const {
  if (!meets_zone(vehicle)) return Way::kWait;
  const bool held = first_in_way(vehicle, people, kMargin, kFreeWay).has_value();
  // Between lights people are let go by these: where it stands they would walk into it.
  const bool between_lights = is_in_junction(vehicle) && vehicle.junction.signalled;
  if (held) return between_lights ? Way::kWait : Way::kLetGo;
  const VehicleBody body = body_of(vehicle);
  const bool beside = std::any_of(people.begin(), people.end(), [&](const PersonAhead& person) {
    return body.signed_distance(person.position) < kBeside;
  });
  const bool stuck = beside || is_in_gridlock(vehicle, vehicles);
  return stuck && free_of_vehicles(vehicle, vehicles) ? Way::kPass : Way::kWait;
}

/// The way out, or to wait anew where it has been tried for long enough.
StandOffs::Way StandOffs::go_on(StandOff& one, const FleetVehicle& vehicle, Way out,
                                double dt) const {
  const bool gets_past = out == Way::kPass && vehicle.speed > kHaltingSpeed;
  one.tried = out != one.way || gets_past ? 0.0 : one.tried + dt;
  one.passed = out == Way::kPass ? one.passed + vehicle.speed * dt : 0.0;
  const double most = out == Way::kPass ? kTry : zones_[vehicle.zone].parameters.creep_after;
  const bool is_past = one.passed > kFreeWay + vehicle.traits.length && !is_in_junction(vehicle);
  if (out == Way::kWait || (one.tried < most && !is_past)) return out;
  one.stood = one.passed = 0.0;
  return Way::kWait;
}

/// From what the vehicle did to what it does now. `commanded`: Yielding has told it a speed; it
/// creeps past no faster, and that speed stays where it does no more.
void StandOffs::tell(FleetVehicle& vehicle, Way before, Way now, bool commanded, double dt,
                     std::vector<SpeedOrder>& orders) const {
  if (before == Way::kPass && now != before) orders.push_back({vehicle.id, SpeedMode::kOwn});
  if (before != Way::kWait && now == Way::kWait && !commanded) {
    orders.push_back({vehicle.id, kOwnSpeed});
  }
  if (now == Way::kPass) {
    if (before != now) orders.push_back({vehicle.id, SpeedMode::kPass});
    const double creep = zones_[vehicle.zone].parameters.creep_speed;
    vehicle.commanded = commanded ? std::min(creep, vehicle.commanded) : creep;
    vehicle.pull = vehicle.traits.accel;  // no braking that Yielding would ease
    orders.push_back({vehicle.id, vehicle.commanded});
  } else if (now == Way::kLetGo) {
    vehicle.lets_go = true;
    // No harder than SUMO brakes at its client's word: what does not do as told seems to be driven
    // by another program.
    orders.push_back({vehicle.id, speed_if_braked(vehicle, dt)});
  }
}

std::vector<SpeedOrder> StandOffs::plan(std::span<FleetVehicle> vehicles,
                                        std::span<const PersonAhead> people, double dt) {
  std::vector<SpeedOrder> orders;
  std::unordered_map<std::string, StandOff> stand_offs;
  for (FleetVehicle& vehicle : vehicles) {
    if (!vehicle.traits.yields || vehicle.traits.external) continue;
    const auto known = stand_offs_.extract(vehicle.id);
    StandOff one = known.empty() ? StandOff{} : known.mapped();
    const Way before = one.way;
    if (before == Way::kWait && vehicle.speed > kHaltingSpeed) continue;
    one.stood += dt;
    const bool commanded = vehicle.commanded >= 0.0;
    // Whom Yielding lets drive while it stands, SUMO holds.
    const bool may_drive = !commanded || vehicle.commanded >= kDrives;
    const bool waits = may_drive && !vehicle.stopped && vehicle.speed <= kHaltingSpeed;
    const double patience =
        is_before_lights(vehicle) ? kRed : zones_[vehicle.zone].parameters.creep_after;
    const bool may_act = may_drive && !vehicle.stopped && one.stood >= patience;
    one.way = may_act ? go_on(one, vehicle, way_out(vehicle, vehicles, people), dt) : Way::kWait;
    tell(vehicle, before, one.way, commanded, dt, orders);
    if (waits || one.way != Way::kWait) stand_offs[vehicle.id] = one;
  }
  for (const auto& [id, one] : stand_offs_) {  // not ours to tell at present
    if (one.way != Way::kWait) stand_offs[id] = {.way = one.way};
  }
  stand_offs_ = std::move(stand_offs);
  return orders;
}

}  // namespace pedzone
