#include "crowd/sense/crosswalk_traffic.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "crowd/sense/street_traffic.hpp"

namespace pedzone {
namespace {

constexpr double kUpstream = 150.0;  // [m] numerical: no way is known from farther away
constexpr double kUnknown = 4.5;     // [s] assumed: so long a vehicle is taken to drive straight on
constexpr double kOblique = 0.3;     // numerical: sine; vehicles cover no more of a crosswalk

/// Where it comes over it, from where its rear is now.
std::optional<WayOver> from_rear(const Crosswalk& crosswalk, const VehicleState& vehicle) {
  if (vehicle.way.empty()) {
    const Vec2 ahead = unit(vehicle.heading), rear = vehicle.centre - ahead * 0.5 * vehicle.length;
    const double reach = vehicle.length + vehicle.velocity.norm() * kUnknown;
    return way_over(std::array{rear, Vec2(rear + ahead * reach)}, crosswalk);
  }
  auto over = way_over(vehicle.way, crosswalk);
  if (over) over->way -= vehicle.gone;
  return over;
}

}  // namespace

std::vector<StreetVehicle> coming_over(const Crosswalk& crosswalk,
                                       std::span<const VehicleState> vehicles) {
  std::vector<StreetVehicle> coming;
  const Vec2 line = crosswalk.end - crosswalk.begin, along = line.normalized();
  const Vec2 middle = crosswalk.begin + 0.5 * line;
  const double reach = kUpstream + line.norm();
  for (std::uint32_t v = 0; v < vehicles.size(); ++v) {
    const VehicleState& vehicle = vehicles[v];
    if (is_among(crosswalk, vehicle.yields_at)) continue;
    if ((vehicle.centre - middle).squaredNorm() > reach * reach) continue;
    const auto over = from_rear(crosswalk, vehicle);
    if (!over) continue;
    const double aside = over->direction.dot(left_of(along));
    const double width = vehicle.width / std::max(std::abs(aside), kOblique);
    const int direction = aside < 0.0 ? -1 : 1;
    const double front = -direction * (over->way - vehicle.length);
    coming.push_back(as_seen(vehicle, v, front, over->across, width, direction));
  }
  return coming;
}

}  // namespace pedzone
