// Speed against density: RiMEA 4, and the corridors of Jülich.
#include <fmt/format.h>

#include "verify/references.hpp"
#include "verify/tests/periodic_corridor.hpp"

namespace pedzone::verify {
namespace {

struct Diagram {
  PeriodicCorridor corridor;
  std::vector<double> densities;  ///< [persons/m²]
  double from, until;             ///< [s] measured between
};

std::string key_at(double density) { return fmt::format("speed-{:.2f}", density); }

Outcome run_density(const Diagram& diagram, const RunInput& input, std::size_t index) {
  PeriodicCorridor corridor = diagram.corridor;
  const double density = diagram.densities[index];
  corridor.people = people_at(density, corridor.length, corridor.width);
  const Point state = state_of(corridor, input, diagram.from, diagram.until);
  Outcome outcome;
  outcome.figures[key_at(density)] = state.y;
  outcome.curves["diagram"] = {{state.x, state.y}};
  outcome.curves["flow"] = {{state.x, state.x * state.y}};
  return outcome;
}

/// The parts that all diagrams share: cases, drawing and the two charts.
StandardTest diagram_test(const Diagram& diagram) {
  StandardTest test;
  test.cases = diagram.densities.size();
  test.run = [diagram](const RunInput& input, std::size_t index) {
    return run_density(diagram, input, index);
  };
  test.drawing = diagram.corridor.drawing();
  const std::string density = "density, persons/m²";
  test.charts = {{"diagram", "Speed against density", density, "speed, m/s", {}, {}, {}},
                 {"flow", "Flow against density", density, "flow, persons/(m·s)", {}, {}, {}}};
  return test;
}

/// The same as a flow.
Reference flow_of(Reference reference) {
  for (Point& point : reference.points) point.y *= point.x;
  return reference;
}

void add_reference(StandardTest& test, const Reference& reference) {
  test.charts[0].references.push_back(reference);
  test.charts[1].references.push_back(flow_of(reference));
}

void add_limits(StandardTest& test, const Diagram& diagram, Band (*band)(double),
                const std::string& source) {
  for (const double density : diagram.densities) {
    const Band limits = band(density);
    test.figures.push_back(between(key_at(density),
                                   fmt::format("speed at {:g} persons/m²", density), "m/s", 2,
                                   limits.low, limits.high, source));
  }
  const double first = diagram.densities.front(), last = diagram.densities.back();
  constexpr int kParts = 40;
  for (int k = 0; k <= kParts; ++k) {
    const double density = first + (last - first) * k / kParts;
    const Band limits = band(density);
    test.charts[0].band_low.push_back({density, limits.low});
    test.charts[0].band_high.push_back({density, limits.high});
  }
}

StandardTest one_way() {
  const Diagram diagram{
      {.length = 26.0, .width = 1.8}, {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5}, 40.0, 100.0};
  StandardTest test = diagram_test(diagram);
  test.id = "diagram-one-way";
  test.title = "Fundamental diagram, one way";
  test.source = "Weidmann 1993; Zhang, Klingsch, Schadschneider and Seyfried 2011 (Jülich)";
  test.setup =
      "A corridor 1.8 m wide, as in Jülich, and 26 m long; who leaves at one end comes in at the "
      "other. Speed and density by Voronoi cells from 40 s to 100 s.";
  add_limits(test, diagram, one_way_band, "between Weidmann and Jülich, ± 15 %");
  add_reference(test, weidmann_reference());
  add_reference(test, {"Jülich, one way", juelich_one_way(), false});
  return test;
}

StandardTest two_ways() {
  Diagram diagram{{.length = 26.0, .width = 3.6, .both_ways = true}, {}, 40.0, 100.0};
  for (const Point& point : juelich_two_ways()) diagram.densities.push_back(point.x);
  StandardTest test = diagram_test(diagram);
  test.id = "diagram-two-ways";
  test.title = "Fundamental diagram, two ways";
  test.source = "Zhang, Klingsch, Schadschneider and Seyfried 2012 (Jülich)";
  test.setup =
      "A corridor 3.6 m wide, as in Jülich, and 26 m long; half of the people walk each way, "
      "mixed at first; who leaves at one end comes in at the other. Speed along one's own way, "
      "and density, by Voronoi cells from 40 s to 100 s.";
  add_limits(test, diagram, two_way_band, "Jülich ± 15 %");
  add_reference(test, weidmann_reference());
  add_reference(test, {"Jülich, two ways", juelich_two_ways(), false});
  return test;
}

void conclude_rimea_4(const Diagram& diagram, Outcome& outcome) {
  double fall = 1e9, deviation = 0.0;
  for (std::size_t k = 0; k < diagram.densities.size(); ++k) {
    const double density = diagram.densities[k], speed = outcome.figures[key_at(density)];
    deviation +=
        std::abs(speed - weidmann_speed(density)) / static_cast<double>(diagram.densities.size());
    if (k == 0) continue;
    fall = std::min(fall, outcome.figures[key_at(diagram.densities[k - 1])] - speed);
  }
  outcome.figures["least-fall"] = fall;
  outcome.figures["deviation"] = deviation;
}

StandardTest rimea_4() {
  const Diagram diagram{{.length = 26.0, .width = 2.0}, {0.5, 1.0, 2.0, 3.0}, 10.0, 70.0};
  StandardTest test = diagram_test(diagram);
  test.id = "rimea-4";
  test.title = "Fundamental diagram of RiMEA";
  test.source = "RiMEA 4.1.1, test 4; ISO 20414, test 13; Weidmann 1993";
  test.setup =
      "A corridor 26 m by 2 m whose end leads to its start, 70 s, of which the first 10 s are "
      "dropped. The 5 and 6 persons/m² of the guideline do not fit, bodies being 0.478 m "
      "wide, and Jülich's points end before 4 /m².";
  test.figures.push_back(at_least("least-fall", "least fall of speed from one density to the next",
                                  "m/s", 2, 0.0, "RiMEA: speed falls with density"));
  test.figures.push_back(told("deviation", "mean deviation from Weidmann's speeds", "m/s", 2,
                              "RiMEA: to be compared"));
  test.conclude = [diagram](Outcome& outcome) { conclude_rimea_4(diagram, outcome); };
  add_limits(test, diagram, one_way_band, "between Weidmann and Jülich, ± 15 %");
  add_reference(test, weidmann_reference());
  return test;
}

}  // namespace

std::vector<StandardTest> diagram_tests() { return {rimea_4(), one_way(), two_ways()}; }

}  // namespace pedzone::verify
