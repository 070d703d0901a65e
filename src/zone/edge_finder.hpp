// On which edge of a zone a place is. Out of a lane's bounds, and in open space, too: what is
// counted by edges must count everybody once.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "zone/zone.hpp"

namespace pedzone {

class EdgeFinder {
 public:
  /// Both must outlive it.
  EdgeFinder(const Network& network, const Zone& zone) : network_(network), zone_(zone) {}

  /// The edge (index into Network::edges, those inside junctions included) in one of whose lanes
  /// the place [m] lies deepest or, where it is in none, to which it is nearest; -1: the zone has
  /// none.
  int edge_at(const Vec2& place);

 private:
  double distance(int lane, const Vec2& place) const;
  const std::vector<int>& lanes_near(const Vec2& place);

  const Network& network_;
  const Zone& zone_;
  std::unordered_map<std::uint64_t, std::vector<int>> near_;  ///< lanes by cell, found when asked
};

}  // namespace pedzone
