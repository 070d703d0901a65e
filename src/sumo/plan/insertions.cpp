#include "sumo/plan/insertions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "core/random.hpp"
#include "zone/lane_geometry.hpp"

namespace pedzone {
namespace {

constexpr double kNotice = 4.0;  // [s] assumed: a step aside takes less
constexpr double kBehind = 0.6;  // [m] assumed: room behind its rear
constexpr double kBar = 0.02;    // [m] numerical: length of what claims the room; it is no body
constexpr double kSample = 1.0;  // [m] numerical
// [m] people keep so much less to each side than of a vehicle that drives past: who has room beside
// it on a lane of 3.2 m is left where it is. Not so where a wider lane has room for both.
constexpr double kSides = 0.25;
constexpr double kRoomBeside = 1.0;  // [m] assumed
// [s] assumed: SUMO may wait for a gap in traffic for long, and people have to get past meanwhile.
constexpr double kClaimsFor = 20.0, kClaimsEvery = 30.0;

/// From `begin` to `end` [m] along a lane's shape, `lateral` [m] to the left of it, and straight on
/// before its begin.
Polyline along(const Lane& lane, double begin, double end, double lateral) {
  Polyline way;
  const auto add = [&](double at) {
    const LinePoint there = point_on(lane.shape, std::max(0.0, at));
    const Vec2 beside = lateral * left_of(there.direction);
    way.push_back(there.point + std::min(0.0, at) * there.direction + beside);
  };
  if (begin < 0.0) add(begin);
  for (double at = std::max(0.0, begin); at < end; at += kSample) add(at);
  add(end);
  return way;
}

/// Whether a vehicle stands there.
bool is_taken(const Polyline& way, const Fleet& fleet) {
  return std::ranges::any_of(
      way, [&](const Vec2& point) { return fleet.waiting_beside(point, kBar) != nullptr; });
}

}  // namespace

Insertions::Insertions(const Network& network, std::vector<Departure> departures)
    : network_(network), departures_(std::move(departures)) {
  for (std::size_t k = 0; k < departures_.size(); ++k) index_[departures_[k].vehicle].push_back(k);
}

/// Where a vehicle may begin. With SUMO's option --scale there are copies of one: car.1, car.2 ...
std::vector<const Departure*> Insertions::planned(const std::string& vehicle) const {
  auto found = index_.find(vehicle);
  if (found == index_.end()) found = index_.find(vehicle.substr(0, vehicle.rfind('.')));
  std::vector<const Departure*> places;
  if (found == index_.end()) return places;
  for (const std::size_t k : found->second) places.push_back(&departures_[k]);
  return places;
}

/// Those whose place is claimed.
std::vector<const Departure*> Insertions::expected(double time,
                                                   const std::vector<std::string>& pending) const {
  std::vector<const Departure*> all;
  std::unordered_set<int> edges;
  for (const std::string& vehicle : pending) {
    for (const Departure* const departure : planned(vehicle)) {
      if (!edges.insert(departure->edge).second) continue;
      const double late = std::max(0.0, time - departure->time);
      if (std::fmod(late, kClaimsEvery) < kClaimsFor) all.push_back(departure);
    }
  }
  for (std::size_t k = next_; k < departures_.size(); ++k) {
    if (departures_[k].time > time + kNotice) break;
    all.push_back(&departures_[k]);
  }
  return all;
}

void Insertions::add_claim(const Departure& departure, int lane, const Fleet& fleet,
                           std::vector<VehicleState>& out) {
  const Lane& there = network_.lanes[lane];
  const double front = std::min(departure.position, there.length) * shape_scale(there);
  const double rear = std::max(0.0, front - departure.length);
  const double width = departure.lateral ? departure.width : there.width;
  const double beside = 0.5 * (there.width - width);
  const double most = std::max(0.0, beside);
  const double lateral = std::clamp(departure.lateral.value_or(0.0), -most, most);
  ways_.push_back(along(there, rear - kBehind, front, lateral));
  if (is_taken(ways_.back(), fleet)) return;
  VehicleState state;
  const Vec2 along_way = ways_.back()[1] - ways_.back()[0];
  state.heading = angle_of(along_way);
  state.centre = ways_.back().front() + 0.5 * kBar * unit(state.heading);
  state.claim = length_of(ways_.back()) + kBehind;
  state.length = kBar;
  state.claimed = std::numeric_limits<double>::infinity();  // it cannot wait
  const double sides = beside < kRoomBeside ? kSides : 0.0;
  state.width = std::max(kBar, width - 2.0 * sides);
  state.key = person_key(departure.vehicle);
  state.way = ways_.back();
  out.push_back(state);
}

void Insertions::add_claims(double time, double dt, const std::vector<std::string>& pending,
                            const Fleet& fleet, std::vector<VehicleState>& out) {
  while (next_ < departures_.size() && departures_[next_].time <= time - dt) ++next_;
  ways_.clear();
  for (const Departure* departure : expected(time, pending)) {
    for (const int lane : network_.edges[departure->edge].lanes) {
      const bool wished = departure->lane < 0 || departure->lane == lane;
      if (wished && network_.lanes[lane].lets_in(departure->its_class)) {
        add_claim(*departure, lane, fleet, out);
      }
    }
  }
}

}  // namespace pedzone
