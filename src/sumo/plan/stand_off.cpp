#include "sumo/plan/stand_off.hpp"

#include <algorithm>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kBeside = 3.0;     // [m] assumed: SUMO stops for people who are nearer
constexpr double kFreeWay = 5.0;    // [m] assumed: so far it must be free
constexpr double kJunction = 20.0;  // [m] assumed: a junction's width and the way to it
constexpr double kBorder = 5.0;     // [m] assumed: a crossing beside a zone is no farther from it
constexpr double kSample = 0.5;     // [m] numerical
constexpr double kGap = 0.3;        // [m] assumed: kept to other vehicles
constexpr double kMargin = 0.05;    // [m] as a creeping vehicle's

bool meets(const Rectangle& body, const FleetVehicle& other) {
  const Rectangle its = body_of(other);
  for (double along = -its.half.x(); along <= its.half.x(); along += kSample) {
    if (body.signed_distance(its.centre + its.axis * along) < its.half.y() + kGap) return true;
  }
  return body.signed_distance(other.front) < its.half.y() + kGap;
}

bool free_of_vehicles(const FleetVehicle& vehicle, std::span<const FleetVehicle> vehicles) {
  return std::none_of(vehicles.begin(), vehicles.end(), [&](const FleetVehicle& other) {
    const double reach = kFreeWay + vehicle.traits.length + other.traits.length;
    if (other.id == vehicle.id || (other.front - vehicle.front).norm() > reach) return false;
    for (double travelled = kSample; travelled <= kFreeWay; travelled += kSample) {
      if (meets(body_after(vehicle, travelled), other)) return true;
    }
    return false;
  });
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

/// Whether people beside a vehicle at a zone, and nothing in its way, may be all it waits for.
bool StandOffs::stands_off(const FleetVehicle& vehicle, std::span<const FleetVehicle> vehicles,
                           std::span<const PersonAhead> people) const {
  if (!meets_zone(vehicle)) return false;
  const Rectangle body = body_of(vehicle);
  const bool beside = std::any_of(people.begin(), people.end(), [&](const PersonAhead& person) {
    return body.signed_distance(person.position) < kBeside;
  });
  return beside && !first_in_way(vehicle, people, kMargin, kFreeWay) &&
         free_of_vehicles(vehicle, vehicles);
}

std::vector<SpeedOrder> StandOffs::plan(std::span<FleetVehicle> vehicles,
                                        std::span<const PersonAhead> people, double dt) {
  std::vector<SpeedOrder> orders;
  std::unordered_map<std::string, double> stood;
  for (FleetVehicle& vehicle : vehicles) {
    const bool passing = passing_.contains(vehicle.id);
    const bool ours = vehicle.traits.yields && !vehicle.traits.external;
    if (!ours || (!passing && vehicle.speed > kHaltingSpeed)) continue;
    const auto before = stood_.find(vehicle.id);
    const double time = before == stood_.end() ? dt : before->second + dt;
    const Parameters& parameters = zones_[vehicle.zone].parameters;
    const bool held = vehicle.stopped || vehicle.commanded >= 0.0;
    const bool pass =
        !held && time >= parameters.creep_after && stands_off(vehicle, vehicles, people);
    if (pass) {
      if (!passing) orders.push_back({vehicle.id, SpeedMode::kPass});
      orders.push_back({vehicle.id, parameters.creep_speed});
      vehicle.commanded = parameters.creep_speed;
      passing_.insert(vehicle.id);
    } else if (passing) {
      orders.push_back({vehicle.id, SpeedMode::kDefault});
      if (!held) orders.push_back({vehicle.id, kOwnSpeed});
      passing_.erase(vehicle.id);
    }
    if (pass || (!held && vehicle.speed <= kHaltingSpeed)) stood[vehicle.id] = time;
  }
  stood_ = std::move(stood);
  return orders;
}

}  // namespace pedzone
