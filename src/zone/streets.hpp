// The carriageways of a zone that people may cross between the junctions.
//
//            ground                              t = high
//      ------------------------ kerb ----------
//         <- lane                                     the axis runs along the leftmost lane of
//      - - - - - - - - - - - - - - - -  axis    t = 0 the street's first edge, s = 0 at its start
//         lane ->
//      ------------------------ kerb ----------
//            ground                              t = low
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/polyline.hpp"
#include "zone/network.hpp"

namespace pedzone {

/// A lane of vehicles, as a band of its street.
struct StreetLane {
  int lane = -1;                 ///< Network lane
  double low = 0.0, high = 0.0;  ///< [m] t of its borders
  int direction = 1;             ///< 1: vehicles drive along the axis, -1: against it
};

/// Where a street may be crossed, at one place of its axis.
struct CrossingPlace {
  double low = 0.0, high = 0.0;  ///< [m] t where people's ground begins on either side
  bool open = false;             ///< there is ground on both sides
  bool near_signal = false;      ///< a signalled crossing is so near that most people use it

  double width() const { return high - low; }  ///< [m]
  /// Whether people cross here, who act on impulses or not.
  bool open_to(bool impulsive) const { return open && (impulsive || !near_signal); }
};

/// A point by a street's axis, which goes on straight beyond its ends.
struct StreetPlace {
  double s = 0.0, t = 0.0;        ///< [m]
  Vec2 direction = Vec2::Zero();  ///< unit, of the axis there
};

/// A carriageway between two junctions.
struct Street {
  std::string id;                     ///< of its first edge
  Polyline axis;                      ///< [m]
  double length = 0.0;                ///< [m] of the axis
  double low = 0.0, high = 0.0;       ///< [m] t of its borders
  std::vector<int> edges;             ///< Network edges whose vehicles drive here, ascending
  std::vector<StreetLane> lanes;      ///< by t
  std::vector<double> refuges;        ///< [m] t of the middle of each strip between lanes that is
                                      ///< wide enough to wait on, ascending
  std::vector<CrossingPlace> places;  ///< at s = 0, kStreetStep, ...

  /// [m] t between its near and its far half: where the direction of traffic changes, else the
  /// middle.
  double divide() const;
  /// The place nearest to s [m].
  const CrossingPlace& at(double s) const;
  Vec2 point(double s, double t) const;  ///< [m]
  StreetPlace place(const Vec2& point) const;
};

/// [m] numerical: between two places of a street.
constexpr double kStreetStep = 1.0;

/// [m] assumed: on a narrower strip between lanes nobody waits (a person with a pram is 1.5 m
/// long).
constexpr double kRefuge = 1.5;

/// [m] Nobody crosses nearer to a signalled crossing, unless on an impulse.
constexpr double kSignalReach = 30.0;

/// The streets of a zone: carriageways of its edges (and of those that run back beside them) that
/// `lanes`, its walkable lanes, leave out, as far as `walkable` ground lies on both sides.
std::vector<Street> find_streets(const Network& network, const std::vector<int>& edges,
                                 const std::vector<int>& lanes, const Region& walkable);

/// The parts of the streets that may be crossed, as ground.
Region crossable_ground(const std::vector<Street>& streets);

/// Pairs of edges of `edges` (ascending) on the two sides of a street that is open somewhere.
std::vector<std::pair<int, int>> linked_across(const Network& network,
                                               const std::vector<Street>& streets,
                                               const std::vector<int>& edges);

}  // namespace pedzone
