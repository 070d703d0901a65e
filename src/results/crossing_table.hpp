// The table of those who crossed streets between the junctions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/table.hpp"

namespace pedzone {

/// Somebody who stepped out to cross a street between the junctions.
struct StreetCrossed {
  double time = 0.0;           ///< [s] when it stepped out
  std::string person, zone, street;  ///< ids; a street has that of its first edge
  double x = 0.0, y = 0.0;     ///< [m] where
  double pos = 0.0;            ///< [m] along the street
  double width = 0.0;          ///< [m] of the carriageway
  double waited = 0.0;         ///< [s] at the kerb
  std::optional<double> gap;   ///< [s] until the next vehicle came; unset: none was seen
  double needed = 0.0;         ///< [s] critical gap
  bool looked = true;          ///< false: stepped out without looking
  std::vector<float> rejected; ///< [s] gaps that it had let pass
};

const Table<StreetCrossed>& crossing_table();

}  // namespace pedzone
