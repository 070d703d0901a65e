// Doors and narrow corridors that a crowd goes through.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/measures.hpp"
#include "verify/references.hpp"
#include "verify/standard_test.hpp"

namespace pedzone::verify {
namespace {

const std::vector<double> kWidths{0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0};  // [m]
constexpr double kHalf = 5.0;                                          // [m] the room is 10 m wide
constexpr double kCrowd = 3.0;       // [persons/m²] assumed: Seyfried 2009 had 3.3 before the door
constexpr double kPerMetre = 100.0;  // [persons/m] assumed: over a minute of steady flow
constexpr double kWall = 0.2;        // [m] assumed: a door's wall
constexpr double kCorridor = 4.0;    // [m] long, as Seyfried 2009
constexpr double kAway = 4.0;        // [m] people leave so far behind it

struct Bottleneck {
  double width, length;  ///< [m]

  std::size_t people() const {
    return static_cast<std::size_t>(std::lround(kPerMetre * std::max(1.0, width)));
  }
  double depth() const { return static_cast<double>(people()) / (kCrowd * 2.0 * kHalf); }

  /// `open`: with the open end behind where people leave.
  Region ground(bool open) const {
    const double behind = kAway + (open ? kOpenEnd : 0.0);
    return joined({box(-depth() - 0.5, -kHalf, 0.0, kHalf),
                   box(-0.1, -width / 2, length + 0.1, width / 2),
                   box(length, -kHalf, length + behind, kHalf)});
  }
};

std::string key_at(double width) { return fmt::format("flow-{:.1f}", width); }

Outcome run_width(double length, const RunInput& input, std::size_t index) {
  const Bottleneck place{kWidths[index], length};
  constexpr double kMost = 400.0;  // [s] assumed: a quarter of the flow expected is no flow
  Trial trial(place.ground(true), input);
  const Destination out = line_at_x(length + kAway, -kHalf + 0.5, kHalf - 0.5);
  const Vec2 low(-place.depth() - 0.5 + kBodyRadius, -kHalf), high(-kBodyRadius, kHalf);
  for (const Vec2& at : places_in(low, high, place.people(), input.seed)) trial.add(at, out);
  const double middle = 0.1;
  FlowLine line({middle, place.width / 2}, {middle, -place.width / 2});
  DensityMap map({-6.0, -kHalf}, {length + 4.0, kHalf}, 0.25);
  trial.walk(kMost, [&] {
    line.look(trial);
    map.look(trial);
  });
  Outcome outcome;
  const double flow = line.flow() / place.width;
  const double through = static_cast<double>(line.count()) / static_cast<double>(place.people());
  outcome.figures[key_at(place.width)] = flow;
  outcome.figures[fmt::format("through-{:.1f}", place.width)] = through;
  outcome.curves["flow"] = {{place.width, line.flow()}};
  outcome.curves["specific"] = {{place.width, flow}};
  if (place.width == 1.0) {
    outcome.map = map.grid();
  }
  return outcome;
}

/// Figures that rest on all widths.
void conclude(Outcome& outcome) {
  double least_rise = 1e9, before = 0.0, through = 1.0;
  for (const double width : kWidths) {
    const double flow = outcome.figures[key_at(width)] * width;
    least_rise = std::min(least_rise, flow - before);
    before = flow;
    through = std::min(through, outcome.figures[fmt::format("through-{:.1f}", width)]);
  }
  outcome.figures["least-rise"] = least_rise;
  outcome.figures["through"] = through;
}

Drawing drawing_of(const Bottleneck& place) {
  Drawing drawing;
  drawing.walkable = place.ground(false);
  drawing.starts.push_back({box(-place.depth() - 0.5, -kHalf, 0.0, kHalf), 0});
  drawing.lines.push_back({{0.1, -place.width / 2}, {0.1, place.width / 2}});
  drawing.arrows.push_back({{-2.0, 0.0}, {place.length + 3.0, 0.0}, 0});
  return drawing;
}

/// What all bottlenecks share. `length` [m] of the narrow part.
StandardTest bottleneck_test(double length) {
  StandardTest test;
  test.cases = kWidths.size();
  test.run = [length](const RunInput& input, std::size_t index) {
    return run_width(length, input, index);
  };
  test.conclude = conclude;
  test.map_of = "A width of 1 m.";
  test.drawing = drawing_of({1.0, length});
  // Points of Seyfried, Passon, Steffen, Boltes, Rupprecht and Klingsch 2009: 1.9 per metre.
  const Reference seyfried{"1.9 persons/(m·s), Seyfried 2009",
                           {{kWidths.front(), 1.9 * kWidths.front()}, {3.0, 1.9 * 3.0}},
                           true};
  const Reference least{
      "1.3 persons/(m·s)", {{kWidths.front(), 1.3 * kWidths.front()}, {3.0, 1.3 * 3.0}}, true};
  test.charts = {
      {"flow", "Flow against width", "width, m", "flow, persons/s", {least, seyfried}, {}, {}},
      {"specific",
       "Flow a metre of width",
       "width, m",
       "flow, persons/(m·s)",
       {},
       {{1.0, 1.3}, {2.0, 1.3}},
       {{1.0, 1.9}, {2.0, 1.9}}}};
  return test;
}

void add_figures(StandardTest& test) {
  for (const double width : kWidths) {
    const bool limited = width == 1.0 || width == 2.0;
    FigureSpec figure{key_at(width), fmt::format("flow, {:g} m wide", width), "/(m·s)"};
    if (limited) {
      figure.least = 1.3;
      figure.most = 1.9;
      figure.limit_source = "Kretz 2006, Seyfried 2009, Rupprecht 2011: 1.3 to 1.9";
    } else {
      figure.judged = Judged::kNot;
    }
    test.figures.push_back(figure);
  }
  test.figures.push_back(at_least("least-rise", "least rise of flow from one width to the next",
                                  "persons/s", 2, 0.0, "flow rises with width (Seyfried 2009)"));
  test.figures.push_back(in_every_seed(at_least(
      "through", "share of people who get through within 400 s", "", 2, 1.0, "nobody is stuck")));
}

StandardTest doors() {
  StandardTest test = bottleneck_test(kWall);
  test.id = "doors";
  test.title = "Doors of 0.8 to 3 m";
  test.source = "Kretz 2006; Seyfried 2009; Rupprecht 2011; ISO 20414, test 11";
  test.setup =
      "A room 10 m wide, at first with 3 persons/m² (100 a metre of door), and a door in a wall "
      "of 0.2 m. Flow between the passages of the first and the last fifth.";
  add_figures(test);
  return test;
}

StandardTest corridors() {
  StandardTest test = bottleneck_test(kCorridor);
  test.id = "narrow-corridors";
  test.title = "Narrow corridors of 0.8 to 3 m";
  test.source = "Seyfried 2009; Rupprecht 2011";
  test.setup =
      "The same with a corridor of 4 m behind the door, as wide as it. Flow at its beginning.";
  add_figures(test);
  return test;
}

}  // namespace

std::vector<StandardTest> bottleneck_tests() { return {doors(), corridors()}; }

}  // namespace pedzone::verify
