#include "view/vehicle_clearance.hpp"

#include "conflict/approach.hpp"
#include "world/speeds.hpp"

namespace pedzone {

VehicleClearance::VehicleClearance(const Recording& recording) : driving_(recording.times.size()) {
  for (const RecordedVehicle& vehicle : recording.vehicles) {
    for (const VehicleMoment& moment : vehicle.moments) {
      if (moment.speed < kHaltingSpeed) continue;
      driving_[moment.step].push_back(
          {moment.centre, unit(moment.heading), 0.5 * vehicle.length, 0.5 * vehicle.width});
    }
  }
}

std::optional<double> VehicleClearance::of(const Vec2& position, double radius,
                                           std::uint32_t step) const {
  std::optional<double> least;
  for (const Body& body : driving_[step]) {
    const Vec2 to = position - body.centre;
    // No nearer than the circle round the rectangle is.
    const double reach = radius + body.half_length + body.half_width;
    if (least && to.norm() - reach > *least) continue;
    Approach approach;
    approach.at = to_frame(body.axis, to);
    approach.sizes = {body.half_length, body.half_width, radius};
    const double room = clearance(approach);
    if (!least || room < *least) least = room;
  }
  return least;
}

}  // namespace pedzone
