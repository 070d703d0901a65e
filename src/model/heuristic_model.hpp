// The walking heuristics of Jan, Kleen and Berns: direction by Eq. 1 or Eq. 2, speed by Eq. 3,
// waiting for crossing vehicles. After Moussaid, Helbing and Theraulaz 2011.
#pragma once

#include <string_view>
#include <vector>

#include "model/candidates.hpp"
#include "model/direction_kernel.hpp"
#include "model/person_grid.hpp"
#include "model/vehicle_view.hpp"
#include "model/walking_model.hpp"
#include "model/wall_tiles.hpp"

namespace pedzone {

class Surroundings;

/// How vehicles are minded: as in the paper (obstacles that move, and the waiting rule), or with a
/// discomfort that grows before contact (giving_way.hpp; none: as in the paper).
enum class VehicleForm { kPlain, kDiscomfort };

/// Of a walking model by its name.
inline VehicleForm vehicle_form(std::string_view model) {
  return model == "plain" ? VehicleForm::kPlain : VehicleForm::kDiscomfort;
}

/// How far and wide people perceive by that form: those who mind discomfort see moving vehicles
/// farther than people.
Senses senses_of(const Parameters& parameters, VehicleForm form);

/// The same for one who perceives differently.
Senses with(Senses senses, const Perception& perception);

class HeuristicModel : public WalkingModel {
 public:
  /// With the fastest kernel for this processor, or a given one.
  explicit HeuristicModel(VehicleForm form = VehicleForm::kDiscomfort,
                          const DirectionKernel& kernel = fastest_kernel());

  void prepare(const Snapshot& snapshot) override;
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override;
  void rays(std::size_t person, std::vector<Ray>& out) const override;

 private:
  struct Scratch;

  void prepare_walls();
  void prepare_vehicles();
  Walker walker(std::size_t person) const;
  Senses senses_for(std::size_t person) const;
  /// What the person is aware of, ready for the kernel, which reads it from `around`.
  DirectionTask look_around(std::size_t person, const Walker& walker, Surroundings& around) const;
  Decision decide_one(std::size_t person, Scratch& scratch) const;
  DirectionChoice choose(const Walker& walker, double to_goal, const DirectionTask& task,
                         Scratch& scratch) const;
  bool gives_way() const;
  PacedChoice give_way(std::size_t person, const Walker& walker, double to_goal,
                       const DirectionTask& task, Scratch& scratch) const;
  PacedChoice plain(const Walker& walker, double to_goal, const DirectionTask& task,
                    Scratch& scratch) const;
  bool waits(const Walker& walker, float ex, float ey, const Surroundings& surroundings) const;

  VehicleForm form_;
  const DirectionKernel& kernel_;
  Snapshot snapshot_;
  Senses senses_;
  Candidates candidates_;
  LatticeOrigin origin_;
  PersonGrid grid_;
  std::vector<VehicleShape> vehicles_;
  TileLists vehicle_tiles_;  ///< vehicles that somebody on a tile may be aware of
  WallTiles walls_;
  std::uint64_t known_walls_ = 0;  ///< identity of what walls_ was built from
  double known_reach_ = 0.0;       ///< [m]
};

}  // namespace pedzone
