#include "validation/companions.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pedzone {
namespace {

constexpr double kTogether = 1.5;  // [m] assumed: the distance that groups keep (groups.hpp)
constexpr int kLeastFrames = 20;   // 2 s
constexpr double kSameWay = 0.7;   // cos 45 degrees
constexpr double kMost = 0.5;      // share of the longer track

struct Pair {
  double apart;  ///< [m] mean
  std::size_t one, other;
};

/// Adds the two where they walk together.
void compare(const Clip& clip, std::size_t i, std::size_t j, std::vector<Pair>& pairs) {
  const PersonTrack &a = clip.persons[i], &b = clip.persons[j];
  const int from = std::max(a.first, b.first), to = std::min(a.last(), b.last());
  if (to - from < kLeastFrames) return;
  const auto at = [](const PersonTrack& track, int frame) {
    return track.places[static_cast<std::size_t>(frame - track.first)];
  };
  const Vec2 way_a = at(a, to) - at(a, from), way_b = at(b, to) - at(b, from);
  if (way_a.dot(way_b) <= kSameWay * way_a.norm() * way_b.norm()) return;
  std::size_t near = 0;
  double sum = 0.0;
  for (int frame = from; frame <= to; ++frame) {
    const double distance = (at(a, frame) - at(b, frame)).norm();
    sum += distance;
    near += distance <= kTogether ? 1 : 0;
  }
  const std::size_t longer = std::max(a.places.size(), b.places.size());
  if (static_cast<double>(near) <= kMost * static_cast<double>(longer)) return;
  pairs.push_back({sum / (to - from + 1), i, j});
}

}  // namespace

std::vector<std::uint64_t> companions(const Clip& clip) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < clip.persons.size(); ++i) {
    for (std::size_t j = i + 1; j < clip.persons.size(); ++j) compare(clip, i, j, pairs);
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.apart, a.one, a.other) < std::tie(b.apart, b.one, b.other);
  });
  std::vector<std::uint64_t> groups(clip.persons.size(), 0);
  std::uint64_t count = 0;
  for (const Pair& pair : pairs) {
    if (groups[pair.one] == 0 && groups[pair.other] == 0) {
      groups[pair.one] = groups[pair.other] = ++count;
    }
  }
  return groups;
}

}  // namespace pedzone
