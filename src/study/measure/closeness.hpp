// How close people are to each other: the density that each is in, and who stands in a jam.
//
// The density that a person is in is that of the circle of kCircle round it: all on foot in it, the
// person too, over its whole area, walls or not. So who is alone or in company is at level A, and a
// narrow passage alone does not make a crowd.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "study/measure/pedestrians.hpp"

namespace pedzone::study {

/// [m] assumed: the least in which 1 to 3 persons are at level A and no level is without a number
/// of persons.
inline constexpr double kCircle = 2.0;
/// [s] assumed: who has stood so long does not just give way.
inline constexpr double kJamTime = 5.0;
/// Others, besides, who stand within kCircle of one in a jam. Assumed: two people talk, three wait.
inline constexpr int kJamOthers = 2;

/// Density [1/m²] of so many persons in the circle.
double circle_density(int persons);

/// How close others are to a person in a step.
struct Closeness {
  double density = 0.0;  ///< [1/m²]
  bool jammed = false;   ///< it stands in a jam
};

/// Tells it of everybody.
class ClosenessMeter {
 public:
  explicit ClosenessMeter(const Trips& trips);

  /// Of each pedestrian in a step, `dt` [s] after the one before. Valid until the next call.
  std::span<const Closeness> of(double dt, std::span<const Pedestrian> pedestrians);

 private:
  struct Near {
    int all = 0, stuck = 0;  ///< others within kCircle; those of them who have stood long
  };
  struct Standing {
    std::uint64_t seen = 0;  ///< number of the latest step
    double time = 0.0;       ///< [s] up to that step
  };

  bool stands_long(double dt, const Pedestrian& pedestrian);
  void count_near(std::span<const Pedestrian> pedestrians);

  std::uint64_t step_ = 0;
  std::vector<Standing> standing_;    ///< as Trips::persons
  std::vector<std::uint32_t> order_;  ///< pedestrians of this step by x
  std::vector<char> stuck_;           ///< of this step
  std::vector<Near> near_;
  std::vector<Closeness> closeness_;
};

}  // namespace pedzone::study
