// How close people are to each other: density, level of service, jams.
//
// The density that a person is in is that of the circle of kCircle round it: all on foot in it, the
// person too, over its whole area, walls or not. So who is alone or in company is at level A, and a
// narrow passage alone does not make a crowd.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "study/measure/walkers.hpp"

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
/// Level of service 0 (A) ... 5 (F) of walkways at a density [1/m²] (Fruin 1971).
int level_of_service(double density);

/// How close others are to a person in a step.
struct Closeness {
  double density = 0.0;  ///< [1/m²]
  bool jammed = false;   ///< it stands in a jam
};

/// Tells it of everybody.
class ClosenessMeter {
 public:
  explicit ClosenessMeter(const Trips& trips);

  /// Of each walker in a step, `dt` [s] after the one before. Valid until the next call.
  std::span<const Closeness> of(double dt, std::span<const Walker> walkers);

 private:
  struct Near {
    int all = 0, stuck = 0;  ///< others within kCircle; those of them who have stood long
  };
  struct Standing {
    std::uint64_t seen = 0;  ///< number of the latest step
    double time = 0.0;       ///< [s] up to that step
  };

  bool stands_long(double dt, const Walker& walker);
  void count_near(std::span<const Walker> walkers);

  std::uint64_t step_ = 0;
  std::vector<Standing> standing_;    ///< as Trips::persons
  std::vector<std::uint32_t> order_;  ///< walkers of this step by x
  std::vector<char> stuck_;           ///< of this step
  std::vector<Near> near_;
  std::vector<Closeness> closeness_;
};

/// Its sums, of those who walk in a zone.
class Crowding {
 public:
  /// Somebody walks in a zone for `dt` [s].
  void add(double dt, const Closeness& closeness);

  /// Appends the measures space.*.
  void finish(std::map<std::string, double>& values) const;

 private:
  double time_ = 0.0, jammed_ = 0.0;    ///< [s] persons' time in zones, and in jams there
  double density_time_ = 0.0;           ///< [s/m²]
  std::array<double, 6> level_time_{};  ///< [s]
};

}  // namespace pedzone::study
