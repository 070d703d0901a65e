#include "crowd/sense/street_traffic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kUpstream = 150.0;  // [m] assumed: nobody looks farther beyond a street's ends
constexpr double kAligned = 0.8;     // numerical: cosine; who drives more across turns off
constexpr double kSlow = 5.0;        // [m/s] assumed: slower vehicles may be about to speed up ...
constexpr double kPull = 1.0;        // [m/s²] assumed: ... by so much
constexpr double kFlowTime = 120.0;  // [s] assumed: over which people know how busy a street is

/// On the carriageway or straight before it.
std::optional<StreetVehicle> on_street(const Street& street, const VehicleState& vehicle,
                                       std::uint32_t index) {
  const Vec2 heading = unit(vehicle.heading);
  const Vec2 front = vehicle.centre + heading * (0.5 * vehicle.length);
  const StreetPlace place = street.place(front);
  if (place.s < -kUpstream || place.s > street.length + kUpstream) return std::nullopt;
  const CrossingPlace& here = street.at(place.s);  // parked cars stand beside the lanes, too
  if (place.t < here.low || place.t > here.high) return std::nullopt;
  const double along = heading.dot(place.direction);
  if (std::abs(along) < kAligned) return std::nullopt;
  return as_seen(vehicle, index, place.s, place.t, vehicle.width, along > 0.0 ? 1 : -1);
}

/// One that will turn into it: as if it came straight.
std::optional<StreetVehicle> turning_in(const Street& street, const VehicleState& vehicle,
                                        std::uint32_t index) {
  double driven = 0.0;
  for (std::size_t k = 0; k + 1 < vehicle.way.size(); ++k) {
    const Vec2 line = vehicle.way[k + 1] - vehicle.way[k];
    driven += line.norm();
    const StreetPlace place = street.place(vehicle.way[k + 1]);
    if (place.s < 0.0 || place.s > street.length) continue;
    if (place.t < street.low || place.t > street.high || line.norm() <= 0.0) continue;
    const double along = line.normalized().dot(place.direction);
    if (std::abs(along) < kAligned) continue;
    const int direction = along > 0.0 ? 1 : -1;
    const double front = place.s - direction * (driven - vehicle.gone - vehicle.length);
    return as_seen(vehicle, index, front, place.t, vehicle.width, direction);
  }
  return std::nullopt;
}

/// What passes in a second, by how many are on the street and how fast: q = k v.
double flow_on(const Street& street, const std::vector<StreetVehicle>& vehicles) {
  double sum = 0.0;
  for (const StreetVehicle& vehicle : vehicles) {
    if (vehicle.front >= 0.0 && vehicle.front <= street.length) sum += vehicle.speed;
  }
  return sum / street.length;
}

}  // namespace

double time_to_drive(const StreetVehicle& vehicle, double distance) {
  if (distance <= 0.0) return 0.0;
  const double v = vehicle.speed;
  if (v < kStaticSpeed) return std::numeric_limits<double>::infinity();
  if (v >= kSlow) return distance / v;
  return (std::sqrt(v * v + 2.0 * kPull * distance) - v) / kPull;
}

StreetVehicle as_seen(const VehicleState& vehicle, std::uint32_t index, double front, double t,
                      double width, int direction) {
  StreetVehicle seen;
  seen.vehicle = index;
  seen.front = front;
  seen.length = vehicle.length;
  seen.speed = vehicle.velocity.norm();
  seen.low = t - 0.5 * width;
  seen.high = t + 0.5 * width;
  seen.direction = direction;
  return seen;
}

void observe_streets(const std::vector<Street>& streets, const std::vector<VehicleState>& vehicles,
                     double dt, std::vector<StreetTraffic>& traffic) {
  traffic.resize(streets.size());
  for (std::size_t k = 0; k < streets.size(); ++k) {
    StreetTraffic& here = traffic[k];
    here.vehicles.clear();
    for (std::uint32_t v = 0; v < vehicles.size(); ++v) {
      auto seen = on_street(streets[k], vehicles[v], v);
      if (!seen) seen = turning_in(streets[k], vehicles[v], v);
      if (seen) here.vehicles.push_back(*seen);
    }
    // A mean of all so far, then of the last while.
    here.observed = std::min(here.observed + dt, kFlowTime);
    here.flow += (flow_on(streets[k], here.vehicles) - here.flow) * dt / here.observed;
  }
}

}  // namespace pedzone
