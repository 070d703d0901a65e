#include "app/measurement_area.hpp"

#include <cmath>

#include "geometry/overlay.hpp"
#include "verify/voronoi.hpp"

namespace pedzone {
namespace {

constexpr double kEvery = 1.0;  // [s]
constexpr double kMost = 2.0;   // [m] a cell ends so far from its person, as in PedPy's examples
constexpr double kAround =
    6.0;  // [m] farther people cannot bound a cell that reaches into the area

Ring ring_of(const Box& box) {
  return {box.min(), {box.max().x(), box.min().y()}, box.max(), {box.min().x(), box.max().y()}};
}

/// Where people can be near the area.
Region walkable_near(const Place* place, const Box& area) {
  const Region near{{ring_of(grown(area, kAround)), {}}};
  if (place == nullptr) return near;
  std::vector<Region> zones;
  for (const Zone& zone : place->zones) zones.push_back(intersect(zone.walkable, near));
  return unite(zones);
}

/// Those near the area, by step.
std::vector<std::vector<const PersonMoment*>> moments_by_step(const Recording& recording,
                                                              const Box& area) {
  const Box near = grown(area, kAround);
  std::vector<std::vector<const PersonMoment*>> steps(recording.times.size());
  for (const RecordedPerson& person : recording.persons) {
    for (const PersonMoment& moment : person.moments) {
      if (near.contains(moment.position)) steps[moment.step].push_back(&moment);
    }
  }
  return steps;
}

}  // namespace

std::vector<AreaMoment> measure_area(const Recording& recording, const Place* place,
                                     const Box& area) {
  const Region walkable = walkable_near(place, area);
  const Ring ring = ring_of(area);
  const auto steps = moments_by_step(recording, area);
  std::vector<AreaMoment> series;
  double next = -INFINITY;
  for (std::size_t step = 0; step < steps.size(); ++step) {
    if (recording.times[step] < next - 1e-9 || steps[step].empty()) continue;
    next = recording.times[step] + kEvery;
    std::vector<Vec2> points;
    std::vector<double> speeds;
    for (const PersonMoment* moment : steps[step]) {
      points.push_back(moment->position);
      speeds.push_back(moment->speed);
    }
    const verify::VoronoiCells cells(walkable, points, kMost);
    const auto speed = cells.mean(speeds, ring);
    if (speed) series.push_back({recording.times[step], cells.density(ring), *speed});
  }
  return series;
}

}  // namespace pedzone
