#include "crowd/sense/apart.hpp"

#include <array>
#include <span>

#include "core/vec.hpp"

namespace pedzone {
namespace {

constexpr double kBeside = 0.3;  // [m] assumed: cars do not keep to a line better than that
constexpr double kAhead = 4.5;   // [s] as far as people look ahead (discomfortHorizon)

/// [m] numerical: no shorter piece of a way is looked at by itself.
constexpr double kPiece = 4.0;

/// Extends the box by those parts of the next piece of a way that do not keep off the ground.
void add_ground(const WallIndex& walls, const Vec2& from, const Vec2& to, double clearance,
                Eigen::AlignedBox2d& ground) {
  if (walls.free_line(from, to, clearance)) {
    const bool is_inside = !ground.isEmpty() && walls.inside(from);  // it comes from outside
    if (is_inside) ground.extend(from).extend(to);
    return;
  }
  if ((to - from).norm() <= kPiece) {
    ground.extend(from).extend(to);
    return;
  }
  const Vec2 middle = 0.5 * (from + to);
  add_ground(walls, from, middle, clearance, ground);
  add_ground(walls, middle, to, clearance, ground);
}

}  // namespace

Eigen::AlignedBox2d ground_ahead(const WallIndex& walls, const VehicleState& vehicle) {
  const double clearance = 0.5 * vehicle.width + kBeside;
  const Vec2 axis = unit(vehicle.heading) * (0.5 * vehicle.length);
  const Vec2 rear = vehicle.centre - axis, front = vehicle.centre + axis;
  if (walls.inside(front) || !walls.free_line(rear, front, clearance)) {
    return VehicleState::everywhere();
  }
  const std::array<Vec2, 2> straight{vehicle.centre, vehicle.centre + vehicle.velocity * kAhead};
  const std::span<const Vec2> way = vehicle.way.empty() ? straight : vehicle.way;
  Eigen::AlignedBox2d ground;
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    add_ground(walls, way[k], way[k + 1], clearance, ground);
  }
  return ground;
}

}  // namespace pedzone
