#include "crowd/sense/lookout.hpp"

#include <algorithm>
#include <limits>

#include "crowd/sense/perception.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kSight = 30.0;  // [m] assumed: so much of a lane people see before they enter it
constexpr auto kNoVehicle = std::numeric_limits<std::uint32_t>::max();

}  // namespace

Lookout::Lookout(const CrowdState& crowd) : crowd_(crowd) {
  for (std::uint32_t k = 0; k < crowd.vehicles.size(); ++k) {
    const VehicleState& vehicle = crowd.vehicles[k];
    const bool stands = vehicle.velocity.norm() < kHaltingSpeed;
    if (stands || vehicle.length > kLargeVehicle) hiding_.push_back(k);
  }
}

bool Lookout::sees(std::size_t i, std::uint32_t v) const {
  const VehicleState& vehicle = crowd_.vehicles[v];
  const Vec2 front = front_of(vehicle);
  return in_view(i, front, v) || in_view(i, vehicle.centre, v);
}

double Lookout::room_unseen(std::size_t i, const Street& street, const Vec2& from,
                            bool leftwards) const {
  double room = std::numeric_limits<double>::infinity();
  for (const StreetLane& lane : street.lanes) {
    const double to_edge = leftwards ? lane.low - from.y() : from.y() - lane.high;
    if (to_edge < 0.0 || to_edge >= room) continue;
    const double upstream = from.x() - lane.direction * kSight;
    const Vec2 point = street.point(upstream, 0.5 * (lane.low + lane.high));
    if (!in_view(i, point, kNoVehicle)) room = to_edge;
  }
  return room;
}

bool Lookout::in_view(std::size_t i, const Vec2& point, std::uint32_t v) const {
  const Vec2 here = crowd_.position(i);
  const Zone& zone = crowd_.zone;
  if (!zone.obstacles.empty() && !zone.sight_walls.free_line(here, point)) return false;
  return std::ranges::none_of(hiding_, [&](std::uint32_t k) {
    return k != v && runs_through(rectangle_of(crowd_.vehicles[k]), here, point);
  });
}

}  // namespace pedzone
