// Who has not got on for long, be it a person or a vehicle: for the summary and a warning.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/vec.hpp"
#include "world/activities.hpp"

namespace pedzone {

/// Somebody who has not moved for long.
struct Standstill {
  std::string id;
  Vec2 position = Vec2::Zero();  ///< [m]
  double since = 0.0;            ///< [s]
  std::string where;             ///< "in zone 'plaza'", "on edge 'e1'"; empty: not asked for
};

/// Whether a person that pedzone walks, and that stands, does so because of what it does.
bool is_at_rest(Activity activity);

class Standstills {
 public:
  static constexpr double kLong = 60.0;      ///< [s] without moving, to be counted
  static constexpr std::size_t kNamed = 10;  ///< of those so many are named, with where they are

  /// Somebody who is in SUMO now.
  struct Present {
    std::string id;
    Vec2 position = Vec2::Zero();  ///< [m]
  };
  /// Takes in everybody at `time` [s]. `rests` is asked of those who have not moved: whether that
  /// is what they want (a stop, a bench, a ride). Their time begins when they no longer do.
  void update(double time, const std::vector<Present>& all,
              const std::function<bool(const std::string& id)>& rests);

  /// Who has not moved for kLong at the last update: the longest first, then by id.
  const std::vector<Standstill>& all() const { return all_; }
  /// The first kNamed of them, whose `where` may be filled in.
  std::span<Standstill> named() { return std::span(all_).first(std::min(kNamed, all_.size())); }
  std::size_t most() const { return most_; }   ///< at any update
  double most_at() const { return most_at_; }  ///< [s] when that was first

 private:
  struct Place {
    Vec2 anchor = Vec2::Zero();  ///< [m]
    double since = 0.0;          ///< [s]
    long round = 0;              ///< of the update that saw it last
  };
  std::unordered_map<std::string, Place> places_;
  long round_ = 0;
  std::vector<Standstill> all_;
  std::size_t most_ = 0;
  double most_at_ = 0.0;
};

}  // namespace pedzone
