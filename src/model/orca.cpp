#include "model/orca.hpp"

#include <algorithm>
#include <array>

#include "model/border_points.hpp"
#include "model/velocity_obstacle.hpp"

namespace pedzone {
namespace {

/// [s] τ towards persons and vehicles, and to how many persons: the authors' RVO2 library, example
/// Blocks (neighbour distance 15 m there; here as far as people see).
constexpr double kHorizon = 5.0;
constexpr std::size_t kMostNeighbours = 10;
/// [s] τ towards what stands. Section 5.4: it may be less, so that people dare to go near a wall to
/// avoid others. Assumed: the time in which walking people stop, so that they reach goals at walls.
constexpr double kStillHorizon = 0.5;
/// Shares of the way out: reciprocal with a person, all of it before a vehicle.
constexpr double kShare = 0.5, kWholeWay = 1.0;

/// What stands: for velocity 0 the way out leads straight from its nearest point, so that standing
/// is always allowed. A body that touches it must only not get nearer.
HalfPlane still(const Vec2& normal, double distance, const Perceived& who) {
  return {normal, -std::max(distance - who.radius, 0.0) / kStillHorizon};
}

/// ORCA of one body that moves with `velocity`: Eq. 4 to 6 with the person's share of u.
HalfPlane orca(const ConvexBody& body, const Vec2& velocity, double share, const Perceived& who) {
  const WayOut out = way_out(body, who.velocity - velocity, kHorizon, who.step);
  return {out.normal, out.normal.dot(who.velocity) + share * out.depth};
}

HalfPlane orca(const SeenVehicle& vehicle, const Perceived& who) {
  const Vec2 along = vehicle.half_length * vehicle.axis;
  const Vec2 across = vehicle.half_width * left_of(vehicle.axis);
  const std::array<Vec2, kMostCorners> corners{
      vehicle.centre + along + across, vehicle.centre - along + across,
      vehicle.centre - along - across, vehicle.centre + along - across};
  return orca({corners, who.radius}, vehicle.velocity, kWholeWay, who);
}

struct Scratch {
  std::vector<HalfPlane> planes;
  HalfPlaneProgram program;
};

}  // namespace

Decision OrcaModel::decide_from(const Perceived& who) const {
  static thread_local Scratch scratch;
  std::vector<HalfPlane>& planes = scratch.planes;
  planes.clear();
  for (const Border& wall : who.borders) {
    if (!wall.repeated) planes.push_back(still(away_from(wall), wall.distance, who));
  }
  for (const SeenVehicle& vehicle : who.vehicles) {
    if (!vehicle.moving) planes.push_back(still(vehicle.away, vehicle.distance, who));
  }
  const std::size_t hard = planes.size();
  for (const SeenVehicle& vehicle : who.vehicles) {
    if (vehicle.moving) planes.push_back(orca(vehicle, who));
  }
  const std::size_t count = std::min(who.neighbours.size(), kMostNeighbours);
  for (std::size_t k = 0; k < count; ++k) {
    const Neighbour& other = who.neighbours[k];
    planes.push_back(
        orca({{&other.offset, 1}, who.radius + other.radius}, other.velocity, kShare, who));
  }
  const Vec2 preferred = who.speed * who.goal_direction;
  return walk_with(scratch.program.solve(planes, hard, who.speed, preferred), who);
}

}  // namespace pedzone
