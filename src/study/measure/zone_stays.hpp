// When people walked in a zone, by the edges that SUMO has them on. Their place alone does not say
// whose they are: at a junction that zone and streets share, people of both walk in one space.
#pragma once

#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "study/measure/walkers.hpp"

namespace pedzone::study {

class ZoneStays {
 public:
  /// `trips` and `network` must outlive it.
  ZoneStays(const Trips& trips, const Network& network, const std::vector<Zone>& zones);

  /// Takes a time step [s], later than the one before.
  void step(double time, std::span<const Walker> walkers);

  /// Whether somebody was in a zone at a time [s]: on one of its edges, or in a junction between
  /// two of them. To be asked after the last step: only then it is known where a junction led.
  bool cover(std::string_view person, double time) const;

 private:
  /// From `begin` [s] on; `where`: index of the zone, or one of those below.
  struct Stay {
    double begin;
    int where;
  };
  static constexpr int kOutside = -1, kJunction = -2;
  int where(std::string_view edge) const;

  std::unordered_map<std::string_view, std::size_t> index_;  ///< of persons, by id
  std::unordered_map<std::string_view, int> zone_of_edge_;   ///< by id
  std::vector<std::vector<Stay>> stays_;  ///< by person; neighbours are in different places
};

}  // namespace pedzone::study
