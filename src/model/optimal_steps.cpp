#include "model/optimal_steps.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "geometry/segment.hpp"
#include "model/vehicle_sweep.hpp"

namespace pedzone {
namespace optimal_steps {
namespace {

// Numerical: places on the circle, 5° apart. With half as many people zigzag visibly.
constexpr int kPlaces = 72;

// [m] numerical: a border farther away than this adds less than 1e-5 m to the potential.
constexpr double kBorderReach = 1.8;

/// Whether the way from the person to `place` leads through the border.
bool crosses(const Border& border, const Vec2& place) {
  if ((place - border.a).dot(border.normal) >= 0.0) return false;
  return cross(place, border.a) * cross(place, border.b) <= 0.0;
}

/// Distance [m] from `place` to the borders; negative behind one.
double distance_to_borders(const Perceived& who, const Vec2& place) {
  const double reach = place.norm() + who.radius + kBorderReach;
  double least = reach;
  for (const Border& border : who.borders) {
    if (border.distance > reach) break;  // sorted by distance
    const double distance = (nearest_on(border.a, border.b, place) - place).norm();
    if (crosses(border, place)) return -distance;
    least = std::min(least, distance);
  }
  return least;
}

/// At the place or half way there, whichever is worse: nobody cuts through a vehicle's corner.
double vehicle_potential(const SeenVehicle& vehicle, const Perceived& who, const Vec2& place) {
  const VehicleSweep room = sweep_of(vehicle, vehicle.moving ? kSweepTime : 0.0);
  const double nearest =
      std::min(distance_to(room, place).distance, distance_to(room, place / 2.0).distance);
  const double gap = nearest - who.radius;
  return obstacle_potential(vehicle.moving ? gap / who.caution : gap);
}

}  // namespace

double step_length(double speed) { return kBeta0 + kBeta1 * speed; }

double person_potential(double gap) {
  if (gap <= 0.0) return kMuPerson;
  return gap <= kHPerson ? kNuPerson * std::exp(-kAPerson * std::pow(gap, kBPerson)) : 0.0;
}

double obstacle_potential(double gap) {
  if (gap <= 0.0) return kMuBorder * (1.0 - gap);
  return gap <= kHBorder ? kNuBorder * std::exp(-kABorder * std::pow(gap, kBBorder)) : 0.0;
}

double potential(const Perceived& who, const Vec2& place) {
  double sum = (who.goal_distance * who.goal_direction - place).norm();
  sum += obstacle_potential(distance_to_borders(who, place) - who.radius);
  for (const Neighbour& other : who.neighbours) {
    const double bodies = who.radius + other.radius, reach = bodies + kHPerson;
    const double squared = (other.offset - place).squaredNorm();
    if (squared <= reach * reach) sum += person_potential(std::sqrt(squared) - bodies);
  }
  for (const SeenVehicle& vehicle : who.vehicles) sum += vehicle_potential(vehicle, who, place);
  return sum;
}

Vec2 best_step(const Perceived& who, double length) {
  Vec2 best = Vec2::Zero();
  double least = potential(who, best);
  for (int k = 0; k < kPlaces; ++k) {
    // 0, −1, 1, −2, 2 ... steps from the goal's direction.
    const int turn = (k % 2 == 0 ? 1 : -1) * ((k + 1) / 2);
    const Vec2 e = unit(2.0 * kPi * turn / kPlaces);
    const Vec2 place = length * (e.x() * who.goal_direction + e.y() * left_of(who.goal_direction));
    const double here = potential(who, place);
    if (here >= least) continue;
    least = here;
    best = place;
  }
  return best;
}

bool step_ends(double time, double dt, double duration, double phase) {
  return std::floor(time / duration + phase) != std::floor((time - dt) / duration + phase);
}

}  // namespace optimal_steps

namespace {

using namespace optimal_steps;

// [m] numerical: the longest step at 5 m/s, two of the largest bodies and h_p.
constexpr double kReach = kBeta0 + kBeta1 * 5.0 + 2.0 + kHPerson;

}  // namespace

OptimalStepsModel::OptimalStepsModel() : PerceivingModel(kReach) {}

Decision OptimalStepsModel::decide_from(const Perceived& who) const {
  const double duration = step_length(who.speed) / who.speed;
  const double phase = random_uniform(who.seed, who.key, 0, Purpose::kStepPhase);
  if (who.time && !step_ends(*who.time, who.step, duration, phase)) {
    return walk_with(who.velocity, who);
  }
  // Nobody steps past the goal.
  const double length = std::min(step_length(who.speed), std::max(who.goal_distance, who.radius));
  return walk_with(best_step(who, length) / duration, who);
}

}  // namespace pedzone
