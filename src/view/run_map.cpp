#include "view/run_map.hpp"

#include <algorithm>
#include <cmath>

#include "pages/palette.hpp"
#include "view/zone_map.hpp"
#include "zone/simplify.hpp"

namespace pedzone {
namespace {

constexpr double kOutside = 2.0;       // [m] so far outside a zone's box people are shown
constexpr double kMargin = 2.0;        // [m] round them, at least ...
constexpr double kMarginShare = 0.05;  // ... of the longer side
constexpr double kLeastSide = 12.0;    // [m]
constexpr double kFlattest = 0.3;      // height over width of the map: a panel lies below it
constexpr double kSteepest = 1.5;
constexpr double kUsualGap = 3.0;   // steps
constexpr double kLeastGap = 1.0;   // [s]
constexpr double kBorder = 0.2;     // [units] width of borders at most
constexpr double kThinning = 0.02;  // [units] corners of lines are left out so far

constexpr std::string_view kStarColour = colours::kWaypoint.light;  // not on the time scale
constexpr std::string_view kVehicleColour = colours::kGrey.light;

/// [m] Width of borders that suits a map of this unit [m].
double border_width(double unit) { return std::min(kMapLine, kBorder * unit); }

Box box_of_persons(const Recording& recording, const std::vector<Box>& within) {
  Box box;
  for (const RecordedPerson& person : recording.persons) {
    for (const PersonMoment& moment : person.moments) {
      const bool inside = within.empty() || std::ranges::any_of(within, [&](const Box& zone) {
                            return zone.contains(moment.position);
                          });
      if (inside) box.extend(moment.position);
    }
  }
  return box;
}

/// Grows the box's shorter side until their ratio is one that a page can have.
Box with_sides(const Box& box) {
  Vec2 size = box.sizes().cwiseMax(kLeastSide);
  size.y() = std::max(size.y(), kFlattest * size.x());
  size.x() = std::max(size.x(), size.y() / kSteepest);
  return {box.center() - 0.5 * size, box.center() + 0.5 * size};
}

bool any_in(const Place& place, const Box& box) {
  return std::ranges::any_of(place.network.waypoints,
                             [&](const MapPoint& point) { return box.contains(point.at); });
}

/// [m] of a waypoint: its own, or that of the zone it lies in.
double radius_of(const MapPoint& point, const Place& place) {
  if (point.radius) return *point.radius;
  for (const Zone& zone : place.zones) {
    if (contains(zone.walkable, point.at)) return zone.parameters.waypoint_radius;
  }
  return 0.0;
}

}  // namespace

Box shown_box(const Recording& recording, const Place* place, const Box& area) {
  if (!area.isEmpty()) return with_sides(area);
  std::vector<Box> zones;
  if (place != nullptr) {
    for (const Zone& zone : place->zones) zones.push_back(grown(box_of(zone.walkable), kOutside));
  }
  Box box = box_of_persons(recording, zones);
  if (box.isEmpty()) box = box_of_persons(recording, {});
  return with_sides(grown(box, std::max(kMargin, kMarginShare * box.sizes().maxCoeff())));
}

double line_gap(const Recording& recording) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < recording.times.size(); ++i) {
    steps.push_back(recording.times[i] - recording.times[i - 1]);
  }
  if (steps.empty()) return kLeastGap;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return std::max(kLeastGap, kUsualGap * *middle);
}

std::vector<TrackPiece> pieces_by_walker(const RecordedPerson& person,
                                         const std::vector<double>& times, double gap) {
  std::vector<TrackPiece> pieces;
  for (const TrackPiece& piece : pieces_of(person.moments, times, gap)) {
    pieces.push_back({piece.first, piece.first});
    for (std::size_t i = piece.first + 1; i <= piece.last; ++i) {
      pieces.back().last = i;
      const bool changes = person.moments[i].by_sumo != person.moments[i - 1].by_sumo;
      if (changes && i < piece.last) pieces.push_back({i, i});
    }
  }
  return pieces;
}

