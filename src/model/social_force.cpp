#include "model/social_force.hpp"

#include <algorithm>
#include <cmath>

#include "model/border_points.hpp"
#include "model/vehicle_sweep.hpp"

namespace pedzone {
namespace social_force {
namespace {

const double kCosPhi = std::cos(kPhi * kPi / 180.0);

constexpr double kOnAxis = 1e-6;  // [m] numerical: b below it has no gradient

/// −∇ of an exponential potential: `height` [m²/s²], `range` [m], at `distance` [m].
double exponential(double height, double range, double distance) {
  return height / range * std::exp(-distance / range);
}

}  // namespace

Vec2 driving_force(const Vec2& velocity, const Vec2& desired) {
  return (desired - velocity) / kTau;
}

Vec2 person_force(const Neighbour& other, const Vec2& heading, double width) {
  const double sigma = kSigma * width;
  const Vec2 step = other.velocity * kDeltaT;
  const Vec2 r = -other.offset, q = r - step;
  const double r_length = r.norm(), q_length = q.norm(), sum = r_length + q_length;
  const double b = std::sqrt(std::max(sum * sum - step.squaredNorm(), 0.0)) / 2.0;
  if (b < kOnAxis || r_length == 0.0 || q_length == 0.0) {
    return exponential(kV0, sigma, 0.0) * -left_of(heading);
  }
  const Vec2 gradient = sum / (4.0 * b) * (r / r_length + q / q_length);
  return exponential(kV0, sigma, b) * gradient;
}

Vec2 border_force(const Border& border, double width) {
  return exponential(kU0, kR * width, border.distance) * away_from(border);
}

Vec2 vehicle_force(const SeenVehicle& vehicle, double radius, double caution) {
  // Within it the push grows no more: it outweighs the drive already.
  if (!vehicle.moving) return exponential(kU0, kR, std::max(vehicle.distance, 0.0)) * vehicle.away;
  const SweepDistance room = distance_to(sweep_of(vehicle, kSweepTime), Vec2::Zero());
  const double b = std::max(room.distance - radius, 0.0);
  return kV0 / kSigma * std::exp(-b / (kSigma * caution)) * room.away;
}

double weight(const Vec2& e, const Vec2& f) { return e.dot(-f) >= f.norm() * kCosPhi ? 1.0 : kC; }

Vec2 total_force(const Perceived& who) {
  Vec2 force = driving_force(who.velocity, who.speed * who.goal_direction);
  const auto add = [&](const Vec2& f) { force += weight(who.goal_direction, f) * f; };
  for (const Neighbour& other : who.neighbours) add(person_force(other, who.heading, who.width));
  for (const SeenVehicle& vehicle : who.vehicles) {
    add(vehicle_force(vehicle, who.radius, who.caution));
  }
  for (std::size_t k = 0; k < who.borders.size(); ++k) {
    if (pushes(who, k)) force += border_force(who.borders[k], who.width);
  }
  return force;
}

}  // namespace social_force

namespace {

// [m] numerical: a person at 2 m/s farther away pushes with less than 1e-3 m/s².
constexpr double kReach = 6.0;

}  // namespace

SocialForceModel::SocialForceModel() : PerceivingModel(kReach) {}

Decision SocialForceModel::decide_from(const Perceived& who) const {
  using namespace social_force;
  // dw/dt = F − (w − v)/τ with F at the start of the step: the drive is solved exactly.
  const double gain = kTau * (1.0 - std::exp(-who.step / kTau));
  return walk_with(who.velocity + gain * total_force(who), who);
}

}  // namespace pedzone
