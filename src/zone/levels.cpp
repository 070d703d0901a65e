#include "zone/levels.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "core/text.hpp"
#include "zone/links.hpp"
#include "zone/shapes.hpp"

namespace pedzone {
namespace {

/// [m] Lowest and highest of a lane.
std::pair<double, double> heights_of(const Lane& lane) {
  if (lane.z.empty()) return {0.0, 0.0};
  const auto [low, high] = std::ranges::minmax(lane.z);
  return {low, high};
}

/// Whether `is_such` holds for any difference [m] between two lanes' heights where they overlap.
template <class Predicate>
bool any_step(const Lane& a, const Lane& b, const Predicate& is_such) {
  const Region overlap = intersect(area_of(a), area_of(b));
  return std::ranges::any_of(overlap, [&](const Polygon& polygon) {
    return std::ranges::any_of(polygon.outer, [&](const Vec2& point) {
      return is_such(std::abs(height_near(a, point) - height_near(b, point)));
    });
  });
}

double length_of(const Network& network, int edge) {
  const int lane = walking_lane(network, edge);
  return lane < 0 ? 0.0 : network.lanes[lane].length;
}

/// Edge → edges of the selection that it overlaps on another level.
std::map<int, std::set<int>> find_conflicts(const Network& network, const Selection& selection) {
  const bool flat = std::none_of(selection.lanes.begin(), selection.lanes.end(),
                                 [&](int lane) { return has_heights(network.lanes[lane]); });
  if (flat) return {};
  std::vector<Box> boxes;
  for (const int lane : selection.lanes) boxes.push_back(box_of(network.lanes[lane]));
  std::map<int, std::set<int>> conflicts;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Lane& a = network.lanes[selection.lanes[i]];
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Lane& b = network.lanes[selection.lanes[j]];
      if (a.edge == b.edge || !boxes[i].intersects(boxes[j])) continue;
      if (!on_different_levels(a, b)) continue;
      conflicts[a.edge].insert(b.edge);
      conflicts[b.edge].insert(a.edge);
    }
  }
  return conflicts;
}

/// How many edges that persons may use each edge is linked to.
std::vector<int> count_links(const Network& network) {
  std::vector<int> edges, links(network.edges.size(), 0);
  for (int edge = 0; edge < static_cast<int>(network.edges.size()); ++edge) {
    const bool normal = network.edges[edge].function == EdgeFunction::kNormal;
    if (normal && walking_lane(network, edge) >= 0) edges.push_back(edge);
  }
  for (const Link& link : find_links(network, edges)) {
    ++links[link.from];
    ++links[link.to];
  }
  return links;
}

}  // namespace

bool has_heights(const Lane& lane) {
  return std::ranges::any_of(lane.z, [](double z) { return z != 0.0; });
}

double height_near(const Lane& lane, const Vec2& point) {
  if (lane.z.empty()) return 0.0;
  double height = lane.z.front(), nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < lane.shape.size(); ++i) {
    const double part = nearest_part(lane.shape[i], lane.shape[i + 1], point);
    const Vec2 foot = lane.shape[i] + (lane.shape[i + 1] - lane.shape[i]) * part;
    const double distance = (point - foot).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    height = lane.z[i] + (lane.z[i + 1] - lane.z[i]) * part;
  }
  return height;
}

bool on_different_levels(const Lane& a, const Lane& b) {
  const auto [a_low, a_high] = heights_of(a);
  const auto [b_low, b_high] = heights_of(b);
  if (std::max(a_high - b_low, b_high - a_low) <= kLevelStep) return false;  // nearly always
  return any_step(a, b, [](double step) { return step > kLevelStep; });
}

bool on_one_level(const Lane& a, const Lane& b) {
  return any_step(a, b, [](double step) { return step <= kLevelStep; });
}

void separate_levels(const Network& network, Selection& selection,
                     std::vector<std::string>& warnings) {
  auto conflicts = find_conflicts(network, selection);
  if (conflicts.empty()) return;
  const auto links = count_links(network);
  while (!conflicts.empty()) {
    const auto worst =
        std::min_element(conflicts.begin(), conflicts.end(), [&](const auto& a, const auto& b) {
          if (a.second.size() != b.second.size()) return a.second.size() > b.second.size();
          if (links[a.first] != links[b.first]) return links[a.first] < links[b.first];
          return length_of(network, a.first) < length_of(network, b.first);
        });
    const int edge = worst->first;
    const std::string others = comma_list(
        worst->second, [&](int other) { return "'" + network.edges[other].id + "'"; });
    for (const int other : worst->second) conflicts[other].erase(edge);
    conflicts.erase(edge);
    std::erase_if(conflicts, [](const auto& entry) { return entry.second.empty(); });
    warnings.push_back("edge '" + network.edges[edge].id + "' is on another level than edge " +
                       others + " that it overlaps: left out");
    leave_out(
        network, [&](int other) { return other == edge; }, selection);
  }
}

}  // namespace pedzone
