// What is measured while a test is walked: flows across lines, densities and speeds in areas,
// lanes.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "verify/trial.hpp"

namespace pedzone::verify {

/// When each person first crosses a line from its right to its left.
class FlowLine {
 public:
  FlowLine(const Vec2& a, const Vec2& b) : a_(a), b_(b) {}

  /// After every step of the trial.
  void look(const Trial& trial);
  /// The step from `before` to `at` of one person, which ends at `time` [s].
  void look(std::size_t person, const Vec2& before, const Vec2& at, double time);

  /// [s] ascending.
  std::vector<double> times() const;
  /// [s] by person.
  const std::map<std::size_t, double>& passages() const { return passed_; }
  std::size_t count() const { return passed_.size(); }
  /// [persons/s] between the passages of ranks `from` and `to` (shares of all); 0 where fewer
  /// than three pass.
  double flow(double from = 0.2, double to = 0.8) const;

 private:
  Vec2 a_, b_;
  std::map<std::size_t, double> passed_;
};

/// Density and speed in a convex area by Voronoi cells, mean over moments.
class AreaMeasure {
 public:
  /// `every` [s]: time between two moments, and over which speeds are taken.
  AreaMeasure(Ring area, double from, double every = 0.5)
      : area_(std::move(area)), from_(from), every_(every) {}

  /// After every step. Speeds: displacement over `every`; where `way` is given, along it.
  void look(const Trial& trial, const std::function<Vec2(const Participant&)>& way = {});

  double density() const { return moments_ > 0 ? density_ / moments_ : 0.0; }  ///< [1/m²]
  /// [m/s] by area and, between moments, by the number of people there.
  double speed() const { return weight_ > 0.0 ? speed_ / weight_ : 0.0; }
  int moments() const { return moments_; }

 private:
  Ring area_;
  double from_, every_;
  std::vector<Vec2> then_;  ///< [m] Participant::moved at the moment before
  double density_ = 0.0, speed_ = 0.0, weight_ = 0.0;
  int moments_ = 0;
};

/// A density map of one run.
struct GridMap {
  Vec2 low = Vec2::Zero();  ///< [m] lower left corner
  double cell = 0.5;        ///< [m]
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;  ///< [persons/m²] rows from the bottom, each from the left
};

/// Where people are, as counts a square metre and moment.
class DensityMap {
 public:
  DensityMap(const Vec2& low, const Vec2& high, double cell = 0.5);
  /// After every step: adds a moment each second.
  void look(const Trial& trial);

  /// Means over moments.
  GridMap grid() const;

 private:
  Vec2 low_;
  double cell_;
  std::size_t columns_, rows_;
  std::vector<double> sums_;
  int moments_ = 0;
};

/// A person's place across a corridor and its way along it (+1 or -1).
struct LanePlace {
  double across = 0.0;  ///< [m]
  int way = 1;
};

/// Yamori's band index: the corridor is cut along its way into bands of about `band` [m]; in each
/// ((n+ - n-)/(n+ + n-))², mean over people. 1: every band has one way only.
double band_index(std::span<const LanePlace> people, double low, double high, double band = 0.5);

/// How many lanes lie side by side: runs of bands in which one way prevails, by places gathered
/// over some time.
int lane_count(std::span<const LanePlace> people, double low, double high, double band = 0.5);

/// Who is stopped short: loses `kJolt` of its speed within a step. People brake within half a
/// second (Moussaid's relaxation time); only who walks into a body or a wall stops sooner.
class Jolts {
 public:
  static constexpr double kJolt = 0.5;  ///< [m/s] assumed: in 0.1 s twice what braking explains

  /// After every step.
  void look(const Trial& trial);
  /// Share [1] of all people to whom it happened.
  double share() const;

 private:
  std::vector<Vec2> moved_;  ///< [m] in the step before, by person
  std::vector<char> stopped_;
};

/// By how many whole turns [1] the person that winds most has gone round `centre`, either way.
class Turns {
 public:
  explicit Turns(const Vec2& centre) : centre_(centre) {}
  void look(const Trial& trial);
  double most() const;

 private:
  Vec2 centre_;
  std::vector<double> angles_, most_;
};

}  // namespace pedzone::verify
