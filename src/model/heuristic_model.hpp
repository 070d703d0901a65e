// The walking heuristics of Jan, Kleen and Berns: direction by Eq. 1 or Eq. 2, speed by Eq. 3,
// waiting for crossing vehicles. After Moussaid, Helbing and Theraulaz 2011.
#pragma once

#include <vector>

#include "model/candidates.hpp"
#include "model/direction_kernel.hpp"
#include "model/person_grid.hpp"
#include "model/vehicle_view.hpp"
#include "model/walking_model.hpp"
#include "model/wall_tiles.hpp"

namespace pedzone {

class HeuristicModel : public WalkingModel {
 public:
  /// With the fastest kernel for this processor, or a given one.
  explicit HeuristicModel(const DirectionKernel& kernel = fastest_kernel());

  void prepare(const Snapshot& snapshot) override;
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override;

 private:
  struct Scratch;
  struct Aware;

  Decision decide_one(std::size_t person, Scratch& scratch) const;
  void perceive_persons(const Aware& self, double heading, Scratch& scratch) const;
  void perceive_walls(const Aware& self, Scratch& scratch) const;
  void perceive_vehicles(const Aware& self, Scratch& scratch) const;

  DirectionChoice make_way(const Aware& self, const DirectionTask& task, Scratch& scratch) const;
  bool waits(const Aware& self, float ex, float ey, const Scratch& scratch) const;

  const DirectionKernel& kernel_;
  Snapshot snapshot_;
  Candidates candidates_;
  LatticeOrigin origin_;
  PersonGrid grid_;
  std::vector<VehicleShape> vehicles_;
  WallTiles walls_;
  const WallIndex* known_walls_ = nullptr;  ///< what walls_ was built from
  const Wall* known_first_ = nullptr;
  std::size_t known_count_ = 0;
  double known_reach_ = 0.0;
};

}  // namespace pedzone
