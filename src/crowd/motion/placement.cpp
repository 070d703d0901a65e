#include "crowd/motion/placement.hpp"

#include <algorithm>
#include <cmath>

#include "crowd/behaviour/bystanding.hpp"
#include "crowd/sense/vehicle_motion.hpp"

namespace pedzone {
namespace {

constexpr double kSpacing = 0.12;    // [m] numerical: between places that are tried
constexpr double kVehicleGap = 0.1;  // [m] assumed
constexpr double kTolerance = 1e-6;  // [m] numerical: rounding of wall distances

struct Body {
  Vec2 centre;
  double radius;
};

/// What may be in the way of somebody within reach of `wanted`.
struct Surroundings {
  Surroundings(const CrowdState& crowd, const Vec2& wanted, double radius)
      : walls(crowd.zone.walls), origin(wanted), own_radius(radius) {
    const auto take = [&](const Vec2& centre, double its_radius) {
      const double reach = kPlacementReach + radius + its_radius;
      if ((centre - wanted).squaredNorm() < reach * reach) bodies.push_back({centre, its_radius});
    };
    for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
      take(crowd.position(i), crowd.persons.radius[i]);
    }
    for (std::size_t k = 0; k < crowd.seen.size(); ++k) {
      take(own_place(crowd, k), crowd.seen[k].radius);
    }
    for (const VehicleState& vehicle : crowd.vehicles) {
      if (distance_to(vehicle, wanted) < kPlacementReach + radius + kVehicleGap) {
        vehicles.push_back(vehicle);
      }
    }
    // Where the street is narrower than the body, walls need not be farther than they are here.
    wall_room = std::min(radius, walls.room(wanted, radius)) - kTolerance;
  }

  /// Gap [m] around a body at `place` to the nearest other one; negative when they overlap.
  double gap(const Vec2& place) const {
    double least = kPlacementReach;
    for (const Body& body : bodies) {
      least = std::min(least, (body.centre - place).norm() - body.radius - own_radius);
    }
    for (const VehicleState& vehicle : vehicles) {
      least = std::min(least, distance_to(vehicle, place) - kVehicleGap - own_radius);
    }
    return least;
  }

  /// Whether one can get to `place` and stand between the walls there.
  bool reachable(const Vec2& place) const {
    return walls.inside(place) && walls.room(place, own_radius) >= wall_room &&
           walls.free_line(origin, place);
  }

  const WallIndex& walls;
  Vec2 origin;
  double own_radius, wall_room;
  std::vector<Body> bodies;
  std::vector<VehicleState> vehicles;
};

}  // namespace

Vec2 free_place(const CrowdState& crowd, const Vec2& wanted, double radius) {
  Surroundings around(crowd, wanted, radius);
  Vec2 best = wanted;
  double best_gap = around.gap(wanted);
  if (best_gap >= 0.0) return wanted;
  const int rings = static_cast<int>(kPlacementReach / kSpacing);
  for (int ring = 1; ring <= rings; ++ring) {
    const int places = static_cast<int>(std::ceil(2.0 * kPi * ring));
    for (int k = 0; k < places; ++k) {
      const Vec2 place = wanted + ring * kSpacing * unit(2.0 * kPi * k / places);
      const double gap = around.gap(place);
      if (gap <= best_gap || !around.reachable(place)) continue;
      if (gap >= 0.0) return place;
      best = place;
      best_gap = gap;
    }
  }
  return best;
}

}  // namespace pedzone
