// Streams that cross: two at right angles, and four.
#include <algorithm>
#include <cmath>

#include "verify/measures.hpp"
#include "verify/references.hpp"
#include "verify/standard_test.hpp"

namespace pedzone::verify {
namespace {

constexpr double kStreet = 4.0, kArm = 16.0;  // [m] width; length from the middle to an arm's end
constexpr double kHalf = kStreet / 2.0;
constexpr double kMost = 300.0;  // [s] assumed: twenty times what one person alone needs

/// Arms of `arm` [m].
Region cross_ground(double arm) {
  return joined({box(-arm, -kHalf, arm, kHalf), box(-kHalf, -arm, kHalf, arm)});
}

/// Direction of a stream: 0 to the east, 1 to the north, 2 to the west, 3 to the south.
Vec2 way_of(int stream) { return turned(Vec2(1.0, 0.0), stream * kPi / 2.0); }

struct Crossing {
  int streams;
  std::size_t each;  ///< people of a stream
};

/// Fills the arm that the stream comes from, up to 1.5 m before the square.
void fill(Trial& trial, const Crossing& crossing, int stream) {
  const double angle = stream * kPi / 2.0;
  const Vec2 low(-kArm + kBodyRadius, -kHalf), high(-kHalf - 1.5, kHalf);
  const std::uint64_t seed = 10 * trial.seed() + static_cast<std::uint64_t>(stream);
  for (const Vec2& at : places_in(low, high, crossing.each, seed)) {
    trial.add(turned(at, angle),
              {turned(Vec2(kArm, -kHalf), angle), turned(Vec2(kArm, kHalf), angle)}, stream);
  }
}

Outcome run_crossing(const Crossing& crossing, const RunInput& input) {
  Trial trial(cross_ground(kArm + kOpenEnd), input);
  for (int stream = 0; stream < crossing.streams; ++stream) fill(trial, crossing, stream);
  // Both streams are in the square from about 5 s on; until half of the people are gone.
  AreaMeasure square(box(-kHalf, -kHalf, kHalf, kHalf), 5.0);
  Turns turns(Vec2::Zero());
  Jolts jolts;
  DensityMap map({-kArm / 2, -kArm / 2}, {kArm / 2, kArm / 2}, 0.25);
  trial.walk(kMost, [&] {
    turns.look(trial);
    jolts.look(trial);
    map.look(trial);
    if (2 * trial.arrived() < trial.people().size() && trial.time() < 60.0) {
      square.look(trial, [](const Participant& participant) { return way_of(participant.stream); });
    }
  });
  const double expected =
      interpolated(juelich_two_ways(), square.density()).value_or(weidmann_speed(square.density()));
  Outcome outcome;
  outcome.figures["density"] = square.density();
  outcome.figures["speed"] = square.speed();
  outcome.figures["ratio"] = square.speed() / expected;
  outcome.figures["turns"] = turns.most();
  outcome.figures["jolts"] = jolts.share();
  outcome.figures["arrived"] =
      static_cast<double>(trial.arrived()) / static_cast<double>(trial.people().size());
  outcome.figures["time"] = trial.last_arrival(kMost);
  outcome.curves["diagram"] = {{square.density(), square.speed()}};
  outcome.map = map.grid();
  return outcome;
}

StandardTest crossing_test(const Crossing& crossing) {
  StandardTest test;
  test.run = [crossing](const RunInput& input, std::size_t) {
    return run_crossing(crossing, input);
  };
  test.charts = {{"diagram",
                  "Speed against density in the square",
                  "density, persons/m²",
                  "speed, m/s",
                  {weidmann_reference(), {"Jülich, two ways", juelich_two_ways(), false}},
                  {},
                  {}}};
  test.drawing.walkable = cross_ground(kArm);
  test.drawing.measured.push_back(box(-kHalf, -kHalf, kHalf, kHalf));
  for (int stream = 0; stream < crossing.streams; ++stream) {
    const double angle = stream * kPi / 2.0;
    Ring start = box(-kArm, -kHalf, -kHalf - 1.5, kHalf);
    for (Vec2& corner : start) corner = turned(corner, angle);
    test.drawing.starts.push_back({start, stream});
    test.drawing.arrows.push_back(
        {turned(Vec2(-6.0, 0.0), angle), turned(Vec2(-1.0, 0.0), angle), stream});
  }
  return test;
}

FigureSpec arrived() {
  return in_every_seed(at_least("arrived", "share of people who arrive within 300 s", "", 2, 1.0,
                                "nobody is stuck"));
}

FigureSpec most_turns() {
  return in_every_seed(at_most("turns", "most turns of anybody round the middle", "", 2, 1.0,
                               "assumed: no vortex that does not end"));
}

StandardTest right_angles() {
  StandardTest test = crossing_test({2, 70});
  test.id = "crossing-90";
  test.title = "Two streams cross at right angles";
  test.source = "Zhang and Seyfried 2014: the diagram does not depend on the angle";
  test.setup =
      "70 people (1.4 /m²) each go straight on over a crossing of two streets 4 m wide. Speed "
      "along one's own way and density in the square, by Voronoi cells.";
  test.figures = {between("ratio", "speed over that of Jülich's two ways at this density", "", 2,
                          1.0 - kBandSlack, 1.0 + kBandSlack, "Jülich ± 15 %"),
                  arrived(),
                  most_turns(),
                  stopped_short(),
                  told("density", "density in the square", "/m²", 2),
                  told("speed", "speed in the square", "m/s", 2),
                  told("time", "time of the last", "s", 0)};
  return test;
}

StandardTest four_ways() {
  StandardTest test = crossing_test({4, 50});
  test.id = "crossing-four-ways";
  test.title = "Four streams cross";
  test.source = "Helbing, Buzna, Johansson and Werner 2005: vortices come and go";
  test.setup = "50 people (1 /m²) come from each arm of a crossing of streets 4 m wide.";
  test.figures = {arrived(),
                  most_turns(),
                  stopped_short(),
                  told("ratio", "speed over that of Jülich's two ways at this density", "", 2),
                  told("density", "density in the square", "/m²", 2),
                  told("speed", "speed in the square", "m/s", 2),
                  told("time", "time of the last", "s", 0)};
  return test;
}

}  // namespace

std::vector<StandardTest> crossing_tests() { return {right_angles(), four_ways()}; }

}  // namespace pedzone::verify
