#include "zone/streets.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "geometry/wall_index.hpp"

namespace pedzone {
namespace {

constexpr double kMedian = 6.0;     // [m] assumed: carriageways farther apart are two streets
constexpr double kVerge = 3.0;      // [m] assumed: a strip of grass or parked cars at most so wide
constexpr double kVergeStep = 0.1;  // [m] numerical
constexpr double kAppears = 15.0;   // [m] assumed: longer than a bus, which SUMO puts there at once
constexpr double kRoom = 0.3;       // [m] of ground to stand on behind the kerb
constexpr double kOverlap = 0.4;    // [m] numerical: by which the crossable ground reaches into
                                    // people's own, so that no wall is left between

bool is_carriageway(const Network& network, int lane, const std::set<int>& walkable) {
  return network.lanes[lane].vehicles && !network.lanes[lane].outline && !walkable.contains(lane);
}

/// The lanes of an edge as bands beside the axis.
void add_lanes(const Network& network, int edge, int direction, const std::set<int>& walkable,
               Street& street) {
  for (const int index : network.edges[edge].lanes) {
    const Lane& lane = network.lanes[index];
    if (!is_carriageway(network, index, walkable) || lane.shape.size() < 2) continue;
    const Vec2 middle = point_on(lane.shape, 0.5 * length_of(lane.shape)).point;
    const double t = project_on(street.axis, middle).lateral;
    street.lanes.push_back({index, t - 0.5 * lane.width, t + 0.5 * lane.width, direction});
  }
}

/// Gap [m] between the bands of two streets beside each other.
double gap_between(const Street& street, const std::vector<StreetLane>& others) {
  double low = others.front().low, high = others.front().high;
  for (const StreetLane& lane : others) {
    low = std::min(low, lane.low);
    high = std::max(high, lane.high);
  }
  return std::max({0.0, low - street.high, street.low - high});
}

void set_borders(Street& street) {
  std::ranges::sort(street.lanes, {}, &StreetLane::low);
  street.low = street.lanes.front().low;
  street.high = street.lanes.back().high;
  for (const StreetLane& lane : street.lanes) street.high = std::max(street.high, lane.high);
}

void set_refuges(Street& street) {
  double reached = street.lanes.front().high;
  for (const StreetLane& lane : street.lanes) {
    if (lane.low - reached >= kRefuge) street.refuges.push_back(0.5 * (lane.low + reached));
    reached = std::max(reached, lane.high);
  }
}

class Finder {
 public:
  Finder(const Network& network, const std::vector<int>& edges, const std::vector<int>& lanes,
         const Region& walkable)
      : network_(network),
        edges_(edges),
        walkable_lanes_(lanes.begin(), lanes.end()),
        ground_(walkable) {
    for (const Edge& edge : network.edges) {
      if (edge.signalled && edge.function == EdgeFunction::kCrossing && !edge.lanes.empty()) {
        signalled_.push_back(network.lanes[edge.lanes[0]].shape);
      }
    }
  }

  std::vector<Street> find() {
    std::vector<Street> streets;
    for (const int edge : edges_) {
      if (known_.contains(edge)) continue;
      auto street = street_of(edge);
      if (!street) continue;
      known_.insert(street->edges.begin(), street->edges.end());
      if (std::ranges::any_of(street->places, &CrossingPlace::open)) {
        streets.push_back(std::move(*street));
      }
    }
    return streets;
  }

 private:
  std::optional<Street> street_of(int edge) const {
    Street street;
    street.id = network_.edges[edge].id;
    street.edges = {edge};
    const std::vector<int>& lanes = network_.edges[edge].lanes;
    const auto leftmost = std::find_if(lanes.rbegin(), lanes.rend(), [&](int lane) {
      return is_carriageway(network_, lane, walkable_lanes_);
    });
    if (leftmost == lanes.rend()) return std::nullopt;
    street.axis = network_.lanes[*leftmost].shape;
    street.length = length_of(street.axis);
    if (street.axis.size() < 2 || street.length < kStreetStep) return std::nullopt;
    add_lanes(network_, edge, 1, walkable_lanes_, street);
    if (street.lanes.empty()) return std::nullopt;
    set_borders(street);
    add_way_back(edge, street);
    set_refuges(street);
    set_places(street);
    return street;
  }

