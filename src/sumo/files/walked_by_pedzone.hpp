// Whom pedzone walked when, from its trajectories.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace pedzone {

class WalkedByPedzone {
 public:
  void add(std::string_view id, double time);
  /// `time` [s], to a hundredth, as trajectories and SUMO's outputs have it.
  bool at(std::string_view id, double time) const;
  bool empty() const { return steps_.empty(); }

 private:
  std::unordered_map<std::string, std::unordered_set<long long>> steps_;  ///< [s/100] by id
};

/// Of a file of `pedzone run --trajectories`, a table; nothing where the name is empty. Throws
/// InputError.
std::optional<WalkedByPedzone> read_walked(const std::string& trajectories);

}  // namespace pedzone
