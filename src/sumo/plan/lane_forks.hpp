// Where a lane leads onto several lanes of the next edge: the network does not tell which of them
// a vehicle will take.
#pragma once

#include <set>
#include <span>
#include <utility>

#include "zone/network.hpp"

namespace pedzone {

class LaneForks {
 public:
  /// The network must outlive it.
  explicit LaneForks(const Network& network);

  /// Whether there is one on the way from route[index] (indices into Network::edges; -1: not in the
  /// network), at its end or within `distance` > 0 [m] after that.
  bool ahead(std::span<const int> route, int index, double distance) const;

 private:
  const Network& network_;
  std::set<std::pair<int, int>> forks_;  ///< of an edge and the next: there is one
};

}  // namespace pedzone
