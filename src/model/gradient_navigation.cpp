#include "model/gradient_navigation.hpp"

#include <algorithm>
#include <cmath>

#include "model/border_points.hpp"
#include "model/vehicle_sweep.hpp"

namespace pedzone {
namespace gradient_navigation {
namespace {

SweepDistance room_of(const SeenVehicle& vehicle) {
  return distance_to(sweep_of(vehicle, vehicle.moving ? kSweepTime : 0.0), Vec2::Zero());
}

/// −∇P of all that the person perceives, summed.
Vec2 repulsion(const Perceived& who) {
  Vec2 sum = Vec2::Zero();
  for (const Neighbour& other : who.neighbours) {
    sum += person_gradient(other, who.heading, who.radius);
  }
  for (std::size_t k = 0; k < who.borders.size(); ++k) {
    if (!pushes(who, k)) continue;
    const Border& border = who.borders[k];
    sum += obstacle_gradient(border.distance, away_from(border), who.radius);
  }
  for (const SeenVehicle& vehicle : who.vehicles) {
    const SweepDistance room = room_of(vehicle);
    const double caution = vehicle.moving ? who.caution : 1.0;
    sum += obstacle_gradient(room.distance / caution, room.away, who.radius);
  }
  return sum;
}

}  // namespace

double h(double r, double height, double range) {
  const double u = std::max(r, 0.0) / range;
  return u < 1.0 ? height * std::exp(1.0 / (u * u - 1.0)) : 0.0;
}

Vec2 g(const Vec2& v) { return v / std::max(v.norm(), 1.0); }

double sight(double phi) {
  return 1.0 / (1.0 + std::exp((0.5 - std::cos(kKappa * phi)) / kSightEdge));
}

Vec2 person_gradient(const Neighbour& other, const Vec2& heading, double radius) {
  const double wider = radius + other.radius - 2.0 * kRadius;
  const Vec2 away = -other.offset / other.distance;
  const double phi = std::acos(std::clamp(-away.dot(heading), -1.0, 1.0));
  return h(other.distance - wider, kPersonHeight, kPersonRange) * sight(phi) * away;
}

Vec2 obstacle_gradient(double distance, const Vec2& away, double radius) {
  return h(distance - (radius - kRadius), kBorderHeight, kBorderRange) * away;
}

Vec2 navigation(const Perceived& who) {
  for (const SeenVehicle& vehicle : who.vehicles) {
    const SweepDistance room = room_of(vehicle);
    if (vehicle.moving && room.distance < 0.0) return room.away;
  }
  return g(g(who.goal_direction) + g(repulsion(who)));
}

}  // namespace gradient_navigation

namespace {

// [m] nobody farther away has a gradient: the range for two bodies of the largest radius, 1 m.
constexpr double kReach = gradient_navigation::kPersonRange + 2.0;

}  // namespace

GradientNavigationModel::GradientNavigationModel() : PerceivingModel(kReach) {}

Decision GradientNavigationModel::decide_from(const Perceived& who) const {
  const Vec2 n = gradient_navigation::navigation(who);
  const double length = n.norm();
  if (length == 0.0) return walk_with(Vec2::Zero(), who);
  const double goal = who.speed * length * length;
  const double keep = std::exp(-who.step / gradient_navigation::kTau);
  const double relaxed = goal + (who.velocity.norm() - goal) * keep;
  return walk_with(std::min(relaxed, who.speed * length) * n / length, who);
}

}  // namespace pedzone
