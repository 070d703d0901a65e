// Zone lanes that run on a road that stays SUMO's, as maps have them where a square or a cycle
// path is drawn over a street.
#pragma once

#include <string>
#include <vector>

#include "geometry/box_tree.hpp"
#include "zone/selection.hpp"

namespace pedzone {

/// Lanes by where they are.
class PlacedLanes {
 public:
  explicit PlacedLanes(std::vector<const Lane*> lanes);
  std::vector<const Lane*> meeting(const Box& box) const;

 private:
  std::vector<const Lane*> lanes_;
  BoxTree tree_;
};

/// The network must outlive it.
class RoadOverlaps {
 public:
  explicit RoadOverlaps(const Network& network);

  /// Removes the edges from the selection on which people would walk along under a road for 5 m and
  /// more, with no room beside it: neither they nor its vehicles would get past each other, where
  /// plain SUMO lets them walk through each other. One warning each. Room is what other lanes of
  /// the selection cover, or open space, as far as no road lies between. Not edges on walkable
  /// polygons; and not where nothing would be left.
  void leave_out_covered(const ZoneSpec& spec, Selection& selection,
                         std::vector<std::string>& warnings) const;

  /// One warning for each lane of the selection of which a good part lies on a lane for vehicles
  /// only: its persons meet vehicles there that SUMO keeps apart from them.
  void warn(const Selection& selection, std::vector<std::string>& warnings) const;

 private:
  const Network& network_;
  PlacedLanes roads_;  ///< for vehicles only, between junctions
};

}  // namespace pedzone