  /// The edges that run back between the same junctions, where no ground lies between.
  void add_way_back(int edge, Street& street) const {
    const Edge& there = network_.edges[edge];
    for (int other = 0; other < static_cast<int>(network_.edges.size()); ++other) {
      const Edge& back = network_.edges[other];
      if (back.function != EdgeFunction::kNormal || back.from != there.to || back.to != there.from)
        continue;
      Street beside;
      beside.axis = street.axis;
      add_lanes(network_, other, -1, walkable_lanes_, beside);
      if (beside.lanes.empty() || gap_between(street, beside.lanes) > kMedian) continue;
      street.edges.push_back(other);
      street.lanes.insert(street.lanes.end(), beside.lanes.begin(), beside.lanes.end());
    }
    std::ranges::sort(street.edges);
    set_borders(street);
  }

  /// s [m] where vehicles appear and vanish: ends of the street at the network's border.
  std::vector<double> ends_of_network(const Street& street) const {
    std::vector<double> ends;
    for (const int edge : street.edges) {
      const Edge& here = network_.edges[edge];
      const Polyline& shape = network_.lanes[here.lanes.front()].shape;
      if (is_street_end(network_, here.from)) ends.push_back(street.place(shape.front()).s);
      if (is_street_end(network_, here.to)) ends.push_back(street.place(shape.back()).s);
    }
    return ends;
  }

  void set_places(Street& street) const {
    const std::vector<double> ends = ends_of_network(street);
    const auto far = [&](double s) {
      return std::ranges::none_of(ends, [&](double end) { return std::abs(s - end) < kAppears; });
    };
    for (double s = 0.0; s <= street.length; s += kStreetStep) {
      CrossingPlace place;
      const auto low = ground_beside(street, s, street.low, -1.0);
      const auto high = ground_beside(street, s, street.high, 1.0);
      place.open = low && high && far(s);
      place.low = low.value_or(street.low);
      place.high = high.value_or(street.high);
      place.near_signal = near_signal(street.point(s, 0.5 * (street.low + street.high)));
      street.places.push_back(place);
    }
  }

  /// t where people's ground begins, outwards from the border.
  std::optional<double> ground_beside(const Street& street, double s, double border,
                                      double outward) const {
    for (double verge = 0.0; verge <= kVerge; verge += kVergeStep) {
      const double t = border + outward * verge;
      if (ground_.inside(street.point(s, t + outward * 2.0 * kRoom)) &&
          ground_.inside(street.point(s, t + outward * kVergeStep))) {
        return t;
      }
    }
    return std::nullopt;
  }

  bool near_signal(const Vec2& point) const {
    return std::ranges::any_of(signalled_, [&](const Polyline& crossing) {
      const LineProjection at = project_on(crossing, point);
      return (point_on(crossing, at.offset).point - point).norm() < kSignalReach;
    });
  }

