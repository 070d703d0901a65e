#include "sumo/plan/insertions.hpp"

#include <algorithm>
#include <limits>
#include <string_view>
#include <unordered_set>

#include "core/random.hpp"

namespace pedzone {
namespace {

constexpr double kNotice = 4.0;  // [s] assumed: a step aside takes less
constexpr double kBehind = 0.6;  // [m] assumed: room behind its rear
constexpr double kBar = 0.02;    // [m] numerical: length of what claims the room; it is no body
constexpr double kSample = 1.0;  // [m] numerical
// [m] people keep so much less to each side than of a vehicle that drives past: who has room beside
// it on a lane of 3.2 m is left where it is.
constexpr double kSides = 0.25;

/// From `begin` to `end` [m] along a lane, and straight on before its begin.
Polyline along(const Lane& lane, double begin, double end) {
  Polyline way;
  const LinePoint first = point_on(lane.shape, std::max(0.0, begin));
  if (begin < 0.0) way.push_back(first.point + first.direction * begin);
  for (double at = std::max(0.0, begin); at < end; at += kSample) {
    way.push_back(point_on(lane.shape, at).point);
  }
  way.push_back(point_on(lane.shape, end).point);
  return way;
}

}  // namespace

void Insertions::add_claim(const Departure& departure, int lane, std::vector<VehicleState>& out) {
  const Lane& there = network_.lanes[lane];
  const double front = std::min(departure.position, there.length);
  const double rear = std::max(0.0, front - departure.length);
  ways_.push_back(along(there, rear - kBehind, front));
  VehicleState state;
  const Vec2 along_way = ways_.back()[1] - ways_.back()[0];
  state.heading = angle_of(along_way);
  state.centre = ways_.back().front() + 0.5 * kBar * unit(state.heading);
  state.claim = length_of(ways_.back()) + kBehind;
  state.length = kBar;
  state.claimed = std::numeric_limits<double>::infinity();  // it cannot wait
  state.width = std::max(kBar, departure.width - 2.0 * kSides);
  state.key = person_key(departure.vehicle);
  state.way = ways_.back();
  out.push_back(state);
}

void Insertions::add_claims(double time, const Fleet& fleet, std::vector<VehicleState>& out) {
  while (next_ < departures_.size() && departures_[next_].time < time - kNotice) ++next_;
  ways_.clear();
  std::size_t last = next_;
  while (last < departures_.size() && departures_[last].time <= time + kNotice) ++last;
  if (last == next_) return;
  std::unordered_set<std::string_view> there;
  for (const FleetVehicle& vehicle : fleet.vehicles()) there.insert(vehicle.id);
  // Spans into them are given away.
  std::size_t lanes = 0;
  for (std::size_t k = next_; k < last; ++k) {
    lanes += network_.edges[departures_[k].edge].lanes.size();
  }
  ways_.reserve(lanes);
  for (std::size_t k = next_; k < last; ++k) {
    const Departure& departure = departures_[k];
    if (there.contains(departure.vehicle)) continue;
    for (const int lane : network_.edges[departure.edge].lanes) {
      const bool wished = departure.lane < 0 || departure.lane == lane;
      if (wished && network_.lanes[lane].vehicles) add_claim(departure, lane, out);
    }
  }
}

}  // namespace pedzone
