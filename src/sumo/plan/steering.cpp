#include "sumo/plan/steering.hpp"

#include <algorithm>
#include <set>

#include "core/error.hpp"

namespace pedzone {
namespace {

constexpr double kSeenAhead = 30.0;  // [m] as of other vehicles (fleet.cpp)

Vec2 centre(const VehiclePath& path, double time, double length) {
  return path.front(time) - 0.5 * length * unit(path.heading(time, length));
}

}  // namespace

std::vector<SteerOrder> Steering::plan(double time, const std::vector<std::string>& present,
                                       const std::function<double(const std::string&)>& length_of) {
  const std::set<std::string_view> there_are(present.begin(), present.end());
  std::vector<SteerOrder> orders;
  std::erase_if(paths_, [&](const VehiclePath& path) {
    if (time < path.begin()) return false;
    const std::string& id = path.vehicle();
    const bool there = there_are.contains(id), over = time > path.end();
    if (steered_.insert(id).second && !there) {
      // SUMO would accept one that is still to depart, and dies where that is off the road.
      throw path.error("is not under way at the first row of its path",
                       "vehicles that depart a step before that or earlier");
    }
    if (there && !over) {
      const double heading = path.heading(time, length_of(id));
      orders.push_back({id, SteerOrder::Place{path.front(time), heading}});
      return false;
    }
    // Where it is not there it has come to the end of its route, or somebody has removed it.
    if (there) orders.push_back({id, std::nullopt});
    steered_.erase(id);
    return true;
  });
  return orders;
}

void Steering::foresee(Fleet& fleet, double time, double dt) const {
  if (steered_.empty() || dt <= 0.0) return;
  for (FleetVehicle& vehicle : fleet.vehicles()) {
    if (!steered_.contains(vehicle.id)) continue;
    const VehiclePath& path = *std::ranges::find(paths_, vehicle.id, &VehiclePath::vehicle);
    const double length = vehicle.traits.length, before = time - dt;
    vehicle.traits.external = true;
    vehicle.velocity = (centre(path, time, length) - centre(path, before, length)) / dt;
    vehicle.yaw_rate = wrap_angle(path.heading(time, length) - path.heading(before, length)) / dt;
    vehicle.speed = vehicle.velocity.norm();
    vehicle.way = path.way(before, length, kSeenAhead);
  }
}

}  // namespace pedzone
