#include "zone/crosswalks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "zone/links.hpp"

namespace pedzone {
namespace {

constexpr double kBeside = 0.5;  // [m] assumed: who walks so far beside the crossing uses it, too
constexpr double kMostReach = 3.0;  // [m] numerical
constexpr double kAcross = 0.7;     // numerical: cosine; who heads more along the street does not

/// Where a point is: x [m] along the crosswalk from its begin, y [m] to its left.
Vec2 place_on(const Crosswalk& crosswalk, const Vec2& point) {
  const Vec2 along = (crosswalk.end - crosswalk.begin).normalized();
  const Vec2 from = point - crosswalk.begin;
  return {from.dot(along), from.dot(left_of(along))};
}

/// [m] that somebody who goes from its begin to its end has gone; nothing: it does not.
std::optional<double> gone_on(const Crosswalk& crosswalk, const Vec2& here, const Vec2& aim,
                              double reach) {
  const Vec2 line = crosswalk.end - crosswalk.begin, way = aim - here;
  const double length = line.norm();
  if (length <= 0.0) return std::nullopt;
  const Vec2 along = line / length, place = place_on(crosswalk, here);
  const double gone = place.x();
  if (gone <= -reach || gone >= length || gone + way.dot(along) <= 0.0) return std::nullopt;
  if (std::abs(place.y()) > 0.5 * crosswalk.width + kBeside) return std::nullopt;
  if (way.dot(along) <= kAcross * way.norm()) return std::nullopt;
  return gone;
}

}  // namespace

bool is_among(const Crosswalk& crosswalk, std::span<const int> crossings) {
  return std::ranges::find(crossings, crosswalk.edge) != crossings.end();
}

std::vector<Crosswalk> find_crosswalks(const Network& network, std::span<const int> lanes) {
  std::vector<Crosswalk> crosswalks;
  for (const int index : lanes) {
    const Lane& lane = network.lanes[index];
    const Edge& edge = network.edges[lane.edge];
    if (edge.function != EdgeFunction::kCrossing || edge.signalled) continue;
    if (lane.shape.size() < 2 || !leads_over_carriageway(network, lane.edge)) continue;
    crosswalks.push_back(
        {lane.shape.front(), lane.shape.back(), lane.width, edge.priority, lane.edge});
  }
  return crosswalks;
}

Crosswalks::Crosswalks(std::vector<Crosswalk> all) : all_(std::move(all)) {
  std::vector<Vec2> middles;
  for (const Crosswalk& crosswalk : all_) {
    middles.emplace_back(0.5 * (crosswalk.begin + crosswalk.end));
    const double length = (crosswalk.end - crosswalk.begin).norm();
    around_ = std::max(around_, 0.5 * (length + crosswalk.width) + kBeside + kMostReach);
  }
  middles_ = NearPoints(middles);
}

std::optional<CrosswalkAhead> Crosswalks::ahead(const Vec2& here, const Vec2& aim,
                                                double reach) const {
  std::optional<CrosswalkAhead> nearest;
  for (const std::uint32_t k : middles_.within(here, around_)) {
    const Crosswalk& there = all_[k];
    const Crosswalk back{there.end, there.begin, there.width, there.priority, there.edge};
    std::size_t kerb = std::size_t{2} * k;
    for (const Crosswalk& crosswalk : {there, back}) {
      const auto gone = gone_on(crosswalk, here, aim, std::min(reach, kMostReach));
      if (gone && (!nearest || *gone > nearest->gone)) nearest = {kerb, crosswalk, *gone};
      if (nearest && nearest->gone > 0.0) return nearest;
      ++kerb;
    }
  }
  return nearest;
}

bool Crosswalks::covers(const Vec2& place) const {
  return std::ranges::any_of(middles_.within(place, around_), [&](std::uint32_t k) {
    const Crosswalk& there = all_[k];
    const Vec2 on = place_on(there, place);
    return on.x() > 0.0 && on.x() < (there.end - there.begin).norm() &&
           std::abs(on.y()) < 0.5 * there.width;
  });
}

std::optional<WayOver> way_over(std::span<const Vec2> way, const Crosswalk& crosswalk) {
  const Vec2 line = crosswalk.end - crosswalk.begin;
  double driven = 0.0;
  for (std::size_t k = 1; k < way.size(); ++k) {
    const Vec2 piece = way[k] - way[k - 1];
    const double turn = cross(piece, line), length = piece.norm();
    if (turn != 0.0) {
      const Vec2 between = crosswalk.begin - way[k - 1];
      const double share = cross(between, line) / turn, across = cross(between, piece) / turn;
      if (share >= 0.0 && share <= 1.0 && across >= 0.0 && across <= 1.0) {
        return WayOver{driven + share * length, across * line.norm(), piece / length};
      }
    }
    driven += length;
  }
  return std::nullopt;
}

}  // namespace pedzone
