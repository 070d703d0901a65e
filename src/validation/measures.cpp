#include "validation/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conflict/approach.hpp"

namespace pedzone {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kArrived = 0.5;  // [m] from the goal (vehicle.md, trap 3)
constexpr int kWindow = 5;        // frames of a speed
constexpr double kBody = 0.24;    // [m] of a person, for times to collision and encroachment

/// A person's disc (a point by itself) and a vehicle at one moment.
Approach approach_of(const VehicleState& vehicle, const Vec2& place, const Vec2& velocity,
                     double radius) {
  const Vec2 axis = unit(vehicle.heading);
  return {to_frame(axis, place - vehicle.centre),
          to_frame(axis, velocity - vehicle.velocity),
          vehicle.velocity.dot(axis),
          {0.5 * vehicle.length, 0.5 * vehicle.width, radius}};
}

double deviation(const PersonTrack& track, const Polyline& way) {
  const Vec2 line = track.places.back() - track.places.front();
  if (line.norm() <= 0.0) return 0.0;
  const Vec2 side = left_of(line.normalized());
  double most = 0.0;
  for (const Vec2& place : way) {
    most = std::max(most, std::abs((place - track.places.front()).dot(side)));
  }
  return most;
}

/// Index of the frame in which the way gets to the goal, or its last.
std::size_t arrival(const PersonTrack& track, const Polyline& way) {
  const auto found = std::find_if(way.begin(), way.end(), [&](const Vec2& place) {
    return (place - track.places.back()).norm() <= kArrived;
  });
  return std::min(static_cast<std::size_t>(found - way.begin()), way.size() - 1);
}

void measure_speeds(const PersonTrack& track, const Polyline& way, Measures& measures) {
  const std::size_t end = arrival(track, way);
  double length = 0.0;
  measures.least_speed = kInfinite;
  for (std::size_t i = 1; i <= end; ++i) {
    length += (way[i] - way[i - 1]).norm();
    if (i >= kWindow) {
      const double speed = (way[i] - way[i - kWindow]).norm() / (kWindow * kFrame);
      measures.least_speed = std::min(measures.least_speed, speed);
    }
  }
  measures.mean_speed = end > 0 ? length / (static_cast<double>(end) * kFrame) : 0.0;
  measures.least_speed = std::min(measures.least_speed, measures.mean_speed);
}

/// Visits the frames of the way (indices) in which the vehicle is there, and moves.
template <class Visit>
void visit_moving(const VehicleTrack& vehicle, const PersonTrack& track, const Polyline& way,
                  Visit visit) {
  const int from = std::max(0, vehicle.first - track.first);
  const int to = std::min(static_cast<int>(way.size()), vehicle.last() + 1 - track.first);
  for (int i = from; i < to; ++i) {
    const VehicleState* state = at_frame(vehicle, track.first + i);
    if (state == nullptr || state->velocity.norm() < kMovingSpeed) continue;
    visit(static_cast<std::size_t>(i), *state);
  }
}

/// Least signed clearance [m] to a moving vehicle; infinity without one.
double least_clearance(const Clip& clip, const PersonTrack& track, const Polyline& way) {
  double least = kInfinite;
  for (const VehicleTrack& vehicle : clip.vehicles) {
    visit_moving(vehicle, track, way, [&](std::size_t i, const VehicleState& state) {
      least = std::min(least, signed_clearance(state, way[i]));
    });
  }
  return least;
}

}  // namespace

double signed_clearance(const VehicleState& vehicle, const Vec2& point) {
  return clearance(approach_of(vehicle, point, vehicle.velocity, 0.0));
}

Measures measure(const Clip& clip, const VehicleWays& ways, const PersonTrack& track,
                 const Polyline& way) {
  Measures measures;
  measures.unpushed = least_clearance(clip, track, way);
  measures.clearance = std::max(0.0, measures.unpushed);
  measures.least_ttc = kInfinite;
  for (const VehicleTrack& vehicle : clip.vehicles) {
    visit_moving(vehicle, track, way, [&](std::size_t here, const VehicleState& state) {
      const std::size_t before = here >= kPast ? here - kPast : 0;
      if (here == before) return;
      const Vec2 velocity =
          (way[here] - way[before]) / (static_cast<double>(here - before) * kFrame);
      const auto ttc = time_to_contact(approach_of(state, way[here], velocity, kBody));
      measures.least_ttc = std::min(measures.least_ttc, ttc.value_or(kInfinite));
    });
  }
  measures.passing = ways.closest(track.first, way);
  measures.deviation = deviation(track, way);
  measure_speeds(track, way, measures);
  double sum = 0.0;
  for (std::size_t i = kFollows + 1; i < way.size(); ++i) {
    sum += (way[i] - track.places[i]).norm();
  }
  const int scored = std::max(1, static_cast<int>(way.size()) - kFollows - 1);
  measures.ade = sum / scored;
  measures.fde = (way.back() - track.places.back()).norm();
  return measures;
}

Measures measure(const Clip& clip, const VehicleWays& ways, std::size_t person,
                 const Replayed& replayed) {
  const PersonTrack& track = clip.persons[person];
  Measures measures = measure(clip, ways, track, replayed.ways[person]);
  if (replayed.pushes.empty()) return measures;
  measures.push = replayed.pushes[person];
  measures.unpushed = least_clearance(clip, track, replayed.unpushed[person]);
  return measures;
}

}  // namespace pedzone
