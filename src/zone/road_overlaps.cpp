#include "zone/road_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "core/text.hpp"
#include "geometry/polyline.hpp"
#include "zone/levels.hpp"
#include "zone/obstacles.hpp"
#include "zone/open_space.hpp"
#include "zone/shapes.hpp"

namespace pedzone {
namespace {

// assumed: less is two shapes that touch, or a way over the road at a right angle.
constexpr double kShare = 0.25;
constexpr double kCovered = 5.0;    // [m] assumed: farther than people step back for a vehicle
constexpr double kRoom = 0.5;       // [m] assumed: a body's width
constexpr double kAside = 5.0;      // [m] assumed: so far people go to the side of their way
constexpr double kAlong = 0.87;     // cos 30°; assumed: at a larger angle they cross it
constexpr double kStep = 1.0;       // [m] numerical, along a lane
constexpr double kBorder = 0.1;     // [m] numerical: a road's lanes leave no slit between them
constexpr double kSideStep = 0.25;  // [m] numerical

/// Lanes for vehicles only, between junctions.
std::vector<const Lane*> roads_of(const Network& network) {
  std::vector<const Lane*> roads;
  for (const Lane& lane : network.lanes) {
    const bool between_junctions = network.edges[lane.edge].function == EdgeFunction::kNormal;
    if (lane.vehicles_only() && between_junctions) roads.push_back(&lane);
  }
  return roads;
}

std::vector<Box> boxes_of(const std::vector<const Lane*>& lanes) {
  std::vector<Box> boxes;
  for (const Lane* lane : lanes) boxes.push_back(box_of(*lane));
  return boxes;
}

/// Those of `others` that are on the level of that lane, and not of its own street.
std::vector<const Lane*> beside(const Lane& lane, std::vector<const Lane*> others) {
  std::erase_if(others, [&](const Lane* other) {
    return other->edge == lane.edge || on_different_levels(lane, *other);
  });
  return others;
}

bool is_on(const Lane& lane, const Vec2& point) {
  return std::abs(project_on(lane.shape, point).lateral) <= 0.5 * lane.width + kBorder;
}

/// The way of people along a lane, among the roads and the ground for people round it.
struct Way {
  const Lane& lane;
  bool open = false;  ///< with open space beside it, as far as no road bounds that
  std::vector<const Lane*> roads, ground;

  /// The road that people are on who walk along there with no room beside it; null: none.
  const Lane* cover_at(const LinePoint& place) const {
    const auto road = std::ranges::find_if(roads, [&](const Lane* one) {
      if (!is_on(*one, place.point)) return false;
      const double at = project_on(one->shape, place.point).offset;
      return std::abs(point_on(one->shape, at).direction.dot(place.direction)) > kAlong;
    });
    const Vec2 left = left_of(place.direction);
    const bool covered = road != roads.end() && !has_room(place, left) && !has_room(place, -left);
    return covered ? *road : nullptr;
  }

  bool has_room(const LinePoint& place, const Vec2& side) const {
    double room = 0.0;
    for (double aside = 0.0; aside <= kAside && room <= kRoom; aside += kSideStep) {
      const Vec2 point = place.point + side * aside;
      const auto here = [&](const Lane* one) { return is_on(*one, point); };
      const bool on_road = std::ranges::any_of(roads, here);
      const bool on_ground = is_on(lane, point) || std::ranges::any_of(ground, here);
      if (!on_ground && (on_road || !open)) return false;
      room = on_road ? 0.0 : room + kSideStep;
    }
    return room > kRoom;
  }

