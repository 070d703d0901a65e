#include "sumo/plan/edges_walked.hpp"

#include <algorithm>
#include <cmath>

#include "zone/lane_geometry.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kAhead = 3;  // numerical: edges looked at, beside the present one ...
constexpr double kAstray = 20.0;   // [m] assumed: ... but all, by who is so far from those
constexpr double kFromEnd = 0.5;   // [m] numerical: SUMO's persons mind the end of a lane
// [m] numerical: farther beside its border SUMO takes a person for one that is on no lane. (3 m and
// half the person's width are what its source says.)
constexpr double kBeside = 2.9;
constexpr double kInterval = 0.5;  // [s] numerical: to look is dear
constexpr double kExact = 1e-3;    // [m] numerical: as far as the place on the lane may be off

/// Where on the lane the position is; nothing where SUMO cannot have it there.
std::optional<LaneMove> place_on(const Lane& lane, const Vec2& position) {
  const auto [offset, lateral] = project_on_lane(lane, position);
  if (offset < kFromEnd || offset > lane.length - kFromEnd) return std::nullopt;
  if (std::abs(lateral) > 0.5 * lane.width + kBeside) return std::nullopt;
  const LinePoint at = point_on_lane(lane, offset);
  const Vec2 there = at.point + left_of(at.direction) * lateral;
  if ((there - position).norm() > kExact) return std::nullopt;  // on the outer side of a bend
  return LaneMove{lane.id, offset, lateral};
}

}  // namespace

EdgesWalked::EdgesWalked(const Network& network, const std::vector<int>& route, int first,
                         int last) {
  lanes_.push_back(walking_lane(network, route[first]));
  for (int i = first + 1; i <= last; ++i) {
    const bool can_be_told = !is_too_short(network, route[i]) && is_first_occurrence(route, i);
    if (can_be_told) lanes_.push_back(walking_lane(network, route[i]));
  }
}

bool EdgesWalked::is_due(double time) {
  if (lanes_.size() < 2 || time < look_at_) return false;
  look_at_ = time + kInterval;
  return true;
}

std::optional<LaneMove> EdgesWalked::come_to(const Network& network, const Vec2& position) const {
  std::optional<LaneMove> move;
  double nearest = distance_to_lane(network.lanes[lanes_.front()], position), least = nearest;
  for (std::size_t k = 1; k < lanes_.size() && (k <= kAhead || least > kAstray); ++k) {
    const Lane& lane = network.lanes[lanes_[k]];
    const double distance = distance_to_lane(lane, position);
    least = std::min(least, distance);
    if (distance >= nearest) continue;
    if (const auto place = place_on(lane, position)) {
      move = place;
      nearest = distance;
    }
  }
  return move;
}

void EdgesWalked::be_on(const Network& network, const LaneMove& told) {
  const auto now = std::ranges::find(lanes_, network.lane_index.at(told.lane));
  lanes_.erase(lanes_.begin(), now);
}

}  // namespace pedzone
