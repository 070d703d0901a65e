#include "crowd/free_walk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "crowd/behaviour/crossings.hpp"
#include "crowd/behaviour/kerbs.hpp"
#include "crowd/state/parallel.hpp"
#include "model/senses.hpp"
#include "model/vehicle_view.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kGap = 1.0;  // [m] assumed: left between bodies that hurry towards each other
constexpr double kFasterThanPeople = 3.0;  // [m/s] assumed
constexpr double kAhead = 1.0;  // [m] assumed: what somebody heads for is farther than the step

/// A vehicle that people may mind within the step.
struct Traffic {
  const VehicleState* vehicle;
  float noticed;   ///< [m] within which it is seen, or its horn is heard
  float loudness;  ///< as of VehicleShape; 0: its horn is all that is heard
  double around;   ///< [m] more: its body, its claim, its way within the step

  /// Whether somebody of that hearing [m] may mind it, from there or a step's `way` [m] on.
  bool may_matter(const Vec2& from, float hearing, double way) const {
    const double reach = static_cast<double>(std::max(noticed, hearing * loudness)) + around + way;
    const bool near = (vehicle->centre - from).squaredNorm() < reach * reach;
    return near && vehicle->concerns(from) && !leaves_behind(from, way);
  }

  /// Whether it has driven past somebody there, faster than people walk.
  bool leaves_behind(const Vec2& from, double way) const {
    const Vec2 ahead = unit(vehicle->heading);
    const double gap = (vehicle->centre - from).dot(ahead) - 0.5 * vehicle->length;
    return vehicle->velocity.dot(ahead) > kFasterThanPeople && gap > kGap + way;
  }
};

std::vector<Traffic> traffic_of(const CrowdState& crowd, double dt) {
  const Senses senses = senses_of(crowd.zone.parameters, crowd.model->vehicle_form());
  std::vector<Traffic> traffic;
  for (const VehicleState& vehicle : crowd.vehicles) {
    if (vehicle.apart()) continue;
    const double speed = vehicle.velocity.norm();
    const double body = 0.5 * std::hypot(vehicle.length, vehicle.width);
    traffic.push_back(
        {&vehicle, std::max(senses.vehicle_sight, vehicle.horn ? kHornReach : 0.0F),
         vehicle.horn ? 0.0F : loudness_of(static_cast<float>(speed), vehicle.electric),
         body + vehicle.claim + speed * dt});
  }
  return traffic;
}

/// [m] Who hears less than most is taken to hear as they do: it walks in substeps more often.
float hearing_of(const CrowdState& crowd, std::size_t i) {
  const Profile* const profile = crowd.walkers[i].profile;
  const double usual = crowd.zone.parameters.hearing;
  return static_cast<float>(profile != nullptr ? std::max(usual, profile->hearing) : usual);
}

/// Whether it walks along its route as it likes, and has nothing else to do.
bool walks_undisturbed(const CrowdState& crowd, std::size_t i) {
  const WalkState& walker = crowd.walkers[i];
  const PersonHandle handle = walker.handle;
  const ActivityMemory& activity = crowd.activities[handle];
  const bool hindered = walker.new_here || walker.arrived || walker.waits || walker.pressed ||
                        walker.standing > 0.0 || crowd.jams[handle].squeezes() ||
                        crowd.persons.present_radius[i] != crowd.persons.radius[i];
  const bool busy = activity.activity != Activity::kNone || activity.dash > 0.0 ||
                    std::ranges::any_of(activity.rates, [](float rate) { return rate > 0.0F; });
  return !hindered && !busy && crowd.groups[handle].group == 0 && walker.route.found &&
         !walker.entered && !is_at_street(crowd, i);
}

/// [m] that it walks within `time` [s], at most.
double longest_way(const CrowdState& crowd, std::size_t i, double time) {
  return std::max(crowd.persons.preferred_speed[i], crowd.velocity(i).norm()) * time;
}

/// Whether it comes to no corner, waypoint or destination on that way [m].
bool room_ahead(const CrowdState& crowd, std::size_t i, double way) {
  const auto is_beyond = [&](const Vec2& place, double near) {
    return (place - crowd.position(i)).norm() > way + near + crowd.persons.radius[i];
  };
  const PathMemory& path = crowd.paths[crowd.handle(i)];
  if (path != nullptr && !is_beyond(path->current().at, path->current().radius)) return false;
  const Vec2 aim = heading_point(crowd.walkers[i].route, crowd.position(i));
  return is_beyond(aim, std::max(crowd.zone.parameters.waypoint_radius, kAhead));
}

