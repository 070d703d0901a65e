// Straight to the goal at the preferred speed, minding nothing: what any model must beat. Bodies
// that touch are still pushed apart by the crowd.
#pragma once

#include "model/walking_model.hpp"

namespace pedzone {

class ConstantVelocityModel : public WalkingModel {
 public:
  void prepare(const Snapshot& snapshot) override { snapshot_ = snapshot; }
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override;
  bool minds_vehicles() const override { return false; }

 private:
  Snapshot snapshot_;
};

}  // namespace pedzone
