// On which edge of its walk SUMO is told that somebody is whom pedzone walks: plans over plain
// values. Without it SUMO would have the person on the edge of its takeover until it is given back,
// and whoever looks for people near a vehicle, or on an edge, would not find it.
#pragma once

#include <optional>
#include <vector>

#include "sumo/plan/release_plan.hpp"

namespace pedzone {

/// The edges that pedzone walks somebody along.
class EdgesWalked {
 public:
  EdgesWalked() = default;
  /// `route`: Network edges of its walk. SUMO has it on route[first]; pedzone walks it up to
  /// route[last].
  EdgesWalked(const Network& network, const std::vector<int>& route, int first, int last);

  /// Whether it is time [s] to look which edge it has come to; then it is so again half a second
  /// later.
  bool is_due(double time);

  /// Another one that it has come to: its lane is nearer to `position` [m], where SUMO has the
  /// person, than that of the edge on which SUMO has it. The call puts it there, at that place.
  /// Nothing where there is no such edge, or none where SUMO can have it.
  std::optional<LaneMove> come_to(const Network& network, const Vec2& position) const;

  /// SUMO has been told so.
  void be_on(const Network& network, const LaneMove& told);

 private:
  std::vector<int> lanes_;  ///< that it walks on; the first is SUMO's
  double look_at_ = 0.0;    ///< [s]
};

}  // namespace pedzone
