// What a standard test is, and what comes out of it.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verify/measures.hpp"

namespace pedzone::verify {

struct Point {
  double x = 0.0, y = 0.0;
};
using Points = std::vector<Point>;

/// What the cases of one test give for one model and one seed.
struct Outcome {
  std::map<std::string, double> figures;  ///< by FigureSpec::key
  std::map<std::string, Points> curves;   ///< by ChartSpec::key
  std::optional<GridMap> map;
};

/// How a figure of several seeds is judged.
enum class Judged {
  kMedian,  ///< by the median
  kWorst,   ///< every seed has to keep the limits
  kNot      ///< only reported
};

struct FigureSpec {
  std::string key, label, unit;
  int digits = 2;
  std::optional<double> least = {}, most = {};  ///< limits, both inclusive
  std::string limit_source = {};                ///< where they come from; "assumed: why"
  Judged judged = Judged::kMedian;
};

/// Figures with their limits (both inclusive) and where those come from.
FigureSpec at_least(std::string key, std::string label, std::string unit, int digits, double least,
                    std::string source);
FigureSpec at_most(std::string key, std::string label, std::string unit, int digits, double most,
                   std::string source);
FigureSpec between(std::string key, std::string label, std::string unit, int digits, double least,
                   double most, std::string source);
/// A figure that is only reported; `remark` stands where others have their source.
FigureSpec told(std::string key, std::string label, std::string unit, int digits,
                std::string remark = "");
/// Jolts::share().
FigureSpec stopped_short();
/// The same, judged by the worst seed.
FigureSpec in_every_seed(FigureSpec figure);

/// A published curve or points, drawn beside what the models do.
struct Reference {
  std::string name;
  Points points;
  bool joined = true;  ///< drawn as a line, not as points
};

struct ChartSpec {
  std::string key, title, x_title, y_title;
  std::vector<Reference> references;
  Points band_low, band_high;  ///< what passes lies between; may be empty
};

/// The set-up as it is drawn.
struct Drawing {
  Region walkable;
  struct Start {
    Ring area;
    int stream = 0;
  };
  std::vector<Start> starts;    ///< where people of a stream stand at first
  std::vector<Ring> measured;   ///< areas in which something is measured
  std::vector<Polyline> lines;  ///< lines across which passages are counted
  struct Arrow {
    Vec2 from, to;
    int stream = 0;
  };
  std::vector<Arrow> arrows;
};

struct StandardTest {
  std::string id, title, source, setup;
  /// Whether it tests how people mind each other, so that the blind model must fail. Not so where
  /// walls and bodies alone, which the crowd keeps apart for every model, bring people through.
  bool behaviour = true;
  std::vector<FigureSpec> figures;
  std::vector<ChartSpec> charts;
  Drawing drawing;
  std::string map_of =
      {};                 ///< a sentence on which of the cases the density map shows; may be empty
  std::size_t cases = 1;  ///< runs that do not depend on each other, numbered from 0
  std::function<Outcome(const RunInput&, std::size_t)> run;
  /// Adds figures that rest on several cases. May be empty.
  std::function<void(Outcome&)> conclude;
};

/// All tests in the order in which they are reported.
std::vector<StandardTest> standard_tests();

/// Standard tests of RiMEA that cannot be walked on one level, and why.
struct LeftOut {
  std::string id, why;
};
const std::vector<LeftOut>& left_out_tests();

/// Each of a family of tests, in one file of tests/.
std::vector<StandardTest> single_walker_tests();
std::vector<StandardTest> diagram_tests();
std::vector<StandardTest> bottleneck_tests();
std::vector<StandardTest> room_tests();
std::vector<StandardTest> corner_tests();
std::vector<StandardTest> counterflow_tests();
std::vector<StandardTest> crossing_tests();
std::vector<StandardTest> lane_tests();

}  // namespace pedzone::verify
