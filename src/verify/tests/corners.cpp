// Corners and a junction.
#include <algorithm>
#include <cmath>

#include "verify/measures.hpp"
#include "verify/references.hpp"
#include "verify/standard_test.hpp"

namespace pedzone::verify {
namespace {

/// A way that comes along +x, turns left and goes on along +y; both arms from the inner corner's
/// sides are `arm` [m] long.
struct Corner {
  double width, arm;

  double outer() const { return arm + width; }
  Region ground() const {
    return joined({box(0.0, 0.0, outer(), width), box(arm, 0.0, outer(), outer() + kOpenEnd)});
  }
  Destination end() const { return line_at_y(outer(), arm, outer()); }
};

struct CornerRun {
  const Corner& corner;
  double start;  ///< [m] people stand at first from x = 0 to here
  std::size_t people;
};

void fill(Trial& trial, const CornerRun& run) {
  const Vec2 low(kBodyRadius, 0.0), high(run.start, run.corner.width);
  for (const Vec2& at : places_in(low, high, run.people, trial.seed())) {
    trial.add(at, run.corner.end());
  }
}

Drawing drawing_of(const CornerRun& run) {
  const Corner& corner = run.corner;
  Drawing drawing;
  drawing.walkable = joined({box(0.0, 0.0, corner.outer(), corner.width),
                             box(corner.arm, 0.0, corner.outer(), corner.outer())});
  drawing.starts.push_back({box(0.0, 0.0, run.start, corner.width), 0});
  const double middle = corner.arm + corner.width / 2.0;
  drawing.arrows.push_back({{run.start, corner.width / 2}, {corner.arm, corner.width / 2}, 0});
  drawing.arrows.push_back({{middle, corner.width}, {middle, corner.outer() - 1.0}, 0});
  return drawing;
}

StandardTest rimea_6() {
  static const Corner corner{2.0, 10.0};
  static const CornerRun run{corner, 6.0, 20};
  StandardTest test;
  test.id = "rimea-6";
  test.title = "Round a corner";
  test.source = "RiMEA 4.1.1, test 6; IMO 1533, test 6; ISO 20414, test 4";
  test.setup =
      "20 people in the first 6 m of a corridor 2 m wide, which turns left after 10 m and goes on "
      "for 10 m.";
  test.behaviour = false;
  test.figures = {
      in_every_seed(at_most("outside", "moments with somebody outside", "", 0, 0.0, "RiMEA")),
      in_every_seed(at_least("arrived", "people who arrive within 120 s", "", 0, 20.0, "RiMEA")),
      told("time", "time of the last", "s", 1)};
  test.drawing = drawing_of(run);
  test.run = [](const RunInput& input, std::size_t) {
    constexpr double kMost = 120.0;
    Trial trial(corner.ground(), input);
    fill(trial, run);
    trial.walk(kMost);
    Outcome outcome;
    outcome.figures["outside"] = static_cast<double>(trial.outside());
    outcome.figures["arrived"] = static_cast<double>(trial.arrived());
    outcome.figures["time"] = trial.last_arrival(kMost);
    return outcome;
  };
  return test;
}

StandardTest corner_flow() {
  static const Corner corner{2.0, 26.0};
  static const CornerRun run{corner, 24.0, 130};
  StandardTest test;
  test.id = "corner-2m";
  test.title = "A crowd in a corner of 2 m";
  test.source = "Weidmann 1993; Zhang, Klingsch, Schadschneider and Seyfried 2011 (corner)";
  test.setup =
      "130 people (2.7 /m²) fill 24 m of a corridor 2 m wide, which turns left. Flow 2 m behind "
      "the corner, between the passages of the first and the last fifth.";
  test.figures = {
      between("flow", "flow behind the corner", "/(m·s)", 2, (1.0 - kBandSlack) * kWeidmannFlow,
              1.9, "Weidmann's greatest flow less 15 %; that of bottlenecks"),
      in_every_seed(
          at_least("arrived", "people who arrive within 300 s", "", 0, 130.0, "nobody is stuck"))};
  test.drawing = drawing_of(run);
  const double y = corner.width + 2.0;
  const Vec2 right(corner.outer(), y), left(corner.arm, y);
  test.drawing.lines.push_back({left, right});
  test.run = [=](const RunInput& input, std::size_t) {
    Trial trial(corner.ground(), input);
    fill(trial, run);
    FlowLine line(left, right);
    DensityMap map({corner.arm - 8.0, 0.0}, {corner.outer(), corner.width + 8.0}, 0.25);
    trial.walk(300.0, [&] {
      line.look(trial);
      map.look(trial);
    });
    Outcome outcome;
    outcome.figures["flow"] = line.flow() / corner.width;
    outcome.figures["arrived"] = static_cast<double>(trial.arrived());
    outcome.map = map.grid();
    return outcome;
  };
  return test;
}

// RiMEA 15

constexpr double kWide = 4.0, kArm = 20.0, kCrowdLong = 10.0;  // [m] assumed: our reading
constexpr std::size_t kCrowd = 100;

/// 0: straight, as long as the corner's inner side; 1: the corner; 2: straight, as its outer side.
Outcome run_rimea_15(const RunInput& input, std::size_t index) {
  constexpr double kMost = 300.0;
  const Corner corner{kWide, kArm};
  const double length = index == 0 ? 2.0 * kArm : 2.0 * corner.outer();
  const bool straight = index != 1;
  Trial trial(straight ? repair(box(0.0, 0.0, length + kOpenEnd, kWide)) : corner.ground(), input);
  const Destination end = straight ? line_at_x(length, 0.0, kWide) : corner.end();
  for (const Vec2& at : places_in({kBodyRadius, 0.0}, {kCrowdLong, kWide}, kCrowd, input.seed)) {
    trial.add(at, end);
  }
  Jolts jolts;
  trial.walk(kMost, [&] { jolts.look(trial); });
  Outcome outcome;
  if (!straight) outcome.figures["jolts"] = jolts.share();
  const char* const keys[] = {"short", "corner", "long"};
  outcome.figures[keys[index]] = trial.last_arrival(kMost);
  outcome.figures[std::string("arrived-") + keys[index]] = static_cast<double>(trial.arrived());
  return outcome;
}

StandardTest rimea_15() {
  static const Corner corner{kWide, kArm};
  StandardTest test;
  test.id = "rimea-15";
  test.title = "A large crowd round a corner";
  test.source = "RiMEA 4.1.1, test 15";
  test.setup =
      "100 people in a corridor 4 m wide: straight and as long as the inner side of the corner, "
      "round the corner, straight and as long as its outer side. Time of the last.";
  test.figures = {
      at_least("after-short", "corner after short", "s", 1, 0.0, "RiMEA: short ≤ corner"),
      at_least("before-long", "long after corner", "s", 1, 0.0, "RiMEA: corner ≤ long"),
      in_every_seed(
          at_least("arrived", "people who arrive, fewest", "", 0, 100.0, "nobody is stuck")),
      stopped_short(),
      told("short", "time, short", "s", 1),
      told("corner", "time, corner", "s", 1),
      told("long", "time, long", "s", 1)};
  test.drawing = drawing_of({corner, kCrowdLong, kCrowd});
  test.cases = 3;
  test.run = run_rimea_15;
  test.conclude = [](Outcome& outcome) {
    auto& figures = outcome.figures;
    figures["after-short"] = figures["corner"] - figures["short"];
    figures["before-long"] = figures["long"] - figures["corner"];
    figures["arrived"] =
        std::min({figures["arrived-short"], figures["arrived-corner"], figures["arrived-long"]});
  };
  return test;
}

// The T-junction

constexpr double kStreet = 2.4;    // [m] wide, as in Jülich
constexpr double kBranch = 16.0;   // [m] long, from the stem's side
constexpr double kStem = 10.0;     // [m] long
constexpr std::size_t kEach = 90;  // people of a branch

Outcome run_junction(const RunInput& input, std::size_t) {
  const double half = kStreet / 2.0;
  Trial trial(joined({box(-half - kBranch, 0.0, half + kBranch, kStreet),
                      box(-half, 0.0, half, kStreet + kStem + kOpenEnd)}),
              input);
  const Destination end = line_at_y(kStreet + kStem, -half, half);
  for (const int stream : {0, 1}) {
    const double inner = half + 1.5, outer = half + kBranch - kBodyRadius;
    const double low = stream == 0 ? -outer : inner, high = stream == 0 ? -inner : outer;
    for (const Vec2& at : places_in({low, 0.0}, {high, kStreet}, kEach, 2 * input.seed + stream)) {
      trial.add(at, end, stream);
    }
  }
  FlowLine line({-half, kStreet + 2.0}, {half, kStreet + 2.0});
  DensityMap map({-half - 8.0, 0.0}, {half + 8.0, kStreet + 8.0}, 0.25);
  trial.walk(300.0, [&] {
    line.look(trial);
    map.look(trial);
  });
  double of_first = 0.0, counted = 0.0;
  const std::vector<double> times = line.times();
  const double half_time = times.empty() ? 0.0 : times[times.size() / 2];
  for (const auto& [person, time] : line.passages()) {
    if (time > half_time) continue;
    counted += 1.0;
    of_first += trial.people()[person].stream == 0 ? 1.0 : 0.0;
  }
  Outcome outcome;
  outcome.figures["flow"] = line.flow() / kStreet;
  outcome.figures["share"] = counted > 0.0 ? of_first / counted : std::nan("");
  outcome.figures["arrived"] = static_cast<double>(trial.arrived());
  outcome.map = map.grid();
  return outcome;
}

StandardTest junction() {
  const double half = kStreet / 2.0;
  StandardTest test;
  test.id = "t-junction";
  test.behaviour = false;
  test.title = "Two streams join";
  test.source = "Zhang, Klingsch, Schadschneider and Seyfried 2011 (T-junction); Weidmann 1993";
  test.setup =
      "90 people (2.6 /m²) come from each side of a T-junction of corridors 2.4 m wide. Flow in "
      "the "
      "stem, 2 m behind the junction.";
  test.figures = {
      between("flow", "flow in the stem", "/(m·s)", 2, (1.0 - kBandSlack) * kWeidmannFlow, 1.9,
              "Weidmann's greatest flow less 15 %; that of bottlenecks"),
      between("share", "share of the left branch in the first half", "", 2, 0.35, 0.65,
              "assumed: both sides are alike"),
      in_every_seed(
          at_least("arrived", "people who arrive within 300 s", "", 0, 180.0, "nobody is stuck"))};
  test.drawing.walkable = joined(
      {box(-half - kBranch, 0.0, half + kBranch, kStreet), box(-half, 0.0, half, kStreet + kStem)});
  test.drawing.starts = {{box(-half - kBranch, 0.0, -half - 1.5, kStreet), 0},
                         {box(half + 1.5, 0.0, half + kBranch, kStreet), 1}};
  test.drawing.lines.push_back({{-half, kStreet + 2.0}, {half, kStreet + 2.0}});
  test.drawing.arrows = {{{-half - 5.0, half}, {-half, half}, 0},
                         {{half + 5.0, half}, {half, half}, 1},
                         {{0.0, kStreet}, {0.0, kStreet + 8.0}, 0}};
  test.run = run_junction;
  return test;
}

}  // namespace

std::vector<StandardTest> corner_tests() {
  return {rimea_6(), rimea_15(), corner_flow(), junction()};
}

}  // namespace pedzone::verify
