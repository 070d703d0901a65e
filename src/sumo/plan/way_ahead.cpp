#include "sumo/plan/way_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sumo/plan/lane_end.hpp"
#include "sumo/plan/other_levels.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kMostLanes = 8;  // numerical: that one vehicle stands on at once
constexpr double kFits = 0.1;          // [rad] numerical: SUMO's heading is that of the chord from
                                       // rear to front, but for a change of lanes
constexpr double kChord = 0.1;         // [m] numerical
constexpr double kDrifts = 0.2;        // [m/s] numerical: slower nobody changes lanes
constexpr double kThere = 0.05;        // [m] numerical: so near to a lane's middle it is there
constexpr double kSoon = 0.1;          // [m] numerical: one that stands may change lanes, too

/// Adds the part of a lane's line from `offset` [m] on, `lateral` [m] to its left and at most
/// `left` [m] long, which it then shortens.
void append_from(const Polyline& line, double offset, double lateral, double& left, Polyline& out) {
  double passed = 0.0;
  for (std::size_t i = 1; i < line.size() && left > 0.0; ++i) {
    const Vec2 piece = line[i] - line[i - 1];
    const double length = piece.norm();
    if (length <= 0.0) continue;
    if (passed + length > offset) {
      const double begin = std::max(0.0, offset - passed);
      const double taken = std::min(left, length - begin);
      out.push_back(line[i - 1] + piece * ((begin + taken) / length) +
                    left_of(piece / length) * lateral);
      left -= taken;
    }
    passed += length;
  }
}

/// Adds the part of a lane's line before `offset` [m], backwards, `lateral` [m] to its left and at
/// most `left` [m] long, which it then shortens.
void append_before(const Polyline& line, double offset, double lateral, double& left,
                   Polyline& out) {
  const Polyline backwards(line.rbegin(), line.rend());
  append_from(backwards, std::max(0.0, length_of(line) - offset), -lateral, left, out);
}

/// Makes a line end so far [m] from its beginning: cut off, or straight on.
void end_at(double length, Polyline& line) {
  double passed = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 piece = line[i] - line[i - 1];
    const double here = piece.norm();
    const bool last = i + 1 == line.size();
    if (here > 0.0 && (last || passed + here >= length)) {
      line[i] = line[i - 1] + piece * ((length - passed) / here);
      line.resize(i + 1);
    }
    passed += here;
  }
}

bool is_signalled(const Junction& junction) {
  return junction.type.starts_with("traffic_light") || junction.type.starts_with("rail_");
}

/// From its rear to its front by its heading.
Polyline straight_behind(const FleetVehicle& vehicle) {
  return {vehicle.front - unit(vehicle.heading) * vehicle.traits.length, vehicle.front};
}

}  // namespace

WayAhead::WayAhead(const Network& network, const std::vector<Zone>& zones)
    : network_(network),
      apart_(lanes_on_other_levels(network, zones)),
      zone_of_lane_(network.lanes.size(), -1),
      connections_from_(network.lanes.size()) {
  for (std::size_t z = 0; z < zones.size(); ++z) {
    for (const int lane : zones[z].lanes) zone_of_lane_[lane] = static_cast<int>(z);
  }
  for (std::size_t i = 0; i < network.connections.size(); ++i) {
    connections_from_[network.connections[i].from].push_back(static_cast<int>(i));
  }
}

/// How a lane leads to that edge: onto one of the lanes that the vehicle `means` to take, if it
/// does; null: not at all.
const Connection* WayAhead::leading(int lane, int edge, std::span<const int> means) const {
  const Connection* first = nullptr;
  for (const int i : connections_from_[lane]) {
    const Connection& connection = network_.connections[i];
    if (network_.lanes[connection.to].edge != edge) continue;
    if (std::ranges::find(means, connection.to) != means.end()) return &connection;
    if (first == nullptr) first = &connection;
  }
  return first;
}

/// The lane after `lane` on the way along the vehicle's route, of which the edge at `index` was
/// last reached; -1 at the end. A lane that does not lead on stands for a lane change: its
/// neighbour's way.
int WayAhead::next_lane(int lane, const VehicleSeen& vehicle, int& index) const {
  const std::span<const int> route = vehicle.route;
  if (index + 1 >= static_cast<int>(route.size())) return -1;
  const Connection* on = leading(lane, route[index + 1], vehicle.means);
  for (const int other : network_.edges[network_.lanes[lane].edge].lanes) {
    if (on != nullptr) break;
    on = leading(other, route[index + 1], vehicle.means);
  }
  if (on == nullptr) return -1;
  if (on->via >= 0) return on->via;
  ++index;
  return on->to;
}

void WayAhead::remember(const FleetVehicle& before, FleetVehicle& vehicle) const {
  if (vehicle.lane == before.lane) {
    vehicle.behind = before.behind;
    return;
  }
  if (before.lane < 0 || vehicle.lane < 0) return;
  std::vector<int> behind = before.behind;
  int lane = before.lane, index = before.route_index;
  for (std::size_t k = 0; k < kMostLanes && lane >= 0 && lane != vehicle.lane; ++k) {
    behind.insert(behind.begin(), lane);
    lane = next_lane(lane, vehicle, index);
  }
  if (lane != vehicle.lane) return;  // it has changed lanes, or was put elsewhere
  behind.resize(std::min(behind.size(), kMostLanes));
  vehicle.behind = std::move(behind);
}

