// How close people in the zones are to each other: density, level of service, jams.
#pragma once

#include <array>
#include <map>
#include <string>

#include "study/measure/zone_stays.hpp"

namespace pedzone::study {

/// Level of service 0 (A) ... 5 (F) of walkways at a density [1/m²] (Fruin 1971).
int level_of_service(double density);

class Crowding {
 public:
  /// Takes in somebody in a zone: who walks counts.
  void add(const Presence& presence);

  /// Appends the measures space.*.
  void finish(std::map<std::string, double>& values) const;

 private:
  double time_ = 0.0, jammed_ = 0.0;    ///< [s] persons' time in zones, and in jams there
  double density_time_ = 0.0;           ///< [s/m²]
  std::array<double, 6> level_time_{};  ///< [s]
};

}  // namespace pedzone::study
