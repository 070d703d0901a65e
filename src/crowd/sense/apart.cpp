#include "crowd/sense/apart.hpp"

#include <array>
#include <span>

#include "core/vec.hpp"

namespace pedzone {
namespace {

constexpr double kBeside = 0.3;  // [m] assumed: cars do not keep to a line better than that
constexpr double kAhead = 4.5;   // [s] as far as people look ahead (discomfortHorizon)

}  // namespace

bool keeps_apart(const WallIndex& walls, const VehicleState& vehicle) {
  const double clearance = 0.5 * vehicle.width + kBeside;
  const Vec2 axis = unit(vehicle.heading) * (0.5 * vehicle.length);
  const Vec2 rear = vehicle.centre - axis, front = vehicle.centre + axis;
  if (walls.inside(front) || !walls.free_line(rear, front, clearance)) return false;
  const std::array<Vec2, 2> straight{vehicle.centre, vehicle.centre + vehicle.velocity * kAhead};
  const std::span<const Vec2> way = vehicle.way.empty() ? straight : vehicle.way;
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    if (!walls.free_line(way[k], way[k + 1], clearance)) return false;
  }
  return true;
}

}  // namespace pedzone
