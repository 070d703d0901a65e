// What maps of a recorded run have in common: what they show, the ground, waypoints, vehicles.
#pragma once

#include <string>
#include <vector>

#include "results/place.hpp"
#include "results/recording.hpp"
#include "view/map_panel.hpp"

namespace pedzone {

/// The part of the world to show [m]: `area`, if it is not empty. Else the places of all persons,
/// with some room around; if anybody is in a zone, only places in zones count. The shorter side is
/// made longer if the picture would be too flat or too steep for a page.
Box shown_box(const Recording& recording, const Place* place, const Box& area);

/// [s] who is not there for longer has a gap in its line: three times the usual step, at least 1 s.
double line_gap(const Recording& recording);

/// A track between two gaps: indices of its moments, both included.
struct TrackPiece {
  std::size_t first, last;
};

template <class Moment>
std::vector<TrackPiece> pieces_of(const std::vector<Moment>& moments,
                                  const std::vector<double>& times, double gap) {
  std::vector<TrackPiece> pieces;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const bool joined = i > 0 && times[moments[i].step] - times[moments[i - 1].step] <= gap;
    if (!joined) pieces.push_back({i, i});
    pieces.back().last = i;
  }
  return pieces;
}

/// The same, cut where SUMO begins or ceases to walk a person: pictures show that paler. A piece
/// begins where the one before it ends.
std::vector<TrackPiece> pieces_by_walker(const RecordedPerson& person,
                                         const std::vector<double>& times, double gap);

/// How much of its colour a person has whom SUMO walks, in a run of pedzone's.
inline constexpr double kPale = 0.4;
/// Whether there is one in the box.
bool any_by_sumo(const Recording& recording, const Box& box);

/// Where somebody is at a step: its moment there, or the one before it where the track goes on;
/// null in a gap and outside.
template <class Moment>
const Moment* there_at(const std::vector<Moment>& moments, std::uint32_t step,
                       const std::vector<double>& times, double gap) {
  const Moment* at = moment_until(moments, step);
  if (at == nullptr || at->step == step) return at;
  const Moment* next = at + 1;
  const bool goes_on = at != &moments.back() && times[next->step] - times[at->step] <= gap;
  return goes_on ? at : nullptr;
}

/// Corners of a vehicle at a moment, counter-clockwise from its front left [m].
Ring outline(const RecordedVehicle& vehicle, const VehicleMoment& moment);

/// A five-pointed star with a point to the north [m].
Ring star(const Vec2& centre, double radius);

/// The ground: zones, obstacles, roads, and waypoints as stars with their radii.
void draw_ground(SvgPage& page, const Place* place, double unit);
void draw_waypoints(SvgPage& page, const Place* place, double unit);

/// Lines along which the vehicles' centres went.
void draw_vehicle_ways(SvgPage& page, const Recording& recording, double unit);

/// Entries of what draw_ground() and draw_waypoints() draw, where it is in the box.
std::vector<LegendEntry> ground_legend(const Place* place, const Box& box);
/// Of draw_vehicle_ways(), where there are vehicles.
std::vector<LegendEntry> vehicle_legend(const Recording& recording);

}  // namespace pedzone
