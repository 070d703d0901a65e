// Lanes in two-way corridors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/tests/periodic_corridor.hpp"

namespace pedzone::verify {
namespace {

struct Lanes {
  double order = 0.0;    ///< band index, mean over moments
  double by_chance = 0;  ///< of the people as they stood at first
  double lanes = 0.0;
  double speed = 0.0;  ///< [m/s] along one's way
};

/// Looked at each second from `from` to `until` [s].
Lanes lanes_of(const PeriodicCorridor& corridor, const RunInput& input, double from, double until) {
  CorridorTrial trial(corridor, input);
  const auto places = [&] {
    std::vector<LanePlace> found;
    for (const Participant& participant : trial.people()) {
      found.push_back({participant.at.y(), participant.stream == 0 ? 1 : -1});
    }
    return found;
  };
  Lanes lanes;
  lanes.by_chance = band_index(places(), 0.0, corridor.width);
  std::vector<LanePlace> gathered;
  int moments = 0;
  AreaMeasure measure(box(0.0, 0.0, corridor.length, corridor.width), from);
  trial.walk(until, [&] {
    measure.look(trial, corridor_way);
    if (trial.time() < from || !trial.at_every(1.0)) return;
    const std::vector<LanePlace> now = places();
    lanes.order += band_index(now, 0.0, corridor.width);
    gathered.insert(gathered.end(), now.begin(), now.end());
    ++moments;
  });
  lanes.order /= std::max(1, moments);
  lanes.lanes = lane_count(gathered, 0.0, corridor.width);
  lanes.speed = measure.speed();
  return lanes;
}

StandardTest moussaid() {
  static const PeriodicCorridor corridor{16.0, 4.0, 60, true};
  StandardTest test;
  test.id = "moussaid-lanes";
  test.title = "Lanes form within 30 s";
  test.source = "Moussaïd, Helbing and Theraulaz 2011; band index after Yamori 1998";
  test.setup =
      "60 people, 30 each way and mixed at first, in a corridor of 16 m by 4 m whose end leads to "
      "its start. Band index, in bands of 0.5 m, from 25 s to 30 s; 1: in every band all walk one "
      "way.";
  test.figures = {at_least("order", "band index", "", 2, 0.8, "near 1; assumed: 0.8"),
                  told("by-chance", "band index at first", "", 2),
                  told("speed", "speed along one's way", "m/s", 2)};
  test.run = [](const RunInput& input, std::size_t) {
    const Lanes lanes = lanes_of(corridor, input, 25.0, 30.0);
    Outcome outcome;
    outcome.figures = {
        {"order", lanes.order}, {"by-chance", lanes.by_chance}, {"speed", lanes.speed}};
    return outcome;
  };
  test.drawing = corridor.drawing();
  return test;
}

constexpr double kWidths[] = {2.0, 4.0, 6.0, 8.0};  // [m]

Outcome run_width(const RunInput& input, std::size_t index) {
  const double width = kWidths[index];
  const PeriodicCorridor corridor{26.0, width, people_at(1.0, 26.0, width), true};
  const Lanes lanes = lanes_of(corridor, input, 40.0, 60.0);
  Outcome outcome;
  outcome.figures[fmt::format("lanes-{:g}", width)] = lanes.lanes;
  outcome.figures[fmt::format("order-{:g}", width)] = lanes.order;
  outcome.curves["lanes"] = {{width, lanes.lanes}};
  outcome.curves["order"] = {{width, lanes.order}};
  return outcome;
}

void conclude_widths(Outcome& outcome) {
  auto& figures = outcome.figures;
  figures["more"] = figures["lanes-8"] - figures["lanes-2"];
  double least = 1.0;
  for (const double width : kWidths) {
    least = std::min(least, figures[fmt::format("order-{:g}", width)]);
  }
  figures["order"] = least;
}

StandardTest lanes_by_width() {
  StandardTest test;
  test.id = "lanes-by-width";
  test.title = "More lanes in wider corridors";
  test.source = "Helbing, Molnár, Farkas and Bolay 2001: the number grows with the width";
  test.setup =
      "Two ways at 1 person/m² in corridors 26 m long and 2 to 8 m wide, from 40 s to 60 s. A lane "
      "is a run of bands of 0.5 m in which two of three walk one way.";
  test.figures = {at_least("more", "lanes at 8 m less lanes at 2 m", "", 0, 1.0,
                           "the number grows with the width"),
                  at_least("order", "least band index", "", 2, 0.6,
                           "assumed: as lanes of Helbing and Molnár's model")};
  for (const double width : kWidths) {
    test.figures.push_back(
        told(fmt::format("lanes-{:g}", width), fmt::format("lanes at {:g} m", width), "", 0));
  }
  test.charts = {{"lanes", "Number of lanes", "width, m", "lanes", {}, {}, {}},
                 {"order", "Order of lanes", "width, m", "band index", {}, {}, {}}};
  test.cases = std::size(kWidths);
  test.run = run_width;
  test.conclude = conclude_widths;
  test.drawing = PeriodicCorridor{26.0, 4.0, 1, true}.drawing();
  return test;
}

}  // namespace

std::vector<StandardTest> lane_tests() { return {moussaid(), lanes_by_width()}; }

}  // namespace pedzone::verify
