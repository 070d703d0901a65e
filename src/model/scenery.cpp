#include "model/scenery.hpp"

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"

namespace pedzone {
namespace {

constexpr double kDegree = kPi / 180.0;

/// [m] side of the tiles that list vehicles, and at most so many tiles. Numerical, by timing.
constexpr double kVehicleTile = 8.0;
constexpr double kTilesPerPerson = 8.0, kTilesAtLeast = 4096.0;

/// [m/s] nobody is taken to be slower, so that the time to walk as far as one sees is a number.
constexpr double kLeastSpeed = 0.01;

}  // namespace

void Scenery::prepare(const Snapshot& snapshot, VehicleForm form, double reach) {
  snapshot_ = snapshot;
  const Parameters& parameters = *snapshot.parameters;
  senses_ = pedzone::senses_of(parameters, form);
  prepare_walls();
  const double field =
      snapshot.attention ? snapshot.attention->widest_field : parameters.field_of_view;
  grid_.build(*snapshot.persons, origin_, std::min(parameters.sight, reach), field * kDegree);
  prepare_vehicles(minds_discomfort(parameters, form));
}

void Scenery::prepare_walls() {
  const std::span<const Wall> walls =
      snapshot_.walls != nullptr ? snapshot_.walls->walls() : std::span<const Wall>();
  const double reach = snapshot_.parameters->sight;
  const Persons& persons = *snapshot_.persons;
  const std::uint64_t identity = walls.empty() ? 0 : snapshot_.walls->identity();
  if (known_reach_ == reach && identity != 0 && identity == known_walls_) return;
  // Any lattice point near the scene serves as origin.
  const Vec2 near = !walls.empty()       ? walls.front().a
                    : persons.size() > 0 ? Vec2(persons.x[0], persons.y[0])
                                         : Vec2::Zero();
  origin_ = {to_lattice(near.x()), to_lattice(near.y())};
  walls_.build(walls, reach, origin_);
  known_walls_ = identity;
  known_reach_ = reach;
}

void Scenery::prepare_vehicles(bool gains_are_seen) {
  vehicles_.clear();
  for (const VehicleState& vehicle : snapshot_.vehicles) {
    vehicles_.push_back(shape_of(vehicle, origin_));
    if (gains_are_seen) expect_gain(vehicles_.back(), vehicle.gain);
  }
  const double hearing =
      snapshot_.attention ? snapshot_.attention->farthest_hearing : snapshot_.parameters->hearing;
  const std::int64_t tile =
      tile_size_for(grid_.bounds(), to_lattice(kVehicleTile),
                    kTilesPerPerson * static_cast<double>(grid_.size()) + kTilesAtLeast);
  vehicle_tiles_.build(
      grid_.bounds(), tile, vehicles_.size(),
      [&](std::size_t i) {
        const VehicleShape& vehicle = vehicles_[i];
        const double heard = vehicle.horn ? kHornReach : hearing * vehicle.loudness;
        const double range = std::max<double>(senses_.vehicle_sight, heard);
        const std::int64_t reach = to_lattice(range + vehicle.reach);
        const LatticePoint& c = vehicles_[i].centre;
        return box_round(c.x, c.y, reach);
      },
      [&](std::size_t i, const LatticeBox&) { return !snapshot_.vehicles[i].apart(); });
}

Walker Scenery::walker(std::size_t i) const {
  const Persons& persons = *snapshot_.persons;
  const Parameters& parameters = *snapshot_.parameters;
  Walker w = onlooker(persons, i, origin_);
  w.speed = static_cast<float>(std::max(persons.preferred_speed[i], kLeastSpeed));
  // Nobody avoids what stands behind its goal. Not nearer than what Eq. 3 brakes for, so that the
  // speed never depends on the goal. The paper is silent; without this a person turns away from
  // the wall behind a waypoint at a corner, and circles a goal at a wall.
  const double counts =
      std::max(persons.goal_distance[i], persons.preferred_speed[i] * parameters.collision_time);
  w.static_reach = static_cast<float>(std::min(counts, parameters.sight));
  return w;
}

Senses Scenery::senses_of(std::size_t i) const {
  if (snapshot_.attention == nullptr) return senses_;
  return with(senses_, snapshot_.attention->persons[i]);
}

}  // namespace pedzone
