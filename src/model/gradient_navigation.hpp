// F. Dietrich, G. Köster, "Gradient navigation model for pedestrian dynamics", Phys. Rev. E 89,
// 062801 (2014), with vehicles as obstacles.
#pragma once

#include "model/perceiving_model.hpp"

namespace pedzone {

/// The model's functions, with the paper's symbols.
namespace gradient_navigation {

inline constexpr double kTau = 0.5;            ///< [s] τ, relaxation time of the speed
inline constexpr double kKappa = 0.6;          ///< κ: sight ends at 100°, where cos(κφ) = 1/2
inline constexpr double kSightEdge = 0.05;     ///< width of that end, of cos(κφ); assumed
inline constexpr double kPersonHeight = 3.59;  ///< p of persons, calibrated in the paper
inline constexpr double kPersonRange = 0.70;   ///< [m] R of persons, between centres, the same
inline constexpr double kBorderHeight = 9.96;  ///< p of obstacles, the same
inline constexpr double kBorderRange = 0.25;   ///< [m] R of obstacles, from the centre, the same
inline constexpr double kRadius = 0.2;  ///< [m] the body for which those were calibrated; assumed.
                                        ///< Wider bodies push so much farther

/// h(r) = p·exp(1/((r/R)² − 1)) for r < R, else 0: smooth, of compact support. At most p/e.
double h(double r, double height, double range);

/// g: the vector, cut to length 1. The paper smooths the cut for its integrator of high order.
Vec2 g(const Vec2& v);

/// s: how much of somebody at angle φ [rad] from the heading counts, a logistic step of cos(κφ).
double sight(double phi);

/// −∇P of a person that walks with `heading` and has `radius` [m].
Vec2 person_gradient(const Neighbour& other, const Vec2& heading, double radius);

/// −∇P of the point of an obstacle at `distance` [m] from the centre, that pushes to `away`.
Vec2 obstacle_gradient(double distance, const Vec2& away, double radius);

/// N = g(g(N_T) + g(N_P)): where to go; shorter than 1 where that is slower. Whoever is within the
/// room that a moving vehicle takes minds nothing but to get out of it (assumed).
Vec2 navigation(const Perceived& who);

}  // namespace gradient_navigation

/// Walks along N at once, without inertia; the speed relaxes towards |N|²·v and is at most |N|·v:
/// what w → |N|·v and dx/dt = w·N of the paper lead to. Differs from it: w is not kept but found
/// from the velocity; v does not depend on the density; a moving vehicle is an obstacle as large as
/// the room that it takes within kSweepTime (assumed; distances over the person's caution).
class GradientNavigationModel : public PerceivingModel {
 public:
  GradientNavigationModel();
  bool sets_velocity() const override { return true; }

 private:
  Decision decide_from(const Perceived& who) const override;
};

}  // namespace pedzone
