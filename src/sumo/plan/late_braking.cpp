#include "sumo/plan/late_braking.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sumo/plan/yield_plan.hpp"

namespace pedzone {
namespace {

constexpr double kMoment = 0.1;  // [s] numerical: bodies are compared so often
constexpr double kReach = 2.0;   // [m] numerical: bodies of persons, and a body's swing in a bend
constexpr int kHalvings = 4;     // numerical: of the span from decel to emergency_decel

/// A vehicle that brakes to a standstill, step by step, as SUMO moves it.
class BrakingStep {
 public:
  BrakingStep(const FleetVehicle& vehicle, double deceleration, double dt)
      : traits_(vehicle.traits),
        less_(deceleration * dt),
        before_(vehicle.speed),
        after_(std::max(0.0, before_ - less_)) {}
  bool moves() const { return speed(0.5) > 0.0; }
  void next() {
    before_ = after_;
    after_ = std::max(0.0, after_ - less_);
  }
  /// [m/s] after that share of the step.
  double speed(double share) const { return speed_within(traits_, before_, after_, share); }

 private:
  const VehicleTraits& traits_;
  double less_;  ///< [m/s] after each step
  double before_, after_;
};

/// Whether the vehicle runs into a person on its way from `before` to `body`: with its front, or
/// with a flank that swings over where the person is. The person was at `then` [m], and is at
/// `now`; who walks into a flank by itself is not run into.
bool runs_into(const VehicleBody& before, const Vec2& then, const VehicleBody& body,
               const Vec2& now, double radius) {
  if (body.signed_distance(now) >= radius) return false;
  const Rectangle& first = before.first();
  if ((then - first.centre).dot(first.axis) > first.half.x()) return true;
  return before.signed_distance(then) >= radius && body.signed_distance(then) < radius;
}

/// Whether it runs into anybody, braking with `deceleration` [m/s²] from now on.
bool meets_anybody(const FleetVehicle& vehicle, std::span<const PersonAhead> people,
                   double deceleration, double dt) {
  const int moments = std::max(1, static_cast<int>(std::ceil(dt / kMoment)));
  const double moment = dt / moments;
  double travelled = 0.0, time = 0.0;
  VehicleBody before = body_of(vehicle);
  BrakingStep step(vehicle, deceleration, dt);
  for (; step.moves(); step.next()) {
    for (int i = 0; i < moments; ++i) {
      travelled += step.speed((i + 0.5) / moments) * moment;
      const VehicleBody body = body_after(vehicle, travelled);
      for (const PersonAhead& person : people) {
        const Vec2 then = person.position + person.velocity * time;
        if (runs_into(before, then, body, then + person.velocity * moment, person.radius)) {
          return true;
        }
      }
      time += moment;
      before = body;
    }
  }
  return false;
}

/// Whether it comes nearer to its leader than its min_gap, braking with `deceleration` [m/s²].
bool comes_too_near(const FleetVehicle& vehicle, double gap, const VehicleTraits& leader,
                    double next, double deceleration, double dt) {
  for (BrakingStep step(vehicle, deceleration, dt); step.moves(); step.next()) {
    gap += (next - step.speed(0.5)) * dt;
    if (gap < vehicle.traits.min_gap) return true;
    next = std::max(0.0, next - leader.decel * dt);
  }
  return false;
}

/// The least deceleration [m/s²] of which `meets` does not hold, from decel to emergency_decel.
template <class Meets>
double least_deceleration(const VehicleTraits& traits, const Meets& meets) {
  double enough = traits.emergency_decel, little = traits.decel;
  if (!meets(little)) return little;
  if (meets(enough)) return enough;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (little + enough);
    (meets(middle) ? little : enough) = middle;
  }
  return enough;
}

}  // namespace

double needed_deceleration(const FleetVehicle& vehicle, std::span<const PersonAhead> people,
                           double dt) {
  if (dt <= 0.0) return vehicle.traits.decel;
  const double duration = vehicle.speed / vehicle.traits.decel;
  const double distance = 0.5 * vehicle.speed * duration;
  std::vector<PersonAhead> near;
  for (const PersonAhead& person : people) {
    const double walk = person.velocity.norm() * duration;
    const double reach = distance + walk + vehicle.traits.width + kReach;
    if ((person.position - vehicle.front).norm() < reach) near.push_back(person);
  }
  return least_deceleration(vehicle.traits,
                            [&](double b) { return meets_anybody(vehicle, near, b, dt); });
}

double needed_deceleration_behind(const FleetVehicle& vehicle, double gap,
                                  const VehicleTraits& leader, double next, double dt) {
  if (dt <= 0.0 || gap < vehicle.traits.min_gap) return vehicle.traits.decel;
  return least_deceleration(
      vehicle.traits, [&](double b) { return comes_too_near(vehicle, gap, leader, next, b, dt); });
}

}  // namespace pedzone
