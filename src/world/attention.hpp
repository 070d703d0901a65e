// How people perceive at present, where they differ: profile, activity and weather together, and
// which vehicles each of them does not mind (not yet noticed, hidden, or unaware of vehicles).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace pedzone {

/// Of one person.
struct Perception {
  double field_of_view = 90.0;  ///< [deg] (0, 180] half angle
  double hearing = 8.0;         ///< [m] ≥ 0, of a car that drives slowly
  double caution = 1.0;         ///< > 0 factor of the clearance wanted to vehicles
  double top_speed = std::numeric_limits<double>::infinity();  ///< [m/s] > 0, in a hurry
};

/// Of all persons whom pedzone walks, in the order of Persons.
struct Attention {
  std::vector<Perception> persons;
  std::vector<std::uint64_t> ignored;  ///< `words` a person; bit v: does not mind vehicle v
  std::size_t words = 0;
  double widest_field = 90.0;     ///< [deg] of anybody
  double farthest_hearing = 8.0;  ///< [m] of anybody

  bool minds(std::size_t person, std::size_t vehicle) const {
    return (ignored[person * words + vehicle / 64] >> (vehicle % 64) & 1U) == 0;
  }
  void ignore(std::size_t person, std::size_t vehicle) {
    ignored[person * words + vehicle / 64] |= std::uint64_t{1} << (vehicle % 64);
  }
};

}  // namespace pedzone
