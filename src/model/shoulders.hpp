// People turn their shoulders where there is little room: a body is a disc as wide as its shoulders
// as long as there is room, and narrower otherwise (Yamamoto, Yanagisawa, Feliciani and Nishinari
// 2019: pedestrians rotate their bodies when the gap is narrower than their shoulders).
#pragma once

#include <limits>

#include "model/obstacle_lists.hpp"

namespace pedzone {

/// Softness (obstacle_lists.hpp) of turned bodies, q = 0: a contact counts within acos(√0.2) = 63°
/// of the other's direction, so that somebody slips past along it. Calibrated with the numbers of
/// by_facing(): with the 72° of straight bodies those who have walked into each other never part,
/// since by Eq. 1 standing is as good as a free way 60° off the goal; with 55° doors of 2 m let
/// through 1.91 persons/(m·s). Behind those who walk ahead, q = 1, it is kSoftness; linear between.
inline constexpr float kTurnedSoftness = 0.2F;

/// [m] radius of SUMO's person. Who walks behind somebody keeps clear of its feet. Broader bodies
/// than this (bags, winter coats) have no longer steps. With the distance that their width would
/// ask for, footways of 2 m jam with bodies of 0.7 m at 0.8 persons/(m·s) (tests/scenario/flow).
inline constexpr float kBroadestQueue = 0.239F;

/// How somebody who looks for a way takes itself and others to hold their shoulders. The contact
/// distance of two is T + q·(R − T), and at least T, with R the sum of their radii (each at most
/// `broadest`), T that of their turned radii, q = (straight + facing·cos h)², and h the angle
/// between their headings.
struct Shoulders {
  float straight = 1.0F, facing = 0.0F;
  float broadest = std::numeric_limits<float>::max();  ///< [m]

  /// R: as long as there is room.
  static constexpr Shoulders kept_straight() { return {}; }
  /// T: where there is none.
  static constexpr Shoulders turned() { return {.straight = 0.0F}; }
  /// q from 0.05 towards somebody who comes to 0.96 behind somebody who walks ahead. Queues keep
  /// their distance, for the sake of feet, which do not turn: with q = 0 for all, doors let through
  /// 2.6 to 3.8 persons a metre and second, twice what is measured. Both numbers are calibrated on
  /// doors (1.3 to 1.9), the fundamental diagrams of Weidmann and Jülich and footways in flow
  /// (`pedzone verify`, tests/scenario/flow): with 0.5 and 0.5 doors of 2 m let through 1.93, with
  /// 0.72 and 0.26 people of 0.7 m on a full footway of 2 m take a sixth longer.
  static constexpr Shoulders by_facing() { return {0.6F, 0.38F, kBroadestQueue}; }
};

}  // namespace pedzone
