#include "zone/zebras.hpp"

#include <cmath>

namespace pedzone {
namespace {

constexpr double kAsks = 1.5;      // [m] assumed: so near the kerb it is seen to want to cross
constexpr double kBeside = 0.5;    // [m] assumed: who walks so far beside the crossing uses it, too
constexpr double kAcross = 0.7;    // numerical: cosine; who heads more along the street does not

/// By somebody who goes from its begin to its end.
bool is_used(const Zebra& zebra, const Vec2& here, const Vec2& aim) {
  const Vec2 line = zebra.end - zebra.begin, way = aim - here, from = here - zebra.begin;
  const double length = line.norm();
  if (length <= 0.0) return false;
  const Vec2 along = line / length;
  if (way.dot(along) <= kAcross * way.norm()) return false;
  if (std::abs(from.dot(left_of(along))) > 0.5 * zebra.width + kBeside) return false;
  const double gone = from.dot(along), goal = gone + way.dot(along);
  return gone > -kAsks && gone < length && goal > 0.0;
}

}  // namespace

std::vector<Zebra> find_zebras(const Network& network, std::span<const int> lanes) {
  std::vector<Zebra> zebras;
  for (const int index : lanes) {
    const Lane& lane = network.lanes[index];
    const Edge& edge = network.edges[lane.edge];
    if (edge.function != EdgeFunction::kCrossing || !edge.priority || edge.signalled) continue;
    if (lane.shape.size() < 2) continue;
    zebras.push_back({lane.shape.front(), lane.shape.back(), lane.width});
  }
  return zebras;
}

std::optional<Zebra> zebra_of(std::span<const Zebra> zebras, const Vec2& here, const Vec2& aim) {
  for (const Zebra& zebra : zebras) {
    const Zebra back{zebra.end, zebra.begin, zebra.width};
    if (is_used(zebra, here, aim)) return zebra;
    if (is_used(back, here, aim)) return back;
  }
  return std::nullopt;
}

}  // namespace pedzone
