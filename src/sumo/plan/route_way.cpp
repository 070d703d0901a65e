#include "sumo/plan/route_way.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "geometry/box.hpp"
#include "zone/lane_geometry.hpp"

namespace pedzone {
namespace {

constexpr double kFar = 30.0;      // [m] assumed: nobody cuts a corner by so much ...
constexpr double kShorter = 0.5;   // assumed: ... and leaves so much of its way
constexpr double kShortCut = 0.9;  // assumed: so much shorter a way over open space is taken
constexpr double kStreets = 0.7;   // assumed: no open space, where so much of it is edges; the
                                   // rest are junctions
constexpr double kLook = 5.0;      // [m] numerical: apart are the places looked at
constexpr double kSameSide = 5.0;  // [m] assumed: so far from an edge somebody is still on it
constexpr double kSeen = 30.0;     // [m] assumed: from so far one is seen to walk along a street
constexpr double kAsLong = 3.0;    // [m] assumed: no more than twice that shorter is as long
constexpr double kBeside = 1.0;    // [m] assumed: of the lane, that is as good

/// That people walk on, of edge k of the route.
const Lane& lane_of(const RoutePart& part, int k) {
  return part.network.lanes[walking_lane(part.network, part.route[k])];
}

Waypoint waypoint_on(const RoutePart& part, int k, const Vec2& place) {
  return {part.zone.walls.nearest_inside(place, kWayClearance),
          0.5 * lane_of(part, k).width + kBeside};
}

std::vector<Waypoint> by_ends(const RoutePart& part, const std::vector<Vec2>& ends) {
  std::vector<Waypoint> path;
  for (std::size_t k = 0; k < ends.size(); k += 2) {
    path.push_back(waypoint_on(part, part.first + static_cast<int>(k / 2), ends[k]));
  }
  return path;
}

/// The crowd's way by places that it is made to come by.
class WayBy {
 public:
  WayBy(const WayFinder& ways, const Vec2& from, const Vec2& to) : ways_(ways) {
    const auto way = piece(from, to);
    if (way) pieces_ = {*way};
  }

  bool exists() const { return !pieces_.empty(); }

  double length() const {
    double sum = 0.0;
    for (const Polyline& piece : pieces_) sum += length_of(piece);
    return sum - twice_;
  }

  /// Whether a place on it every kLook is where `is_such` says, by the share of them.
  template <typename Predicate>
  double share(const Predicate& is_such) const {
    int such = 0, all = 0;
    for (const Polyline& piece : pieces_) {
      LineWalk walk(piece);
      for (double at = 0.0; at < length_of(piece); at += kLook, ++all) {
        such += is_such(walk.to(at).point) ? 1 : 0;
      }
    }
    return static_cast<double>(such) / std::max(1, all);
  }

  Box box() const {
    Box all;
    for (const Polyline& piece : pieces_) all.extend(box_of(piece));
    return all;
  }

  /// The place [m] on it that is nearest to a point.
  Vec2 nearest(const Vec2& point) const {
    Vec2 best = pieces_.front().front();
    for (const Polyline& piece : pieces_) {
      const Vec2 at = point_on(piece, project_on(piece, point).offset).point;
      if ((at - point).norm() < (best - point).norm()) best = at;
    }
    return best;
  }

  /// One of its pieces leads by that waypoint from now on. The next one begins where people count
  /// as having come by it, `radius` before it: from there it may be less far to turn back. False
  /// where there is no way.
  bool lead_by(const Waypoint& waypoint, std::size_t number) {
    Polyline& all = pieces_[number];
    auto there = piece(all.front(), waypoint.at);
    if (!there) return false;
    const Vec2 end = point_on(*there, std::max(0.0, length_of(*there) - waypoint.radius)).point;
    auto on = piece(end, all.back());
    if (!on) return false;
    all = std::move(*there);
    twice_ += waypoint.radius;
    pieces_.insert(pieces_.begin() + static_cast<std::ptrdiff_t>(number) + 1, std::move(*on));
    return true;
  }

 private:
  std::optional<Polyline> piece(const Vec2& from, const Vec2& to) const {
    auto way = ways_.way(from, to);
    if (way) way->insert(way->begin(), from);
    return way;
  }

