#include "crowd/sense/danger.hpp"

#include <algorithm>
#include <limits>

#include "crowd/sense/claim_room.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "geometry/polyline.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kLook = 0.25;   // [s] numerical: no vehicle drives past its own length meanwhile
constexpr double kGlance = 1.0;  // [s] numerical: the same for what is within metres
constexpr double kClear = 0.5;   // [m] assumed: nobody stands where a vehicle comes this near ...
constexpr double kSoon = 3.0;    // [s] assumed: ... so soon

/// Along its lanes where SUMO tells them.
bool drives_over(const VehicleState& vehicle, const Vec2& point, double reach, double way) {
  if (vehicle.way.size() < 2) return false;
  const LineProjection at = project_on(vehicle.way, point);
  const double ahead = at.offset - vehicle.gone;  // of its rear
  return ahead > 0.0 && ahead < vehicle.length + way + reach &&
         std::abs(at.lateral) < 0.5 * vehicle.width + reach;
}

bool sweeps(const VehicleState& vehicle, const Vec2& point, double reach, double time) {
  if (!drives(vehicle)) return false;
  const double way = vehicle.velocity.norm() * time;
  const double bound = way + vehicle.length + vehicle.width + reach;
  if ((point - vehicle.centre).squaredNorm() > bound * bound) return false;
  if (drives_over(vehicle, point, reach, way)) return true;
  const int looks = static_cast<int>(time / kLook);
  for (int k = 0; k <= looks; ++k) {
    if (distance_to(moved_on(vehicle, k * kLook), point) < reach) return true;
  }
  return false;
}

bool comes_near(const VehicleState& vehicle, const Vec2& point, double reach, double time) {
  if (!drives(vehicle)) return false;
  for (double t = 0.0; t <= time; t += kGlance) {
    if (distance_to(moved_on(vehicle, t), point) < reach) return true;
  }
  return false;
}

}  // namespace

bool drives(const VehicleState& vehicle) {
  return vehicle.velocity.squaredNorm() > kDrivingSpeed * kDrivingSpeed;
}

bool is_claimed(const CrowdState& crowd, std::size_t i, double margin) {
  const double reach = crowd.persons.radius[i] + margin;
  return std::ranges::any_of(crowd.vehicles_near.at(crowd.position(i)), [&](std::uint32_t v) {
    const VehicleState& vehicle = crowd.vehicles[v];
    return vehicle.claim > 0.0 && place_in_claim(vehicle, crowd.position(i), reach);
  });
}

bool is_swept(const CrowdState& crowd, std::size_t i, double margin, double time) {
  const double reach = crowd.persons.radius[i] + margin;
  const Vec2 here = crowd.position(i);
  return std::ranges::any_of(crowd.vehicles_near.at(here, reach, time), [&](std::uint32_t v) {
    return sweeps(crowd.vehicles[v], here, reach, time);
  });
}

bool may_stand(const CrowdState& crowd, std::size_t i) {
  return !is_claimed(crowd, i, kClear) && !is_swept(crowd, i, kClear, kSoon);
}

const VehicleState* moving_near(const CrowdState& crowd, const Vec2& point, double reach,
                                double time) {
  const VehicleState* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t v : crowd.vehicles_near.at(point, reach, time)) {
    const VehicleState& vehicle = crowd.vehicles[v];
    if (!comes_near(vehicle, point, reach, time)) continue;
    const double distance = distance_to(vehicle, point);
    if (distance >= least) continue;
    least = distance;
    nearest = &vehicle;
  }
  return nearest;
}

}  // namespace pedzone
