#include "view/path_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "view/colours.hpp"
#include "view/run_map.hpp"
#include "view/zone_map.hpp"
#include "zone/simplify.hpp"

namespace pedzone {
namespace {

constexpr double kThinning = 0.02;  // [units] corners of lines are left out so far

/// Persons whose lines look the same.
struct LineSet {
  std::string name;
  std::vector<const RecordedPerson*> persons;
};

std::vector<LineSet> by_person(const Recording& recording) {
  std::vector<LineSet> sets;
  for (const RecordedPerson& person : recording.persons) sets.push_back({person.id, {&person}});
  return sets;
}

/// Those without a group come last.
std::vector<LineSet> by_group(const Recording& recording) {
  std::map<std::string, LineSet> groups;
  LineSet alone{"no group", {}};
  for (const RecordedPerson& person : recording.persons) {
    LineSet& set = person.group.empty() ? alone : groups[person.group];
    set.persons.push_back(&person);
  }
  std::vector<LineSet> sets;
  for (auto& [id, set] : groups) {
    set.name = fmt::format("group {} ({})", id, set.persons.size());
    sets.push_back(std::move(set));
  }
  if (!alone.persons.empty()) sets.push_back(std::move(alone));
  return sets;
}

PathColour chosen(const Recording& recording, PathColour wanted) {
  if (wanted != PathColour::kAuto) return wanted;
  if (recording.persons.size() <= kLineLooks) return PathColour::kPerson;
  const std::size_t groups = by_group(recording).size();
  return groups > 1 && groups <= kLineLooks ? PathColour::kGroup : PathColour::kNone;
}

std::vector<LineSet> line_sets(const Recording& recording, PathColour wanted) {
  switch (chosen(recording, wanted)) {
    case PathColour::kPerson:
      return by_person(recording);
    case PathColour::kGroup:
      return by_group(recording);
    default:
      LineSet all{fmt::format("ways of {} persons", recording.persons.size()), {}};
      for (const RecordedPerson& person : recording.persons) all.persons.push_back(&person);
      return {all};
  }
}

std::string look_of(std::size_t set, double width, double opacity) {
  const LineLook look = line_look(set);
  std::string attributes = stroke(look.colour, width);
  if (!look.dashes.empty()) {
    attributes += fmt::format(" stroke-dasharray=\"{:.2f} {:.2f}\"", 4.0 * width, 2.0 * width);
  }
  return attributes + fmt::format(" stroke-opacity=\"{:.2f}\"", opacity);
}

std::vector<LegendEntry> legend(const Recording& recording, const Place* place, const Box& box,
                                const std::vector<LineSet>& sets) {
  std::vector<LegendEntry> entries = ground_legend(place, box);
  const double width = 0.004 * box.sizes().x();  // as in the legend, so that dashes fit
  for (std::size_t i = 0; i < sets.size() && sets.size() <= kLineLooks; ++i) {
    entries.push_back(line_entry(sets[i].name, look_of(i, width, 1.0)));
  }
  if (any_by_sumo(recording, box)) {
    entries.push_back(line_entry("paler: walked by SUMO", look_of(0, width, kPale)));
  }
  for (LegendEntry& entry : vehicle_legend(recording)) entries.push_back(std::move(entry));
  return entries;
}

void draw_person(SvgPage& page, const Recording& recording, const RecordedPerson& person,
                 double gap, double unit) {
  for (const TrackPiece& piece : pieces_by_walker(person, recording.times, gap)) {
    Polyline line;
    for (std::size_t i = piece.first; i <= piece.last; ++i) {
      line.push_back(person.moments[i].position);
    }
    if (!page.box().intersects(box_of(line))) continue;
    page.line(simplified(line, kThinning * unit),
              person.moments[piece.first].by_sumo ? fmt::format("opacity=\"{}\"", kPale) : "",
              person.id);
  }
}

}  // namespace

std::string path_plot(const Recording& recording, const Place* place,
                      const PathPlotOptions& options) {
  const Box box = shown_box(recording, place, options.area);
  const std::vector<LineSet> sets = line_sets(recording, options.colour);
  const MapPanel panel(box.sizes(), legend(recording, place, box, sets), options.narrow);
  SvgPage page(box, panel.height());
  draw_ground(page, place, panel.unit());
  draw_vehicle_ways(page, recording, panel.unit());
  draw_waypoints(page, place, panel.unit());
  const bool few = recording.persons.size() <= kLineLooks;
  // A narrow picture has larger letters; lines as wide as these would run into each other.
  const double fine = options.narrow ? 0.5 : 1.0;
  const double width = (few ? 0.25 : 0.14) * fine * panel.unit(), gap = line_gap(recording);
  page.begin_group("id=\"persons\" stroke-linejoin=\"round\" stroke-linecap=\"round\"");
  for (std::size_t i = 0; i < sets.size(); ++i) {
    page.begin_group(look_of(i, width, few ? 1.0 : 0.45));
    for (const RecordedPerson* person : sets[i].persons) {
      draw_person(page, recording, *person, gap, panel.unit());
    }
    page.end_group();
  }
  page.end_group();
  panel.draw(page);
  return page.finish(options.title);
}

}  // namespace pedzone