/// From its rear to its front, which is at `offset` [m] of its lane.
Polyline WayAhead::way_behind(const FleetVehicle& vehicle, double offset) const {
  const double length = vehicle.traits.length;
  const Polyline straight = straight_behind(vehicle);
  Polyline back{vehicle.front};
  double left = length;
  append_before(network_.lanes[vehicle.lane].shape, offset, vehicle.lateral, left, back);
  for (const int lane : vehicle.behind) {
    if (left <= 0.0) break;
    const Polyline& shape = network_.lanes[lane].shape;
    append_before(shape, length_of(shape), vehicle.lateral, left, back);
  }
  // SUMO has the rear of one that it inserted on a lane shorter than itself straight behind that.
  const std::size_t n = back.size();
  if (left > 0.0 && n > 1) {
    const Vec2 piece = back[n - 1] - back[n - 2];
    if (piece.norm() > 0.0) back.push_back(back[n - 1] + piece.normalized() * left);
  }
  // Beside a lane's middle a bend is shorter or longer.
  if (vehicle.lateral != 0.0) end_at(length, back);
  // SUMO's heading is that of the whole; of one that bends, in 1.18, of its first part.
  const auto fits = [&](double to) {
    const Vec2 chord = back.front() - point_on(back, to).point;
    return chord.norm() > kChord && std::abs(wrap_angle(angle_of(chord) - vehicle.heading)) < kFits;
  };
  const VehicleParts& parts = vehicle.traits.parts;
  if (!fits(length) && !(parts.bends() && fits(part_of(parts, length, 0).length))) return straight;
  return {back.rbegin(), back.rend()};
}

bool WayAhead::is_internal(int lane) const {
  return network_.edges[network_.lanes[lane].edge].function == EdgeFunction::kInternal;
}

/// [m] of a junction's lanes behind the front, which is at `offset` [m] of one of them; 0: it is
/// not.
double WayAhead::way_inside(const FleetVehicle& vehicle, double offset) const {
  if (!is_internal(vehicle.lane)) return 0.0;
  double way = offset;
  for (const int lane : vehicle.behind) {
    if (!is_internal(lane)) break;
    way += length_of(network_.lanes[lane].shape);
  }
  return way;
}

std::optional<WayAhead::Drift> WayAhead::drift_ahead(const FleetVehicle& vehicle,
                                                     double offset) const {
  if (std::abs(vehicle.drift) < kDrifts || is_internal(vehicle.lane)) return std::nullopt;
  const double side = vehicle.drift < 0.0 ? -1.0 : 1.0;
  const double away = side * vehicle.lateral;  // < 0: it comes to the middle of this lane
  double to = away < -kThere ? 0.0 : std::numeric_limits<double>::infinity();
  for (const Beside& other : neighbours(vehicle.lane)) {
    const Vec2 there = point_on(network_.lanes[other.lane].shape, offset).point;
    const double middle =
        side * (project_on(network_.lanes[vehicle.lane].shape, there).lateral + other.aside);
    if (middle > away + kThere) to = std::min(to, middle);
  }
  if (std::isinf(to)) return std::nullopt;
  return Drift{side * to, (to - away) / std::abs(vehicle.drift) * vehicle.speed};
}

/// Adds the part of its lane's way on which it drifts to where it will drive on. Returns how far
/// [m] beside its lane's middle that is, to the left.
double WayAhead::append_drift(const FleetVehicle& vehicle, double& offset, double& left,
                              Polyline& way) const {
  const auto drift = drift_ahead(vehicle, offset);
  if (!drift) return vehicle.lateral;
  const Polyline& shape = network_.lanes[vehicle.lane].shape;
  const double along = std::min({drift->way, left, length_of(shape) - offset});
  const double share = drift->way > 0.0 ? along / drift->way : 1.0;
  const double lateral = std::lerp(vehicle.lateral, drift->lateral, share);
  offset += along;
  left -= along;
  const LinePoint there = point_on(shape, offset);
  way.push_back(there.point + left_of(there.direction) * lateral);
  return lateral;
}

