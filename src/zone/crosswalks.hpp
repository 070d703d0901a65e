// Crossings without a signal, where people and vehicles have the right of way that the network
// says.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/near_points.hpp"
#include "zone/network.hpp"

namespace pedzone {

/// A crossing over a carriageway, without a signal: from kerb to kerb.
struct Crosswalk {
  Vec2 begin = Vec2::Zero(), end = Vec2::Zero();  ///< [m] middle of the crossing at either kerb
  double width = 4.0;                             ///< [m]
  bool priority = true;  ///< vehicles give way to who looks across, too (a zebra crossing)
  int edge = -1;         ///< index into Network::edges
};

/// Whether it is one of those crossings (Lane::yields_at).
bool is_among(const Crosswalk& crosswalk, std::span<const int> crossings);

/// Those of the lanes that are such crossings, in their order.
std::vector<Crosswalk> find_crosswalks(const Network& network, std::span<const int> lanes);

/// A crosswalk that somebody is on, or comes to.
struct CrosswalkAhead {
  std::size_t kerb = 0;  ///< where it comes from: the zone's kerbs are numbered, two a crosswalk
  Crosswalk crosswalk;   ///< it begins there
  double gone = 0.0;     ///< [m] from that kerb; negative: has not come to it
};

/// The crosswalks of a zone.
class Crosswalks {
 public:
  Crosswalks() = default;
  explicit Crosswalks(std::vector<Crosswalk> all);

  bool empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }
  const Crosswalk& operator[](std::size_t index) const { return all_[index]; }

  /// The one that somebody at `here` [m] who heads for `aim` [m] is on, else the nearest that it
  /// comes to within `reach` [m] and 3 m: it looks across. Nothing: none.
  std::optional<CrosswalkAhead> ahead(const Vec2& here, const Vec2& aim, double reach) const;

  /// Whether the place [m] is on one of them: no place to wait at.
  bool covers(const Vec2& place) const;

 private:
  std::vector<Crosswalk> all_;
  NearPoints middles_;
  double around_ = 0.0;  ///< [m] from its middle nobody is farther who is on one or comes to it
};

/// Where a way leads over a crosswalk.
struct WayOver {
  double way = 0.0;               ///< [m] along the way to the line in the crosswalk's middle
  double across = 0.0;            ///< [m] along that line, from its begin
  Vec2 direction = Vec2::Zero();  ///< of the way there, length 1
};

/// Where the way [m] first leads over the crosswalk; nothing: it does not.
std::optional<WayOver> way_over(std::span<const Vec2> way, const Crosswalk& crosswalk);

}  // namespace pedzone
