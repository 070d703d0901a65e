// D. Helbing, P. Molnár, "Social force model for pedestrian dynamics", Phys. Rev. E 51, 4282
// (1995), with vehicles as obstacles.
#pragma once

#include "model/perceiving_model.hpp"

namespace pedzone {

/// The forces of the paper [m/s²], with its symbols: α is the person itself, β another, B a border.
/// Values are those of the paper's simulations.
namespace social_force {

inline constexpr double kTau = 0.5;     ///< [s] τ, relaxation time
inline constexpr double kV0 = 2.1;      ///< [m²/s²] V⁰ of persons
inline constexpr double kSigma = 0.3;   ///< [m] σ of persons
inline constexpr double kU0 = 10.0;     ///< [m²/s²] U⁰ of borders
inline constexpr double kR = 0.2;       ///< [m] R of borders
inline constexpr double kDeltaT = 2.0;  ///< [s] Δt of the step of another person
inline constexpr double kC = 0.5;       ///< c, weight of what is not ahead
inline constexpr double kPhi = 100.0;   ///< [deg] φ, half the effective angle of sight

/// Eq. (2): the drive towards the velocity v⁰e.
Vec2 driving_force(const Vec2& velocity, const Vec2& desired);

/// Eqs. (3), (4): f_αβ = −∇V(b), b the semi-minor axis of the ellipse through α whose foci are β
/// now and after its next step. Between them, where the paper's force has no direction, it points
/// to the right of `heading` (assumed: in the paper fluctuations choose a side). `width`: of the
/// body, over its full one, as it holds its shoulders; σ is that much shorter (assumed).
Vec2 person_force(const Neighbour& other, const Vec2& heading, double width = 1.0);

/// Eq. (5): −∇U of the border's nearest point; R is shorter as σ.
Vec2 border_force(const Border& border, double width = 1.0);

/// Of a vehicle, assumed. Moving: as of a person, with b the body's distance from the room that the
/// vehicle takes within kSweepTime, its own step, and σ times the person's caution. Parked: as of a
/// border.
Vec2 vehicle_force(const SeenVehicle& vehicle, double radius, double caution);

/// w(e, −f): 1 where what repels with f is within φ of direction e, else c.
double weight(const Vec2& e, const Vec2& f);

/// The sum, without what attracts.
Vec2 total_force(const Perceived& who);

}  // namespace social_force

/// The velocity after a step under the forces of all that the person perceives. Differs from the
/// paper: persons out of the field of view do not count (in the paper those behind push aside with
/// full weight whoever is within their next step, and no lanes form: see the tests); nobody is
/// faster than the preferred speed (1.3 times that in the paper); fluctuations are the crowd's
/// heading noise; the crowd keeps bodies from overlapping.
class SocialForceModel : public PerceivingModel {
 public:
  SocialForceModel();
  bool sets_velocity() const override { return true; }

 private:
  Decision decide_from(const Perceived& who) const override;
};

}  // namespace pedzone
