// Level of service of a walkway: how crowded it is, from A to F.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace pedzone {

struct ServiceLevel {
  std::string_view name;
  double least;  ///< [persons/m²] from which on it is this level
};

/// J. J. Fruin, "Pedestrian Planning and Design", 1971: walkways. He gives the area per person:
/// 3.25, 2.32, 1.39, 0.93 and 0.46 m².
inline constexpr std::array<ServiceLevel, 6> kServiceLevels{{{"A", 0.0},
                                                             {"B", 1.0 / 3.25},
                                                             {"C", 1.0 / 2.32},
                                                             {"D", 1.0 / 1.39},
                                                             {"E", 1.0 / 0.93},
                                                             {"F", 1.0 / 0.46}}};

/// Index of the level of a density [persons/m²] >= 0.
std::size_t service_level(double density);

/// As `#rrggbb`: dark where it is crowded, as the maps of a study's report.
std::string service_colour(std::size_t level);

/// "A: below 0.31", "B: 0.31 to 0.43", ... "F: 2.17 and more"; persons/m².
std::string service_text(std::size_t level);

}  // namespace pedzone
