// What people walk in the zones: time, distance, waiting, and what it would have been without
// others.
//
// A visit is the part of a walk between entering a zone and leaving it, by SUMO's edges
// (zone_stays.hpp). A visit that the end of the run cuts off counts up to there: those who are
// stuck must not drop out of the mean.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/measure/zone_stays.hpp"

namespace pedzone::study {

class ZoneWalks {
 public:
  /// `free_share`: of SUMO's maximum speed at which people walk freely (0, 1]. All must outlive it.
  ZoneWalks(const Trips& trips, const std::vector<Zone>& zones, double free_share);

  /// Takes in somebody in a zone, each person's presences in the order of time: who walks counts.
  void add(const Presence& presence);

  /// Closes all visits and appends the measures person.delay ... person.visitors.
  void finish(std::map<std::string, double>& values);

 private:
  struct Amount {
    double time = 0.0;     ///< [s]
    double waiting = 0.0;  ///< [s] standing
    double walked = 0.0;   ///< [m] between the places
    double covered = 0.0;  ///< [m] speed times time
    double jumped = 0.0;   ///< [m] put on by more than that, in steps by kJump and more
    void add(const Amount& other);
  };
  struct Visit {
    Presence first, last;
    Amount amount;
  };
  struct Person {
    std::optional<Visit> visit;           ///< the latest, not yet in what follows
    bool visitor = false;                 ///< has been in a zone
    Amount total;                         ///< of all visits
    double shortest = 0.0, walked = 0.0;  ///< [m] of visits that have a shortest way
    std::optional<double> delay;          ///< [s] of those
  };

  void close(Person& person);

  const std::vector<Zone>& zones_;
  double free_share_;
  std::vector<Person> persons_;  ///< as Trips::persons
};

}  // namespace pedzone::study