void WayAhead::look(FleetVehicle& vehicle, double distance) const {
  Polyline& way = vehicle.way;
  way = straight_behind(vehicle);
  if (vehicle.lane < 0) {
    way.push_back(vehicle.front + unit(vehicle.heading) * distance);
    return;
  }
  int lane = vehicle.lane;
  int index = vehicle.route_index;
  int zone = -1;
  double offset = project_on(network_.lanes[lane].shape, vehicle.front).offset;
  double left = distance;
  way = way_behind(vehicle, offset);
  const Lane& own = network_.lanes[lane];
  const bool in_zone = zone_of_lane_[lane] >= 0;
  if (in_zone && leaves_no_stripe(own, vehicle.traits))
    vehicle.tight_end = length_of(own.shape) - offset;
  JunctionAhead& junction = vehicle.junction;
  junction = {};
  const double came_in = way_inside(vehicle, offset);
  const double lateral = append_drift(vehicle, offset, left, way);
  const bool yields = vehicle.traits.yields && !vehicle.traits.external;
  bool passed = false;
  while (lane >= 0 && left > 0.0 && !is_apart(lane)) {
    const bool inside = is_internal(lane);
    const double begin = distance - left;
    const std::vector<int>& crossings = network_.lanes[lane].yields_at;
    if (yields) {
      vehicle.yields_at.insert(vehicle.yields_at.end(), crossings.begin(), crossings.end());
    }
    // One that overtakes on the opposite lane is back on its own at the junction.
    const bool is_back = vehicle.overtakes && lane != vehicle.lane;
    append_from(network_.lanes[lane].shape, offset, is_back ? 0.0 : lateral, left, way);
    if (inside && !passed) {
      if (junction.junction < 0) {
        junction = {junction_after(vehicle.route, index), begin - came_in};
        junction.signalled =
            junction.junction >= 0 && is_signalled(network_.junctions[junction.junction]);
      }
      junction.end = distance - left;
    }
    passed = passed || (!inside && junction.junction >= 0);
    if (zone < 0) zone = zone_of_lane_[lane];
    offset = 0.0;
    lane = next_lane(lane, vehicle, index);
  }
  const bool at_end = index + 1 == static_cast<int>(vehicle.route.size());
  vehicle.leaves = left > 0.0 && (at_end || is_apart(lane));
  vehicle.zone = std::max(0, zone);
}

/// Lanes for vehicles on both sides, that for the other direction included: SUMO's vehicles change
/// lanes inside junctions, too.
std::vector<WayAhead::Beside> WayAhead::neighbours(int lane) const {
  const Edge& edge = network_.edges[network_.lanes[lane].edge];
  std::vector<Beside> found;
  const auto add = [&](int other) {
    if (network_.lanes[other].vehicles) found.push_back({other, 0.0});
  };
  const auto at = std::ranges::find(edge.lanes, lane);
  if (at != edge.lanes.begin()) add(*std::prev(at));
  if (at != edge.lanes.end() && std::next(at) != edge.lanes.end()) add(*std::next(at));
  const Lane& own = network_.lanes[lane];
  if (own.opposite >= 0) {
    const Vec2& there = network_.lanes[own.opposite].shape.front();
    found.push_back({lane, project_on(own.shape, there).lateral});
  }
  return found;
}

/// Adds `left` [m] of the way from `offset` [m] on the lane on, where the edge of its
/// route at `index` was reached.
void WayAhead::append_way(const Beside& from, const VehicleSeen& vehicle, int index, double offset,
                          double left, Polyline& way) const {
  const double lateral = vehicle.lateral + from.aside;
  for (int lane = from.lane; lane >= 0 && left > 0.0; lane = next_lane(lane, vehicle, index)) {
    append_from(network_.lanes[lane].shape, offset, lateral, left, way);
    offset = 0.0;
  }
}

std::vector<Polyline> WayAhead::beside(const FleetVehicle& vehicle, double soon,
                                       double distance) const {
  std::vector<Polyline> ways;
  if (vehicle.lane < 0 || vehicle.overtakes) return ways;
  Polyline own = straight_behind(vehicle);
  double offset = project_on(network_.lanes[vehicle.lane].shape, vehicle.front).offset;
  int lane = vehicle.lane, index = vehicle.route_index;
  const double reach = std::max(soon, kSoon);
  for (double left = reach; lane >= 0 && left > 0.0;) {
    const double gone = reach - left;
    for (const Beside& other : neighbours(lane)) {
      const Polyline& shape = network_.lanes[other.lane].shape;
      const double from = gone > 0.0 ? 0.0 : project_on(shape, vehicle.front).offset;
      LinePoint begin = point_on(shape, from);
      begin.point += left_of(begin.direction) * other.aside;
      Polyline way = {begin.point - begin.direction * vehicle.traits.length, begin.point};
      if (gone > 0.0) {  // put over sideways on its way there
        way = own;
        for (Vec2& point : way) point += begin.point - own.back();
      }
      append_way(other, vehicle, index, from, distance - gone, way);
      ways.push_back(std::move(way));
    }
    append_from(network_.lanes[lane].shape, offset, vehicle.lateral, left, own);
    offset = 0.0;
    lane = next_lane(lane, vehicle, index);
  }
  return ways;
}

/// The junction before the edge that a route comes to after route[index]; -1: none.
int WayAhead::junction_after(std::span<const int> route, int index) const {
  if (index + 1 >= static_cast<int>(route.size()) || route[index + 1] < 0) return -1;
  const auto found = network_.junction_index.find(network_.edges[route[index + 1]].from);
  return found == network_.junction_index.end() ? -1 : found->second;
}

}  // namespace pedzone
