// When people were in a zone, by the edges that SUMO has them on. Their place alone does not say
// whose they are: at a junction that zone and streets share, people of both walk in one space.
//
// Somebody is in a zone on its edges, and in a junction between two of them. Where a junction led
// is known only when it is left, so that what happened in it is told later.
#pragma once

#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "study/measure/closeness.hpp"
#include "study/measure/pedestrians.hpp"
#include "zone/zone.hpp"

namespace pedzone::study {

/// A step of a run, as its outputs have it.
struct RunStep {
  std::uint64_t number = 0;
  double time = 0.0;  ///< [s]
  double dt = 0.0;    ///< [s] since the one before; 0 for the first
};

/// Somebody in a zone in a step.
struct Presence {
  RunStep step;
  Pedestrian pedestrian;  ///< whose edge is empty
  int zone = 0;           ///< index
  Closeness closeness;

  /// Neither waits for a ride nor stops as planned.
  bool walks() const { return pedestrian.walk != nullptr; }
};

class ZoneStays {
 public:
  /// `trips` and `network` must outlive it.
  ZoneStays(const Trips& trips, const Network& network, const std::vector<Zone>& zones);

  /// Takes in a step, with the `closeness` of each pedestrian. Returns what is known now and was
  /// not before: each person's presences in the order of time. Valid until the next call.
  std::span<const Presence> step(const RunStep& step, std::span<const Pedestrian> pedestrians,
                                 std::span<const Closeness> closeness);

  /// After the last step: of those who are in a junction to the end. They came from the zone.
  std::span<const Presence> finish();

  /// Whether somebody was in a zone at a time [s]. To be asked after the last step.
  bool cover(std::string_view person, double time) const;

 private:
  /// From `begin` [s] on; `where`: index of the zone, or one of those below.
  struct Stay {
    double begin;
    int where;
  };
  static constexpr int kOutside = -1, kJunction = -2;
  struct Person {
    std::vector<Stay> stays;         ///< neighbours are in different places
    int last_edge = kOutside;        ///< the zone of the last edge, or kOutside
    std::vector<Presence> junction;  ///< since it left that edge, where it was a zone's
  };

  int where(std::string_view edge) const;
  void settle(Person& person);

  std::unordered_map<std::string_view, std::size_t> index_;  ///< of persons, by id
  std::unordered_map<std::string_view, int> zone_of_edge_;   ///< by id
  std::vector<Person> persons_;                              ///< as Trips::persons
  std::vector<Presence> known_;                              ///< since the latest call
};

}  // namespace pedzone::study
