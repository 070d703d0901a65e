// Optimal reciprocal collision avoidance: J. van den Berg, S. J. Guy, M. Lin, D. Manocha,
// Reciprocal n-body collision avoidance, Robotics Research 2011. What Jan, Kleen and Berns call
// RVO.
#pragma once

#include "model/half_planes.hpp"
#include "model/perceiving_model.hpp"

namespace pedzone {

/// Each person takes the velocity nearest to its preferred one in the half-planes that other
/// persons (half of the way out of each velocity obstacle), vehicles (all of it: they take no
/// share) and walls (for the velocity zero, section 5.4) leave. Velocities are taken at once, as in
/// the paper.
class OrcaModel : public PerceivingModel {
 public:
  bool sets_velocity() const override { return true; }

 protected:
  Decision decide_from(const Perceived& who) const override;
};

}  // namespace pedzone
