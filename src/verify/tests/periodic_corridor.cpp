#include "verify/tests/periodic_corridor.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace pedzone::verify {

Region PeriodicCorridor::ground() const {
  return repair(box(-Period::kBeyond, 0.0, length + Period::kBeyond, width));
}

Drawing PeriodicCorridor::drawing() const {
  Drawing drawing;
  drawing.walkable = repair(box(0.0, 0.0, length, width));
  drawing.starts.push_back({box(0.0, 0.0, length, width), 0});
  drawing.measured.push_back(box(0.0, 0.0, length, width));
  const double off = both_ways ? 0.2 * width : 0.0, third = length / 3.0;
  drawing.arrows.push_back({{third, width / 2 + off}, {2.0 * third, width / 2 + off}, 0});
  if (both_ways) {
    drawing.arrows.push_back({{2.0 * third, width / 2 - off}, {third, width / 2 - off}, 1});
  }
  return drawing;
}

CorridorTrial::CorridorTrial(const PeriodicCorridor& corridor, const RunInput& input)
    : Trial(corridor.ground(), input) {
  const Period period{0.0, corridor.length};
  set_period(period);
  const std::vector<Vec2> places =
      places_in({0.0, 0.0}, {corridor.length, corridor.width}, corridor.people, input.seed);
  // The places are in random order, so taking turns mixes the ways.
  for (std::size_t k = 0; k < places.size(); ++k) {
    const int stream = corridor.both_ways && k % 2 != 0 ? 1 : 0;
    const double end = stream == 0 ? period.high + Period::kBeyond : period.low - Period::kBeyond;
    add(places[k], line_at_x(end, 0.0, corridor.width), stream, {}, 1.0);
  }
}

Point state_of(const PeriodicCorridor& corridor, const RunInput& input, double from, double until) {
  CorridorTrial trial(corridor, input);
  AreaMeasure measure(box(0.0, 0.0, corridor.length, corridor.width), from);
  trial.walk(until, [&] { measure.look(trial, corridor_way); });
  return {measure.density(), measure.speed()};
}

std::size_t people_at(double density, double length, double width) {
  return static_cast<std::size_t>(std::max(1L, std::lround(density * length * width)));
}

}  // namespace pedzone::verify