  const WayFinder& ways_;
  std::vector<Polyline> pieces_;
  double twice_ = 0.0;  ///< [m] that two of them have in common
};

/// Whether somebody on that way walks along the street that the place is in.
bool comes_along(const Zone& zone, const WayBy& way, const Vec2& place) {
  const Vec2 nearest = way.nearest(place);
  const double distance = (nearest - place).norm();
  return distance <= kSameSide || (distance <= kSeen && zone.walls.free_line(nearest, place));
}

/// Whether a way leads along edges of the zone, as the route could have done. Else it is a short
/// cut that SUMO's network does not have.
bool is_along_edges(const RoutePart& part, const WayBy& way) {
  struct Side {
    const Lane* lane;
    Box box;  ///< [m] it is no farther from the lane
  };
  std::vector<Side> sides;
  const Box there = way.box();
  for (const int edge : part.zone.edges) {
    const int walked = walking_lane(part.network, edge);
    if (walked < 0) continue;
    const Lane& lane = part.network.lanes[walked];
    const Box box = grown(box_of(lane.shape), 0.5 * lane.width + kBeside);
    if (box.intersects(there)) sides.push_back({&lane, box});
  }
  const auto is_on_edge = [&](const Vec2& place) {
    return std::ranges::any_of(sides, [&](const Side& side) {
      return side.box.contains(place) &&
             distance_to_lane(*side.lane, place) <= 0.5 * side.lane->width + kBeside;
    });
  };
  return way.share(is_on_edge) >= kStreets;
}

/// Whether the route comes by the middle of its edge k: of the first and the last it may have less.
bool has_middle(const RoutePart& part, const std::vector<Vec2>& ends, int k, const Lane& lane) {
  const std::size_t out = 2 * static_cast<std::size_t>(k - part.first);
  const Vec2& begin = k == part.first ? part.from : ends[out - 1];
  const Vec2& end = k == part.last ? part.to : ends[out];
  const double middle = 0.5 * lane.length;
  return (project_on_lane(lane, begin).offset < middle) !=
         (project_on_lane(lane, end).offset < middle);
}

/// Where the person would be that had come a little less far along its route: of two ways that are
/// as long somebody may take either.
Vec2 a_bit_before(const RoutePart& part, const std::vector<Vec2>& ends) {
  const Vec2 ahead = ends.front() - part.from;
  const double length = ahead.norm();
  if (length <= 0.0) return part.from;
  return part.zone.walls.nearest_inside(part.from - ahead * (kAsLong / length), kWayClearance);
}

/// As waypoints_of(), of a route of that length [m].
std::vector<Waypoint> by_missed_edges(const RoutePart& part, const std::vector<Vec2>& ends,
                                      double length) {
  WayBy way(part.zone.ways, a_bit_before(part, ends), part.to);
  if (!way.exists()) return {};
  std::map<int, Waypoint> led;  // by edge
  for (int k = part.first; k <= part.last; ++k) {
    const Lane& lane = lane_of(part, k);
    if (led.contains(k) || !has_middle(part, ends, k, lane)) continue;
    const Waypoint middle = waypoint_on(part, k, point_on_lane(lane, 0.5 * lane.length).point);
    if (comes_along(part.zone, way, middle.at)) continue;
    const bool is_shorter =
        led.empty() && part.zone.ways.distance(part.from, part.to) < kShortCut * length;
    if (is_shorter && !is_along_edges(part, way)) return {};
    const auto next = led.upper_bound(k);
    if (!way.lead_by(middle, static_cast<std::size_t>(std::distance(led.begin(), next)))) continue;
    const auto here = led.emplace_hint(next, k, middle);
    // The new way there may miss edges before this one that the old way came by.
    k = here == led.begin() ? part.first - 1 : std::prev(here)->first;
  }
  // The edges' middles are no places to come by: the zone has another form than the network.
  if (kShortCut * (way.length() - kAsLong) > length) return {};
  std::vector<Waypoint> path;
  for (const auto& [edge, waypoint] : led) path.push_back(waypoint);
  return path;
}

}  // namespace

std::vector<Vec2> ends_of_edges(const RoutePart& part) {
  const Network& network = part.network;
  const std::vector<int>& route = part.route;
  const auto way_by_end = [&](const Vec2& end) {
    return (end - part.from).norm() + (part.to - end).norm();
  };
  std::vector<Vec2> ends;
  for (int k = part.first; k < part.last; ++k) {
    const Edge& here = network.edges[route[k]];
    const Edge& next = network.edges[route[k + 1]];
    const Polyline& shape = lane_of(part, k).shape;
    const Polyline& after = lane_of(part, k + 1).shape;
    const bool at_end = leaves_forward(network, k > 0 ? route[k - 1] : -1, route[k], route[k + 1])
                            .value_or(way_by_end(shape.back()) < way_by_end(shape.front()));
    const std::string& junction = at_end ? here.to : here.from;
    ends.push_back(at_end ? shape.back() : shape.front());
    ends.push_back(next.from == junction ? after.front() : after.back());
  }
  return ends;
}

double length_by(const RoutePart& part, const std::vector<Vec2>& ends) {
  double length = 0.0;
  Vec2 at = part.from;
  for (const Vec2& place : ends) {
    length += (place - at).norm();
    at = place;
  }
  return length + (part.to - at).norm();
}

std::vector<Waypoint> waypoints_of(const RoutePart& part, const std::vector<Vec2>& ends) {
  const double length = length_by(part, ends);
  const double far_shorter = std::min(kShorter * length, length - kFar);
  const double straight = (part.to - part.from).norm();
  if (straight < far_shorter && part.zone.ways.distance(part.from, part.to) < far_shorter) {
    return by_ends(part, ends);
  }
  // Where people cross streets anywhere they choose their side.
  if (!part.zone.streets.empty() || part.last == part.first) return {};
  return by_missed_edges(part, ends, length);
}

}  // namespace pedzone
