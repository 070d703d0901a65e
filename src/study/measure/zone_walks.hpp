// What people walk in the zones: time, distance, waiting, and what it would have been without
// others.
//
// A visit is the part of a walk between entering a zone's walkable area and leaving it. Who is out
// of it for up to kGap and comes back has not left: SUMO's own models walk people through corners
// of obstacles and over the area's rims. A visit that the end of the run cuts off counts up to
// there: those who are stuck must not drop out of the mean.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/measure/walkers.hpp"

namespace pedzone::study {

/// [s] assumed: at walking pace past any corner; nobody leaves by one side and is back by then.
inline constexpr double kGap = 5.0;

class ZoneWalks {
 public:
  /// `free_share`: of SUMO's maximum speed at which people walk freely (0, 1]. All must outlive it.
  ZoneWalks(const Trips& trips, const std::vector<Zone>& zones, double free_share);

  /// Takes in a step, `dt` [s] after the one before.
  void step(double dt, std::span<const Walker> walkers);

  /// Closes all visits and appends the measures person.delay ... person.visitors.
  void finish(std::map<std::string, double>& values);

 private:
  struct Amount {
    double time = 0.0;     ///< [s]
    double waiting = 0.0;  ///< [s] standing
    double walked = 0.0;   ///< [m] between the places
    double covered = 0.0;  ///< [m] speed times time
    void add(const Amount& other);
  };
  struct Visit {
    int zone = Walker::kNowhere;  ///< kNowhere: none is open
    const WalkStage* walk = nullptr;
    Vec2 entry = Vec2::Zero(), exit = Vec2::Zero();  ///< [m]
    Amount inside, gap;                              ///< gap: since it was inside last
  };
  struct Person {
    std::uint64_t seen = 0;           ///< number of the latest step
    const WalkStage* walk = nullptr;  ///< in that step
    Vec2 at = Vec2::Zero();           ///< [m] in that step
    Visit visit;
    bool visitor = false;                 ///< has been in a zone
    Amount total;                         ///< of all visits
    double shortest = 0.0, walked = 0.0;  ///< [m] of visits that have a shortest way
    std::optional<double> delay;          ///< [s] of those
  };

  void follow(const Walker& walker, const Amount& since, Person& person);
  void close(Person& person);

  const std::vector<Zone>& zones_;
  double free_share_;
  std::uint64_t step_ = 0;
  std::vector<Person> persons_;  ///< as Trips::persons
};

}  // namespace pedzone::study
