// How far a SUMO person walks, and how far of that in the zones, before the simulation begins.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "zone/network.hpp"

namespace pedzone::study {

struct WalkLength {
  double total = 0.0, in_zone = 0.0;  ///< [m]
};

class WalkLengths {
 public:
  /// `zone_edges`: Network indices. Both must outlive it.
  WalkLengths(const Network& network, const std::unordered_set<int>& zone_edges);

  /// Along edges; nothing where one is not known or nobody may walk on it.
  std::optional<WalkLength> along(const std::vector<std::string>& edges) const;
  /// The shortest way on foot from one edge to another, both counted whole; nothing where there is
  /// none.
  std::optional<WalkLength> between(const std::string& from, const std::string& to) const;

 private:
  struct Step {
    int edge;
    std::string to;  ///< junction
  };

  std::optional<int> edge_of(const std::string& id) const;
  double length(int edge) const;
  WalkLength plus(WalkLength length, int edge) const;

  const Network& network_;
  const std::unordered_set<int>& zone_edges_;
  std::unordered_map<std::string, std::vector<Step>> steps_;  ///< by junction
};

}  // namespace pedzone::study