  /// The roads that cover it without a break, for as long as people cannot pass under them; empty:
  /// it is nowhere so.
  std::vector<const Lane*> covers() const {
    const double length = length_of(lane.shape);
    std::vector<const Lane*> found;
    double covered = 0.0;
    for (double at = 0.0; at <= length; at += kStep) {
      const Lane* const road = cover_at(point_on(lane.shape, at));
      if (road == nullptr && covered >= kCovered) break;
      covered = road == nullptr ? 0.0 : covered + kStep;
      if (road == nullptr) found.clear();
      if (road != nullptr && std::ranges::find(found, road) == found.end()) found.push_back(road);
    }
    return covered >= kCovered ? found : std::vector<const Lane*>{};
  }
};

/// Whether that lane is on ground that the user has drawn.
bool is_on_polygon(const Network& network, const ZoneSpec& spec, const Lane& lane) {
  const Box box = box_of(lane);
  return std::ranges::any_of(network.polygons, [&](const MapPolygon& polygon) {
    return is_walkable(polygon, spec) && box_of(polygon.shape).intersects(box);
  });
}

/// Whether other vehicles than bicycles drive there, beside which people would find room.
bool is_for_wide_ones(const Lane* road) {
  return (road->road_classes & ~road_class("bicycle")) != 0;
}

std::string names_of(const std::vector<const Lane*>& lanes) {
  return comma_list(lanes, [](const Lane* lane) { return "'" + lane->id + "'"; });
}

/// The edges on which roads cover people for long, with the names of those roads.
std::map<int, std::string> covered_edges(const Network& network, const PlacedLanes& roads,
                                         const ZoneSpec& spec, const Selection& selection) {
  std::vector<const Lane*> own;
  for (const int lane : selection.lanes) own.push_back(&network.lanes[lane]);
  const PlacedLanes ground(own);
  const OpenSpaceReach reach = open_space_reach(network, spec, selection);
  std::map<int, std::string> covered;
  for (const int index : selection.lanes) {
    const Lane& lane = network.lanes[index];
    if (lane.vehicles || is_on_polygon(network, spec, lane)) continue;
    const Box near = grown(box_of(lane), kAside);
    const bool open = reach.distance > 0.0 && std::ranges::binary_search(reach.lanes, index);
    Way way{lane, open, beside(lane, roads.meeting(near)), beside(lane, ground.meeting(near))};
    std::erase_if(way.roads, std::not_fn(is_for_wide_ones));
    const auto found = way.covers();
    if (!found.empty()) covered[lane.edge] = names_of(found);
  }
  return covered;
}

}  // namespace

PlacedLanes::PlacedLanes(std::vector<const Lane*> lanes)
    : lanes_(std::move(lanes)), tree_(boxes_of(lanes_)) {}

std::vector<const Lane*> PlacedLanes::meeting(const Box& box) const {
  std::vector<const Lane*> found;
  for (const std::size_t k : tree_.meeting(box)) found.push_back(lanes_[k]);
  return found;
}

RoadOverlaps::RoadOverlaps(const Network& network) : network_(network), roads_(roads_of(network)) {}

void RoadOverlaps::leave_out_covered(const ZoneSpec& spec, Selection& selection,
                                     std::vector<std::string>& warnings) const {
  const auto covered = covered_edges(network_, roads_, spec, selection);
  if (covered.size() == selection.edges.size()) return;
  for (const auto& [edge, roads] : covered) {
    warnings.push_back("edge '" + network_.edges[edge].id + "' runs under " + roads +
                       ", with no room beside: left out (a polygon of type pedzone.walkable round "
                       "it keeps it in)");
  }
  leave_out(
      network_, [&](int edge) { return covered.contains(edge); }, selection);
}

void RoadOverlaps::warn(const Selection& selection, std::vector<std::string>& warnings) const {
  for (const int index : selection.lanes) {
    const Lane& lane = network_.lanes[index];
    const Region ground = area_of(lane);
    std::vector<const Lane*> under;
    double covered = 0.0;
    for (const Lane* other : beside(lane, roads_.meeting(box_of(lane)))) {
      const double common = area(intersect(ground, area_of(*other)));
      if (common <= 0.0) continue;
      covered += common;
      under.push_back(other);
    }
    if (covered < kShare * area(ground)) continue;
    warnings.push_back("lane '" + lane.id + "' runs on " + names_of(under) +
                       ", which stays SUMO's: people and its vehicles meet there");
  }
}

}  // namespace pedzone
