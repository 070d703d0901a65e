// M. J. Seitz, G. Köster, "Natural discretization of pedestrian movement in continuous space",
// Phys. Rev. E 86, 046108 (2012): the optimal steps model, with vehicles as obstacles.
#pragma once

#include "model/perceiving_model.hpp"

namespace pedzone {

/// The model's functions, with the paper's symbols: a person steps to where the potential is least.
namespace optimal_steps {

inline constexpr double kBeta0 = 0.462;  ///< [m] β₀, length of a step at speed 0 (measured there)
inline constexpr double kBeta1 = 0.235;      ///< [s] β₁, and its growth with the free-flow speed
inline constexpr double kMuPerson = 1000.0;  ///< μ_p, potential [m] within another body
inline constexpr double kNuPerson = 0.4;     ///< [m] ν_p, height outside of it
inline constexpr double kAPerson = 1.0;      ///< a_p, of exp(−a·dᵇ)
inline constexpr double kBPerson = 0.2;      ///< b_p
inline constexpr double kHPerson = 1.0;      ///< [m] h_p, where it ends
inline constexpr double kMuBorder = 10000.0;  ///< μ_o, within an obstacle
inline constexpr double kNuBorder = 0.2;      ///< [m] ν_o
inline constexpr double kABorder = 3.0;       ///< a_o
inline constexpr double kBBorder = 2.0;       ///< b_o
inline constexpr double kHBorder = 6.0;       ///< [m] h_o

/// [m] of a person with that free-flow speed [m/s], without the paper's error term.
double step_length(double speed);

/// P_p of another person, whose body is `gap` [m] from one's own.
double person_potential(double gap);

/// P_o of an obstacle at `gap` [m] from the body. Within it grows with the depth (in the paper it
/// does not), so that there is a way out.
double obstacle_potential(double gap);

/// P [m] of a place relative to the person: the distance left and what repels there.
double potential(const Perceived& who, const Vec2& place);

/// Where to step: the best place on the circle of radius `length` [m], or zero where it is best to
/// stay. Of two equal ones the one nearer to the goal's direction, then the one on the right.
Vec2 best_step(const Perceived& who, double length);

/// Whether a step of `duration` [s] ends within the `dt` [s] before `time`, with `phase` [0, 1).
bool step_ends(double time, double dt, double duration, double phase);

}  // namespace optimal_steps

/// Discrete steps, each planned when the one before ends, walked at constant velocity: that is all
/// a person need remember. Steps of different persons end at different times (the phase is drawn
/// from seed and person); those that end within one step of the simulation are planned together,
/// from the same snapshot. Differs from the paper: others are where they are in mid-step, not on
/// their feet; no error term of the step length; a moving vehicle is an obstacle as large as the
/// room that it takes within kSweepTime (assumed; gaps over the person's caution). Where the
/// snapshot has no time, every decision is a new step.
class OptimalStepsModel : public PerceivingModel {
 public:
  OptimalStepsModel();
  bool sets_velocity() const override { return true; }

 private:
  Decision decide_from(const Perceived& who) const override;
};

}  // namespace pedzone
