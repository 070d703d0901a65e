// The tables of those who crossed streets: as pedzone walked them, and as an observer sees them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/table.hpp"

namespace pedzone {

/// Somebody who stepped out to cross a street between the junctions.
struct StreetCrossed {
  double time = 0.0;                 ///< [s] when it stepped out
  std::string person, zone, street;  ///< ids; a street has that of its first edge
  double x = 0.0, y = 0.0;           ///< [m] where
  double pos = 0.0;                  ///< [m] along the street
  double width = 0.0;                ///< [m] of the carriageway
  double waited = 0.0;               ///< [s] at the kerb
  std::optional<double> gap;         ///< [s] until the next vehicle came; unset: none was seen
  double needed = 0.0;               ///< [s] critical gap
  bool looked = true;                ///< false: stepped out without looking
  std::vector<float> rejected;       ///< [s] gaps that it had let pass
};

const Table<StreetCrossed>& crossing_table();

/// Somebody who got from one side of a street to the other, whoever walked it.
struct SeenCrossing {
  std::string person;
  bool between = false;               ///< the junctions; false: at one of them
  double begin = 0.0, end = 0.0;      ///< [s] when it came to the one side, and to the other
  double waited = 0.0;                ///< [s] standing at the kerb before
  std::optional<double> gap = {};     ///< [s] that was taken; unset: no vehicle came after
  std::vector<double> let_pass = {};  ///< [s] gaps
  double near_conflicts = 0.0;  ///< with moving vehicles, on the half of the carriageway beside
                                ///< the kerb that it came from
  double far_conflicts = 0.0;   ///< ... and on the other
};
const Table<SeenCrossing>& seen_crossing_table();

}  // namespace pedzone
