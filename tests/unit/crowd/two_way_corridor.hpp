// The corridor of Helbing and Molnár (1995, Fig. 2): people walk both ways, whoever leaves comes in
// again at the other end. How well they have sorted themselves into lanes, and how fast they walk.
#pragma once

#include <cstdint>
#include <string>

#include "scene.hpp"

namespace pedzone::test {

struct CorridorSpec {
  std::string model = "social-force";
  double length = 50.0, width = 10.0;  ///< [m] of the paper
  int each_way = 60;
  bool both_ways = true;        ///< else all walk the first way, twice as many of them
  double field_of_view = 90.0;  ///< [deg] half angle
  std::uint64_t seed = 1;
};

class TwoWayCorridor {
 public:
  explicit TwoWayCorridor(const CorridorSpec& spec);

  void run(double seconds);

  /// Mean over persons of ((same − other) / (same + other))², counted of those at most half a metre
  /// to its side, along the whole corridor: 1 in clean lanes. By the order parameter of Rex and
  /// Löwen (2007).
  double lane_order() const;
  /// The same if people had the directions in any order: the mean of many shuffles.
  double lane_order_by_chance() const;
  /// Mean speed along the corridor over the mean preferred one, since the last call.
  double efficiency();
  /// Contacts of two bodies now, of more than 1 cm.
  int contacts() const;

 private:
  struct Walker {
    Crowd::Handle handle;
    NewPerson given;
    double way;   ///< 1 or -1, along x
    double gone;  ///< [m]
    Vec2 at;
  };
  double lane_order(const std::vector<double>& ways) const;
  NewPerson entering(const Walker& walker, const Vec2& at, const Vec2& velocity) const;
  void step();

  CorridorSpec spec_;
  Zone zone_;
  Crowd crowd_;
  std::vector<Walker> walkers_;
  double time_ = 0.0, since_ = 0.0;  ///< [s]
};

}  // namespace pedzone::test
