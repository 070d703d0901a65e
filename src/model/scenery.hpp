// Persons, vehicles and walls of one moment, sorted so that each person finds what it may perceive.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "model/person_grid.hpp"
#include "model/senses.hpp"
#include "model/vehicle_view.hpp"
#include "model/wall_tiles.hpp"

namespace pedzone {

class Scenery {
 public:
  /// Sorts. Keeps a reference to the snapshot. `reach` [m]: nobody looks for persons farther away
  /// (nor farther than `sight`). No allocation once sizes have settled.
  void prepare(const Snapshot& snapshot, VehicleForm form,
               double reach = std::numeric_limits<double>::infinity());

  /// The person in the numbers that the kernel works with.
  Walker walker(std::size_t person) const;
  Senses senses_of(std::size_t person) const;
  /// Of those who do not perceive differently.
  const Senses& senses() const { return senses_; }

  const PersonGrid& persons() const { return grid_; }
  const WallTiles& walls() const { return walls_; }
  std::span<const VehicleShape> vehicles() const { return vehicles_; }
  /// Indices of all vehicles that somebody at the point may be aware of, and of some more.
  std::span<const std::uint32_t> vehicles_near(const LatticePoint& point) const {
    return vehicle_tiles_.at(point);
  }
  /// Whether the person minds that vehicle, if it perceives it.
  bool minds(std::size_t person, std::size_t vehicle) const {
    const Persons& persons = *snapshot_.persons;
    if (!snapshot_.vehicles[vehicle].concerns({persons.x[person], persons.y[person]})) return false;
    return snapshot_.attention == nullptr || snapshot_.attention->minds(person, vehicle);
  }

 private:
  void prepare_walls();
  void prepare_vehicles(bool gains_are_seen);

  Snapshot snapshot_;
  Senses senses_;
  LatticeOrigin origin_;
  PersonGrid grid_;
  std::vector<VehicleShape> vehicles_;
  TileLists vehicle_tiles_;  ///< vehicles that somebody on a tile may be aware of
  WallTiles walls_;
  std::uint64_t known_walls_ = 0;  ///< identity of what walls_ was built from
  double known_reach_ = 0.0;       ///< [m]
};

}  // namespace pedzone
