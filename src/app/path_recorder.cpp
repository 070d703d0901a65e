#include "app/path_recorder.hpp"

#include <algorithm>
#include <tuple>

#include "pages/palette.hpp"

namespace pedzone {
namespace {

constexpr double kThinning = 0.5;  // [m] between two points of a line: finer is not seen
constexpr double kBreak = 5.0;     // [s] out of control for so long, a new line begins

}  // namespace

void PathRecorder::observe(const Simulation& simulation) {
  const double now = simulation.time();
  for (const Guest& guest : simulation.guests()) {
    Track& track = tracks_[guest.id];
    if (!track.line.empty() && now - track.last_seen > kBreak) {
      finished_.push_back(std::move(track.line));
      track.line.clear();
    }
    track.last_seen = now;
    const Vec2 here = simulation.view(guest).position;
    if (track.line.empty() || (here - track.line.back()).norm() >= kThinning) {
      track.line.push_back(here);
    }
  }
}

std::string PathRecorder::picture(const Simulation& simulation) const {
  PathLayer people;
  people.name = "paths of people in the zone";
  people.colour = colours::kBlue.light;
  people.lines = finished_;
  for (const auto& [id, track] : tracks_) people.lines.push_back(track.line);
  // The map has no order of its own; a run's picture is the same every time.
  std::sort(people.lines.begin(), people.lines.end(), [](const Polyline& a, const Polyline& b) {
    return std::lexicographical_compare(
        a.begin(), a.end(), b.begin(), b.end(), [](const Vec2& p, const Vec2& q) {
          return std::tuple(p.x(), p.y()) < std::tuple(q.x(), q.y());
        });
  });
  return zone_svg(simulation.network(), simulation.zones(), {people});
}

}  // namespace pedzone
