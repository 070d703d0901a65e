#include "zone/open_space.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "zone/levels.hpp"
#include "zone/links.hpp"
#include "zone/passage.hpp"

namespace pedzone {
namespace {

constexpr double kLevelSampling = 5.0;  // [m] numerical: heights along a lane change little in this
constexpr double kInset = 0.5;  // [m] numerical: how far inside a lane its parts are looked up

/// The height of the zone at a place: that of its nearest lane.
double zone_height(const Network& network, const Selection& selection, const Vec2& place) {
  double least = std::numeric_limits<double>::infinity(), height = 0.0;
  for (const int index : selection.lanes) {
    const Lane& lane = network.lanes[index];
    const double distance = box_of(lane.shape).squaredExteriorDistance(place);
    if (distance >= least) continue;
    least = distance;
    height = height_near(lane, place);
  }
  return height;
}

/// A bridge over the zone or a tunnel under it: no place near the zone is on the zone's level.
bool on_another_level(const Network& network, const Selection& selection, const Lane& lane,
                      const Box& near) {
  if (lane.z.empty()) return false;
  bool apart = false;
  for (std::size_t i = 0; i + 1 < lane.shape.size(); ++i) {
    const Vec2 along = lane.shape[i + 1] - lane.shape[i];
    const int steps = 1 + static_cast<int>(along.norm() / kLevelSampling);
    for (int k = 0; k <= steps; ++k) {
      const Vec2 place = lane.shape[i] + along * (static_cast<double>(k) / steps);
      if (!near.contains(place)) continue;
      const double step = height_near(lane, place) - zone_height(network, selection, place);
      if (std::abs(step) <= kLevelStep) return false;
      apart = true;
    }
  }
  return apart;
}

bool holds_a_lane(const Network& network, const std::vector<int>& lanes, const Polygon& part) {
  const Box box = box_of(part.outer);
  return std::any_of(lanes.begin(), lanes.end(), [&](int lane) {
    const Vec2 place = inner_point(network.lanes[lane].shape, false, kInset);
    return box.contains(place) && contains({part}, place);
  });
}

}  // namespace

OpenSpaceReach open_space_reach(const Network& network, const ZoneSpec& spec,
                                const Selection& selection) {
  if (spec.open_space) return {*spec.open_space, selection.lanes};
  OpenSpaceReach reach{kOpenSpaceByDefault, {}};
  for (const int lane : selection.lanes) {
    if (has_type(network.edges[network.lanes[lane].edge], "highway.pedestrian")) {
      reach.lanes.push_back(lane);
    }
  }
  return reach;
}

Region bounding_roads(const Network& network, const Selection& selection,
                      const std::vector<bool>& in_a_zone, const Box& near) {
  const std::set<int> own(selection.edges.begin(), selection.edges.end());
  std::set<std::string> junctions;
  std::vector<Region> areas;
  for (int index = 0; index < static_cast<int>(network.edges.size()); ++index) {
    const Edge& edge = network.edges[index];
    if (edge.function != EdgeFunction::kNormal || own.contains(index)) continue;
    const bool road = is_road(network, index);
    if (!road && !in_a_zone[index]) continue;
    for (const int number : edge.lanes) {
      const Lane& lane = network.lanes[number];
      if (!near.intersects(box_of(lane))) continue;
      if (on_another_level(network, selection, lane, near)) continue;
      areas.push_back(area_of(lane));
      if (road) junctions.insert({edge.from, edge.to});
    }
  }
  for (const std::string& id : junctions) {
    const auto found = network.junction_index.find(id);
    if (found != network.junction_index.end()) {
      areas.push_back(repair(network.junctions[found->second].shape));
    }
  }
  return unite(areas);
}

Region with_open_space(const Network& network, const OpenSpaceReach& reach, const Region& base,
                       const Region& blocked) {
  if (reach.distance <= 0.0 || reach.lanes.empty()) return base;
  std::vector<Region> lanes;
  for (const int lane : reach.lanes) lanes.push_back(area_of(network.lanes[lane]));
  const Region open = subtract(grow(unite(lanes), reach.distance), blocked);
  // Gaps that nobody gets through do not lead to courtyards: only what a body can reach counts.
  Region reached;
  const Passages passages(unite(open, base));
  for (const Polygon& part : passages.parts()) {
    if (holds_a_lane(network, reach.lanes, part)) reached.push_back(part);
  }
  return unite(base, intersect(grow(reached, kBodyRoom, Corners::kMitred), open));
}

}  // namespace pedzone
