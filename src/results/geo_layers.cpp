#include "results/geo_layers.hpp"

#include <algorithm>

#include "results/conflict_table.hpp"
#include "results/density_grid.hpp"

namespace pedzone {
namespace {

constexpr double kThinning = 0.5;  // [m] numerical: between two points of a way
constexpr double kGap = 5.0;       // [s] of absence, after which another way begins

double metres(double length) { return std::round(length * 100.0) / 100.0; }

/// [s] between two steps: the least, since steps in which nobody was there are not recorded.
double step_of(const std::vector<double>& times) {
  double step = 0.0;
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double next = times[k] - times[k - 1];
    if (step == 0.0 || next < step) step = next;
  }
  return step;
}

/// Part of a person's moments as a line.
void write_path(const RecordedPerson& person, std::span<const PersonMoment> moments,
                const std::vector<double>& times, GeoJsonFile& file) {
  Polyline line;
  double length = 0.0;
  for (const PersonMoment& moment : moments) {
    const bool last = &moment == &moments.back();
    if (!line.empty() && !last && (moment.position - line.back()).norm() < kThinning) continue;
    if (!line.empty()) length += (moment.position - line.back()).norm();
    line.push_back(moment.position);
  }
  if (line.size() < 2) return;
  Json properties = {{"person", person.id},
                     {"begin", times[moments.front().step]},
                     {"end", times[moments.back().step]},
                     {"length", metres(length)}};
  if (!person.profile.empty()) properties["profile"] = person.profile;
  if (!person.group.empty()) properties["group"] = person.group;
  file.line(line, properties);
}

/// Where and when a conflict was gravest: contact, else least TTC, else PET, else clearance.
const Extreme* gravest(const Conflict& conflict) {
  for (const auto* measure :
       {&conflict.contact, &conflict.ttc, &conflict.pet, &conflict.drac, &conflict.clearance}) {
    if (*measure) return &**measure;
  }
  return nullptr;
}

}  // namespace

void write_zones(const Place& place, GeoJsonFile& file) {
  for (const Zone& zone : place.zones) {
    file.region(zone.walkable, {{"zone", zone.id},
                                {"model", zone.model},
                                {"edges", zone.edges.size()},
                                {"area", metres(area(zone.walkable))}});
  }
}

void write_walls(const Place& place, GeoJsonFile& file) {
  for (const Zone& zone : place.zones) {
    const auto write = [&](Ring ring, const char* kind) {
      ring.push_back(ring.front());
      file.line(ring, {{"zone", zone.id}, {"kind", kind}});
    };
    for (const Polygon& polygon : zone.walkable) {
      write(polygon.outer, "border");
      for (const Ring& hole : polygon.holes) write(hole, "obstacle");
    }
  }
}

void write_waypoints(const Place& place, GeoJsonFile& file) {
  for (const WaypointPath& path : place.paths) {
    for (std::size_t zone = 0; zone < path.stops.size(); ++zone) {
      int order = 0;
      for (const PathStop& stop : path.stops[zone]) {
        file.point(stop.waypoint.at, {{"path", path.id},
                                      {"zone", place.zones[zone].id},
                                      {"order", ++order},
                                      {"poi", stop.poi},
                                      {"radius", stop.waypoint.radius}});
      }
    }
  }
}

void write_paths(const Recording& recording, GeoJsonFile& file) {
  const std::vector<double>& times = recording.times;
  for (const RecordedPerson& person : recording.persons) {
    auto begin = person.moments.begin();
    while (begin != person.moments.end()) {
      const auto gap = std::adjacent_find(begin, person.moments.end(),
                                          [&](const PersonMoment& a, const PersonMoment& b) {
                                            return times[b.step] - times[a.step] > kGap;
                                          });
      const auto end = gap == person.moments.end() ? gap : gap + 1;
      write_path(person, {begin, end}, times, file);
      begin = end;
    }
  }
}

void write_density(const Recording& recording, GeoJsonFile& file) {
  const double step = step_of(recording.times);
  if (step <= 0.0) return;
  DensityGrid grid;
  for (const RecordedPerson& person : recording.persons) {
    for (const PersonMoment& moment : person.moments) grid.add(moment.position, step);
  }
  const double duration = recording.end - recording.begin;
  constexpr double kSide = kDensityCell;
  for (const DensityRow& cell : grid.rows()) {
    const Vec2 corner(cell.x, cell.y);
    const Ring square{corner, corner + Vec2(kSide, 0), corner + Vec2(kSide, kSide),
                      corner + Vec2(0, kSide)};
    file.region({{square, {}}}, {{"personSeconds", cell.person_seconds},
                                 {"density", cell.person_seconds / (kSide * kSide * duration)}});
  }
}

void write_conflicts(const std::vector<Conflict>& conflicts, GeoJsonFile& file) {
  for (const Conflict& conflict : conflicts) {
    const Extreme* at = gravest(conflict);
    if (at == nullptr) continue;
    Json properties = {{"person", conflict.person}, {"vehicle", conflict.vehicle},
                       {"time", at->time},          {"begin", conflict.begin},
                       {"end", conflict.end},       {"type", name_of(conflict.type)}};
    for (const ConflictMeasure& measure : kConflictMeasures) {
      const auto& extreme = conflict.*measure.extreme;
      properties[measure.name] = extreme ? Json(extreme->value) : Json(nullptr);
    }
    file.point(at->position, properties);
  }
}

}  // namespace pedzone