bool any_by_sumo(const Recording& recording, const Box& box) {
  return std::ranges::any_of(recording.persons, [&](const RecordedPerson& person) {
    return std::ranges::any_of(person.moments, [&](const PersonMoment& moment) {
      return moment.by_sumo && box.contains(moment.position);
    });
  });
}

Ring outline(const RecordedVehicle& vehicle, const VehicleMoment& moment) {
  const Vec2 axis = unit(moment.heading);
  const Vec2 front = 0.5 * vehicle.length * axis, left = 0.5 * vehicle.width * left_of(axis);
  const Vec2& c = moment.centre;
  return {c + front + left, c - front + left, c - front - left, c + front - left};
}

Ring star(const Vec2& centre, double radius) {
  constexpr double kInner = 0.382;  // of the radius: the pentagram's own
  Ring ring;
  for (int i = 0; i < 10; ++i) {
    const double angle = 0.5 * kPi + i * kPi / 5.0;
    ring.push_back(centre + (i % 2 == 0 ? radius : kInner * radius) * unit(angle));
  }
  return ring;
}

void draw_ground(SvgPage& page, const Place* place, double unit) {
  if (place == nullptr) return;
  draw_zone_map(page, place->network, place->zones, border_width(unit));
}

void draw_waypoints(SvgPage& page, const Place* place, double unit) {
  if (place == nullptr) return;
  page.begin_group("id=\"waypoints\"");
  for (const MapPoint& point : place->network.waypoints) {
    const double radius = radius_of(point, *place);
    if (!page.box().intersects(grown(Box(point.at, point.at), radius))) continue;
    page.circle(point.at, radius,
                "fill=\"none\" stroke-dasharray=\"0.3 0.3\" " + stroke(kStarColour, 0.1 * unit));
    page.region(
        {{star(point.at, unit), {}}},
        "class=\"star\" " + filled(kStarColour) + " " + stroke(colours::kPaper, 0.12 * unit),
        "waypoint " + point.id);
  }
  page.end_group();
}

void draw_vehicle_ways(SvgPage& page, const Recording& recording, double unit) {
  const double gap = line_gap(recording);
  page.begin_group("id=\"vehicle-ways\" stroke-linejoin=\"round\" " +
                   stroke(kVehicleColour, 0.12 * unit));
  for (const RecordedVehicle& vehicle : recording.vehicles) {
    if (vehicle.part > 0) continue;  // comes the same way
    for (const TrackPiece& piece : pieces_of(vehicle.moments, recording.times, gap)) {
      Polyline line;
      for (std::size_t i = piece.first; i <= piece.last; ++i) {
        line.push_back(vehicle.moments[i].centre);
      }
      if (!page.box().intersects(box_of(line))) continue;
      page.line(simplified(line, kThinning * unit), "", "vehicle " + vehicle.id);
    }
  }
  page.end_group();
}

std::vector<LegendEntry> ground_legend(const Place* place, const Box& box) {
  if (place == nullptr) return {};
  std::vector<LegendEntry> entries;
  const double line = border_width(box.sizes().maxCoeff() / 100.0);
  for (std::size_t i = 0; i < place->zones.size(); ++i) {
    if (!box.intersects(box_of(place->zones[i].walkable))) continue;
    entries.push_back(area_entry("zone " + place->zones[i].id, walkable_style(i, line)));
  }
  const bool obstacle = std::ranges::any_of(place->zones, [&](const Zone& zone) {
    return !zone.obstacles.empty() && box.intersects(box_of(zone.obstacles));
  });
  if (obstacle) entries.push_back(area_entry("obstacle", obstacle_style(line)));
  if (any_in(*place, box)) {
    entries.push_back(
        {"waypoint with its radius", [](SvgPage& page, const Box& at) {
           page.region({{star(at.center(), 0.8 * at.sizes().y()), {}}}, filled(kStarColour));
         }});
  }
  return entries;
}

std::vector<LegendEntry> vehicle_legend(const Recording& recording) {
  if (recording.vehicles.empty()) return {};
  return {line_entry("way of a vehicle's centre", stroke(kVehicleColour, 0.1))};
}

}  // namespace pedzone