  const Network& network_;
  const std::vector<int>& edges_;
  std::set<int> walkable_lanes_, known_;
  WallIndex ground_;
  std::vector<Polyline> signalled_;
};

/// The run of open places from `first` on, as a ring. At both ends it holds the bodies of those who
/// cross as far out as Street::at takes for the last place, too.
Ring ring_of(const Street& street, std::size_t first, std::size_t last) {
  constexpr double kBeyond = 0.5 * kStreetStep + kRoom;
  Ring ring;
  const auto add = [&](std::size_t k, double t, double beyond) {
    const double s = static_cast<double>(k) * kStreetStep;
    ring.push_back(street.point(s, t) + beyond * point_on(street.axis, s).direction);
  };
  const auto low = [&](std::size_t k) { return street.places[k].low - kOverlap; };
  const auto high = [&](std::size_t k) { return street.places[k].high + kOverlap; };
  add(first, low(first), -kBeyond);
  for (std::size_t k = first; k < last; ++k) add(k, low(k), 0.0);
  add(last - 1, low(last - 1), kBeyond);
  add(last - 1, high(last - 1), kBeyond);
  for (std::size_t k = last; k > first; --k) add(k - 1, high(k - 1), 0.0);
  add(first, high(first), -kBeyond);
  return ring;
}

/// [m] of the lane that people walk on, to the left of the street's axis.
double side_of(const Network& network, const Street& street, int edge) {
  const Polyline& shape = network.lanes[walking_lane(network, edge)].shape;
  return project_on(street.axis, point_on(shape, 0.5 * length_of(shape)).point).lateral;
}

/// Of the edges those of the street, and footways beside it between the same junctions.
std::vector<int> edges_along(const Network& network, const Street& street,
                             const std::vector<int>& edges) {
  const Edge& first = network.edges[street.edges.front()];
  const auto is_footway = [&](int index) {
    const Edge& edge = network.edges[index];
    const bool same = (edge.from == first.from && edge.to == first.to) ||
                      (edge.from == first.to && edge.to == first.from);
    if (!same || has_carriageway(network, index) || walking_lane(network, index) < 0) return false;
    const double side = side_of(network, street, index);
    const double beside = kVerge + 0.5 * network.lanes[walking_lane(network, index)].width;
    return side > street.low - beside && side < street.high + beside;
  };
  std::vector<int> along;
  std::ranges::copy_if(edges, std::back_inserter(along), [&](int edge) {
    return std::ranges::binary_search(street.edges, edge) || is_footway(edge);
  });
  return along;
}

}  // namespace

double Street::divide() const {
  const auto before =
      std::ranges::adjacent_find(lanes, std::ranges::not_equal_to{}, &StreetLane::direction);
  if (before == lanes.end()) return 0.5 * (low + high);
  return 0.5 * (before->high + std::next(before)->low);
}

const CrossingPlace& Street::at(double s) const {
  const auto last = static_cast<double>(places.size() - 1);
  return places[static_cast<std::size_t>(std::clamp(std::round(s / kStreetStep), 0.0, last))];
}

Vec2 Street::point(double s, double t) const {
  const LinePoint place = point_on(axis, s);
  return place.point + t * left_of(place.direction);
}

StreetPlace Street::place(const Vec2& point) const {
  const LineProjection at = project_on(axis, point);
  const LinePoint on = point_on(axis, at.offset);
  const Vec2 rest = point - on.point;
  const bool beyond = at.offset <= 0.0 || at.offset >= length;
  const double along = beyond ? rest.dot(on.direction) : 0.0;
  return {at.offset + along, cross(on.direction, rest), on.direction};
}

std::vector<Street> find_streets(const Network& network, const std::vector<int>& edges,
                                 const std::vector<int>& lanes, const Region& walkable) {
  return Finder(network, edges, lanes, walkable).find();
}

Region crossable_ground(const std::vector<Street>& streets) {
  std::vector<Region> runs;
  for (const Street& street : streets) {
    for (std::size_t k = 0; k < street.places.size(); ++k) {
      if (!street.places[k].open) continue;
      std::size_t last = k;
      while (last < street.places.size() && street.places[last].open) ++last;
      runs.push_back(repair(ring_of(street, k, last)));
      k = last;
    }
  }
  return unite(runs);
}

std::vector<std::pair<int, int>> linked_across(const Network& network,
                                               const std::vector<Street>& streets,
                                               const std::vector<int>& edges) {
  std::vector<std::pair<int, int>> pairs;
  for (const Street& street : streets) {
    const double middle = 0.5 * (street.low + street.high);
    const std::vector<int> along = edges_along(network, street, edges);
    for (const int a : along) {
      for (const int b : along) {
        if (a >= b) continue;
        const double sides =
            (side_of(network, street, a) - middle) * (side_of(network, street, b) - middle);
        if (sides < 0.0) pairs.emplace_back(a, b);
      }
    }
  }
  return pairs;
}

}  // namespace pedzone