/// Whether it could meet nobody within `time` [s].
bool nobody_within_reach(const CrowdState& crowd, std::size_t i, double most, double widest,
                         double time) {
  const Persons& persons = crowd.persons;
  const Vec2 here = crowd.position(i);
  const double own = longest_way(crowd, i, time) + persons.radius[i] + kGap;
  const Vec2 box = Vec2::Constant(own + most + widest);
  bool alone = true;
  crowd.grid.visit_box(here - box, here + box, [&](std::uint32_t j, const Vec2& there) {
    const double reach = own + longest_way(crowd, j, time) + persons.radius[j];
    alone = alone && (j == i || (there - here).squaredNorm() > reach * reach);
  });
  return alone;
}

/// Exchanges two persons' rows.
void swap_rows(CrowdState& crowd, std::size_t a, std::size_t b) {
  if (a == b) return;
  for (std::vector<double>* column : crowd.persons.numbers()) {
    std::swap((*column)[a], (*column)[b]);
  }
  std::swap(crowd.persons.key[a], crowd.persons.key[b]);
  std::swap(crowd.walkers[a], crowd.walkers[b]);
  crowd.row[crowd.walkers[a].handle] = static_cast<std::uint32_t>(a);
  crowd.row[crowd.walkers[b].handle] = static_cast<std::uint32_t>(b);
}

/// Of each walked person, 1: walks freely. Rows of those who are only seen have been appended.
std::vector<std::uint8_t> find_free(CrowdState& crowd, double dt) {
  const Persons& persons = crowd.persons;
  std::vector<std::uint8_t> free(persons.walking, 0);
  // People turn their shoulders before others whom they meet so soon.
  const double time = std::max(dt, crowd.zone.parameters.turn_time);
  double most = 0.0;
  for (std::size_t i = 0; i < persons.size(); ++i) {
    most = std::max(most, longest_way(crowd, i, time));
  }
  const double widest = std::ranges::max(persons.radius);
  crowd.grid.build(persons.x, persons.y, 2.0 * (most + widest) + kGap);
  const std::vector<Traffic> traffic = traffic_of(crowd, dt);
  for_each_block(persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const double way = longest_way(crowd, i, dt);
      const float hearing = hearing_of(crowd, i);
      const auto minds = [&](const Traffic& vehicle) {
        return vehicle.may_matter(crowd.position(i), hearing, way);
      };
      free[i] = walks_undisturbed(crowd, i) && room_ahead(crowd, i, way) &&
                        !comes_to_kerb(crowd, i, way) &&
                        nobody_within_reach(crowd, i, most, widest, time) &&
                        std::ranges::none_of(traffic, minds)
                    ? 1
                    : 0;
    }
  });
  return free;
}

}  // namespace

std::size_t gather_free(CrowdState& crowd, double dt) {
  if (crowd.persons.walking == 0) return 0;
  std::vector<std::uint8_t> free = find_free(crowd, dt);
  std::size_t first = 0, last = free.size();
  while (true) {
    while (first < last && free[first] != 0) ++first;
    while (first < last && free[last - 1] == 0) --last;
    if (first == last) return first;
    swap_rows(crowd, first++, --last);
  }
}

void set_apart(CrowdState& crowd, std::size_t free, double dt, std::vector<FreeWalkEnd>& ends) {
  Persons& persons = crowd.persons;
  Moves& moves = crowd.moves;
  const std::size_t all = crowd.first_seen(), rest = all - free;
  // moves.x holds the places before the step.
  persons.x.swap(moves.x);
  persons.y.swap(moves.y);
  ends.clear();
  for (std::size_t i = 0; i < free; ++i) {
    const Vec2 end(moves.x[i], moves.y[i]);
    ends.push_back({crowd.handle(i), end, crowd.velocity(i)});
    const Vec2 velocity = (end - crowd.position(i)) / dt;
    persons.vx[i] = velocity.x();
    persons.vy[i] = velocity.y();
  }
  for (std::size_t k = 0, n = std::min(free, rest); k < n; ++k) swap_rows(crowd, k, all - n + k);
  persons.walking = rest;
  crowd.others = free;
}

void take_back(CrowdState& crowd, const std::vector<FreeWalkEnd>& ends) {
  Persons& persons = crowd.persons;
  for (const FreeWalkEnd& end : ends) {
    const std::size_t i = crowd.row[end.handle];
    persons.x[i] = end.position.x();
    persons.y[i] = end.position.y();
    persons.vx[i] = end.velocity.x();
    persons.vy[i] = end.velocity.y();
  }
  persons.walking += crowd.others;
  crowd.others = 0;
}

}  // namespace pedzone
