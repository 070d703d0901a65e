// The walking heuristics of Jan, Kleen and Berns: direction by Eq. 1 or Eq. 2, speed by Eq. 3,
// waiting for crossing vehicles. After Moussaid, Helbing and Theraulaz 2011.
#pragma once

#include <vector>

#include "model/candidates.hpp"
#include "model/cautions.hpp"
#include "model/direction_kernel.hpp"
#include "model/scenery.hpp"
#include "model/walking_model.hpp"

namespace pedzone {

class Surroundings;

class HeuristicModel : public WalkingModel {
 public:
  /// With the fastest kernel for this processor, or a given one. `original`: directions by Eq. 1,
  /// else by the equation that the parameters say.
  explicit HeuristicModel(VehicleForm form = VehicleForm::kDiscomfort,
                          const DirectionKernel& kernel = fastest_kernel(), bool original = false);

  void prepare(const Snapshot& snapshot) override;
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override;
  VehicleForm vehicle_form() const override { return form_; }
  void rays(std::size_t person, std::vector<Ray>& out) const override;

 private:
  struct Scratch;

  /// What the person is aware of, ready for the kernel, which reads it from `around`.
  DirectionTask look_around(std::size_t person, const Walker& walker, Surroundings& around) const;
  /// Sees the others anew, as they are in the way of somebody who holds its shoulders so, as far as
  /// they may be touched within `horizon` [s].
  void see_again(std::size_t person, const Walker& walker, const Shoulders& shoulders,
                 float horizon, Scratch& scratch, DirectionTask& task) const;
  Decision decide_one(std::size_t person, Scratch& scratch) const;
  /// Turns the shoulders where people leave no room to keep them straight.
  DirectionChoice choose(std::size_t person, const Walker& walker, double to_goal,
                         DirectionTask& task, Scratch& scratch) const;
  /// Whether somebody is met within the time to turn in any of the main directions; that one is
  /// asked first, and those beside it.
  bool meets_people(const DirectionTask& task, std::uint32_t direction) const;
  /// The time [s] in that direction, at most until somebody is met behind whom one keeps a
  /// distance.
  float time_to_queue(std::size_t person, const Walker& walker, const DirectionChoice& direction,
                      DirectionTask& task, Scratch& scratch) const;
  bool gives_way() const;
  bool extended() const;
  PacedChoice give_way(std::size_t person, const Walker& walker, double to_goal,
                       DirectionTask& task, Scratch& scratch) const;
  /// Share of the preferred speed, [1, kMostHurry].
  float hurry(std::size_t person) const;
  PacedChoice plain(std::size_t person, const Walker& walker, double to_goal, DirectionTask& task,
                    Scratch& scratch) const;
  bool waits(const Walker& walker, float ex, float ey, const Surroundings& surroundings) const;

  VehicleForm form_;
  const DirectionKernel& kernel_;
  bool original_;
  Snapshot snapshot_;
  Scenery scenery_;
  Candidates candidates_;
  Cautions cautions_;
};

/// The paper's model with vehicles as in the paper: directions by Eq. 2 (or parameter `equation`),
/// speeds by Eq. 3, waiting for a vehicle that is about to cross.
class PlainHeuristicModel : public HeuristicModel {
 public:
  PlainHeuristicModel() : HeuristicModel(VehicleForm::kPlain) {}
};

/// The same with the direction rule that the paper starts from, Eq. 1 (Moussaid 2011), whatever
/// parameter `equation` says.
class OriginalHeuristicModel : public HeuristicModel {
 public:
  OriginalHeuristicModel() : HeuristicModel(VehicleForm::kPlain, fastest_kernel(), true) {}
};

}  // namespace pedzone
