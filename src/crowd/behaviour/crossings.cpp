#include "crowd/behaviour/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>
#include <utility>

#include "crowd/behaviour/crossing_plan.hpp"
#include "crowd/behaviour/groups.hpp"
#include "crowd/behaviour/path_walk.hpp"
#include "crowd/sense/lookout.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kKerbReach = 3.0;   // [m] assumed: who walks farther from the kerb does not look
constexpr double kAway = 1.5;        // [m] assumed: who was pushed so far goes back to the kerb
constexpr double kSaves = 10.0;      // [m] assumed: for less nobody leaves its way to a junction
constexpr double kFastest = 1.5;     // assumed: of its speed, for a few steps
constexpr double kBraking = 4.0;     // [s] assumed: in which a walker comes to stand. Drivers
                                     // expect people to walk on for 1 s
constexpr double kAside = 0.25;      // [m] numerical: between lines that are tried
constexpr double kFarAside = 15.0;   // [m] assumed: nobody walks farther along standing vehicles
constexpr double kStraighter = 2.0;  // [m] assumed: so much more it drifts to walk straight
constexpr double kOnGround = 0.05;   // [m] numerical: beyond the kerb
constexpr double kGroupPatience = 30.0;  // [s] assumed: so long a group waits for a common gap
constexpr double kTogether = 6.0;        // [m] assumed: who is nearer crosses with its group
constexpr double kPeering = 0.3;         // [m/s] assumed: of who comes out from behind a parked car

const Street& street_of(const CrowdState& crowd, const StreetCrossing& crossing) {
  return crowd.zone.streets[crossing.street];
}

bool looks(const CrowdState& crowd, std::size_t i) {
  return crowd.model->minds_vehicles() && crowd.traffic[crowd.handle(i)].aware;
}

/// Where it is along its street; whether it may cross there.
struct Alongside {
  double s = 0.0;
  bool open = false;
};

Alongside alongside(const CrowdState& crowd, std::size_t i, const StreetCrossing& crossing) {
  const Street& street = street_of(crowd, crossing);
  const StreetPlace at = street.place(crowd.position(i));
  if (at.s < 0.0 || at.s > street.length) return {};
  const CrossingPlace& place = street.at(at.s);
  if (!place.open_to(is_impulsive(crowd, i))) return {at.s, false};
  const double kerb = crossing.side > 0 ? place.low - at.t : at.t - place.high;
  return {at.s, kerb > -kOnGround && kerb < kKerbReach};
}

/// [m] saved by crossing at s instead of going on by the junctions.
double saving(const CrowdState& crowd, std::size_t i, const StreetCrossing& crossing, double s) {
  const CrossingPlace& place = street_of(crowd, crossing).at(s);
  const double across = place.width() + std::abs(crossing.at - s) + crossing.beyond;
  return way_left(crowd.walkers[i].route, crowd.position(i)) - across;
}

/// Keeps account of the gaps that it lets pass.
void note_gap(const GapView& view, StreetCrossing& crossing) {
  if (view.vehicle == crossing.next) return;
  if (crossing.next != 0) crossing.rejected.push_back(static_cast<float>(crossing.gap));
  crossing.next = view.vehicle;
  crossing.gap = view.next;
}

/// What row i finds when it looks whether to step out.
struct Choice {
  bool considers = false, ready = false, looked = true;
  CrossingWalk walk;
  GapView view;
};

Choice consider(const CrowdState& crowd, std::size_t i, double slowest,
                const StreetCrossing& crossing, const Lookout& lookout) {
  const Alongside place = alongside(crowd, i, crossing);
  Choice choice;
  if (!place.open || crossing.turned_back) return choice;
  if (crossing.phase == CrossingPhase::kByNodes && saving(crowd, i, crossing, place.s) < kSaves) {
    return choice;
  }
  choice.considers = true;
  choice.looked = looks(crowd, i);
  choice.walk = walk_across(crowd, i, place.s);
  choice.walk.speed = std::min(choice.walk.speed, slowest);
  if (is_walking(crowd, i)) choice.walk.start_up = 0.0;
  choice.view = look_at_gap(crowd.street_traffic[crossing.street].vehicles, crowd.vehicles,
                            choice.walk, [&](std::uint32_t v) { return lookout.sees(i, v); });
  const bool waits_elsewhere = crossing.phase == CrossingPhase::kByNodes && !choice.looked;
  choice.ready = !waits_elsewhere && !choice.view.barred && (choice.view.enough || !choice.looked);
  return choice;
}

void step_out(const CrowdState& crowd, std::size_t i, const Choice& choice, Ways ways,
              std::vector<CrossingBegun>& begun) {
  StreetCrossing& crossing = ways.crossing(i);
  if (choice.looked) note_gap(choice.view, crossing);
  CrossingBegun event;
  event.handle = crowd.handle(i);
  event.street = crossing.street;
  event.s = choice.walk.s;
  event.position = crowd.position(i);
  event.time = crowd.clock.time;
  event.waited = crossing.waited;
  event.gap = choice.view.next;
  event.needed = critical_gap(choice.walk);
  event.width = street_of(crowd, crossing).at(choice.walk.s).width();
  event.looked = choice.looked;
  event.rejected = std::move(crossing.rejected);
  begun.push_back(std::move(event));
  crossing.phase = CrossingPhase::kOver;
  WalkState& walker = ways.walkers[i];
  head_across(crowd, i, choice.walk.s, walker.route);
  walker.wall_room = {};
  walker.start_clocks();
}

bool is_barred(const CrowdState& crowd, std::size_t i, const CrossingWalk& walk) {
  const StreetTraffic& traffic = crowd.street_traffic[crowd.crossing(i)->street];
  return look_at_gap(traffic.vehicles, crowd.vehicles, walk).barred;
}

/// Whether the line straight across at s is.
bool is_barred_at(const CrowdState& crowd, std::size_t i, double s) {
  return is_barred(crowd, i, walk_across(crowd, i, s));
}

/// Of who has not stepped out.
void wait_or_leave(const CrowdState& crowd, std::size_t i, const Choice& choice, double dt,
                   Ways ways) {
  StreetCrossing& crossing = ways.crossing(i);
  if (choice.considers && choice.looked) note_gap(choice.view, crossing);
  if (!crossing.at_kerb) return;
  const Vec2 kerb = kerb_before(crowd, i, crossing.at);
  if ((kerb - crowd.position(i)).norm() > kAway) crossing.at_kerb = false;
  crossing.waited += dt;
  if (choice.view.barred) {
    const auto barred = [&](double s) { return is_barred_at(crowd, i, s); };
    move_along_kerb(crowd, i, barred, ways);
  } else if (crossing.waited > crossing.detour) {
    // Whoever does not know how long it will take loses at most as much as it would have saved.
    go_by_nodes(crowd, i, ways);
  }
}

bool has_come_over(const CrowdState& crowd, std::size_t i, const StreetCrossing& crossing) {
  const Street& street = street_of(crowd, crossing);
  const StreetPlace at = street.place(crowd.position(i));
  const CrossingPlace& place = street.at(at.s);
  const double past = crossing.side > 0 ? at.t - place.high : place.low - at.t;
  return past > kOnGround && crowd.zone.walls.inside(crowd.position(i));
}

/// Round vehicles that stand on the line: straight to where it may leave the carriageway, or first
/// along it where that way is much shorter. False where there is none.
bool step_aside(const CrowdState& crowd, std::size_t i, CrossingWalk walk, Route& route) {
  const auto free = nearest_line(crowd, i, walk.s, kAside, kFarAside,
                                 [&](double s) { return is_barred_at(crowd, i, s); });
  if (!free) return false;
  const double farthest = free->way + kStraighter;
  const auto straight = nearest_line(crowd, i, walk.s, kAside, farthest, [&](double s) {
    walk.drift = s - walk.s;
    return is_barred(crowd, i, walk);
  });
  if (straight) {
    head_across(crowd, i, straight->s, route);
  } else {
    head_along(crowd, i, free->s, route);
  }
  return true;
}

/// Back to the kerb that it has left, to go by the junctions: it has stood at a lane's edge for as
/// long as they take, and no gap came.
void turn_back(const CrowdState& crowd, std::size_t i, double s, Ways ways) {
  StreetCrossing& crossing = ways.crossing(i);
  crossing.side = -crossing.side;
  crossing.turned_back = true;
  head_across(crowd, i, s, ways.walkers[i].route);
}

/// It is on the ground again, on the other side or where it came from.
void end_crossing(const CrowdState& crowd, std::size_t i, Ways ways) {
  const Destination destination = crowd.crossing(i)->destination;
  const bool turned_back = crowd.crossing(i)->turned_back;
  std::unique_ptr<StreetCrossing>& now = ways.crossings[crowd.handle(i)].now;
  now.reset();
  ways.walkers[i].wall_room = {};
  const PathMemory& path = crowd.paths[crowd.handle(i)];
  start_way(crowd, i, path != nullptr ? path->destination : destination, ways);
  if (!turned_back || now == nullptr) return;
  now->turned_back = true;
  if (now->phase == CrossingPhase::kToKerb) go_by_nodes(crowd, i, ways);
}

/// Whoever comes out from behind parked cars goes slowly until it sees along the lane.
void peer_out(const CrowdState& crowd, std::size_t i, const Lookout& lookout,
              const CrossingWalk& walk, StreetCrossing& crossing) {
  const double unseen =
      lookout.room_unseen(i, street_of(crowd, crossing), {walk.s, walk.from}, walk.to > walk.from);
  crossing.room = std::min(crossing.room, std::max(unseen, kPeering * kBraking));
}

/// Of who is on the carriageway: how fast, or that it has got over.
void go_over(const CrowdState& crowd, std::size_t i, const Lookout& lookout, double dt, Ways ways) {
  StreetCrossing& crossing = ways.crossing(i);
  Route& route = ways.walkers[i].route;
  if (has_come_over(crowd, i, crossing)) {
    end_crossing(crowd, i, ways);
    return;
  }
  const double hurried = std::exchange(crossing.hurry, 1.0);
  crossing.room = std::numeric_limits<double>::infinity();
  if (!looks(crowd, i)) return;
  const Street& street = street_of(crowd, crossing);
  CrossingWalk walk = walk_across(crowd, i, street.place(crowd.position(i)).s);
  walk.start_up = 0.0;
  walk.drift = street.place(route.points.back()).s - walk.s;
  walk.speed /= hurried;
  const Profile* profile = crowd.walkers[i].profile;
  const double fastest =
      profile != nullptr ? std::min(kFastest, profile->top_speed / walk.speed) : kFastest;
  const Passage passage =
      pass_vehicles(crowd.street_traffic[crossing.street], walk, std::max(1.0, fastest),
                    [&](std::uint32_t v) { return lookout.sees(i, v); });
  crossing.hurry = passage.hurry;
  crossing.room = passage.room;
  if (!passage.committed) peer_out(crowd, i, lookout, walk, crossing);
  if (!passage.barred()) {
    if (!route.on_last()) head_across(crowd, i, walk.s + walk.drift, route);
  } else if (!step_aside(crowd, i, walk, route)) {
    crossing.room = std::min(crossing.room, passage.standing);
  }
  if (crowd.velocity(i).norm() >= kHaltingSpeed) return;
  crossing.waited += dt;
  const bool in_vain = !passage.committed && crossing.waited > crossing.detour;
  if (in_vain && !crossing.turned_back) turn_back(crowd, i, walk.s, ways);
}

/// The slowest speed of each walker's group [m/s]; its own, of who is alone.
std::vector<double> slowest_speeds(const CrowdState& crowd) {
  const std::vector<double>& own = crowd.persons.preferred_speed;
  std::vector<double> speeds(own.begin(),
                             own.begin() + static_cast<std::ptrdiff_t>(crowd.persons.walking));
  for_each_group(crowd.members, [&](std::span<const GroupMember> group) {
    const auto speed_of = [&](const GroupMember& member) { return own[member.row]; };
    const double slowest = std::ranges::min(group | std::views::transform(speed_of));
    for (const GroupMember& member : group) speeds[member.row] = slowest;
  });
  return speeds;
}

/// Whether row j of the same group has the same street still to cross, and cannot step out with
/// row i now.
bool holds_back(const CrowdState& crowd, std::size_t j, std::size_t i,
                const std::vector<Choice>& choices) {
  const StreetCrossing *const theirs = crowd.crossing(j), *const own = crowd.crossing(i);
  if (j == i || theirs == nullptr || theirs->street != own->street) return false;
  if (theirs->phase == CrossingPhase::kOver) return false;
  return !choices[j].ready || (crowd.position(j) - crowd.position(i)).norm() > kTogether;
}

/// A group steps out together: nobody who has one that is not ready yet does.
void hold_groups_together(const CrowdState& crowd, std::vector<Choice>& choices) {
  std::vector<std::size_t> not_ready;
  for_each_group(crowd.members, [&](std::span<const GroupMember> group) {
    for (const GroupMember& member : group) {
      const std::size_t i = member.row;
      const StreetCrossing* const own = crowd.crossing(i);
      if (own == nullptr || !choices[i].ready || own->waited > kGroupPatience) continue;
      const auto holds = [&](const GroupMember& other) {
        return holds_back(crowd, other.row, i, choices);
      };
      if (std::ranges::any_of(group, holds)) not_ready.push_back(i);
    }
  });
  for (const std::size_t i : not_ready) choices[i].ready = false;
}

}  // namespace

bool is_at_street(const CrowdState& crowd, std::size_t i) {
  const StreetCrossing* const crossing = crowd.crossing(i);
  if (crossing == nullptr) return false;
  return crossing->phase == CrossingPhase::kOver || crossing->at_kerb ||
         alongside(crowd, i, *crossing).open;
}

void come_to_kerb(StreetCrossing& crossing) { crossing.at_kerb = true; }

void cross_streets(const CrowdState& crowd, double dt, Ways ways,
                   std::vector<CrossingBegun>& begun) {
  if (crowd.zone.streets.empty()) return;
  const std::size_t walking = crowd.persons.walking;
  const Lookout lookout(crowd);
  const std::vector<double> slowest = slowest_speeds(crowd);
  std::vector<Choice> choices(walking);
  for (std::size_t i = 0; i < walking; ++i) {
    const StreetCrossing* const crossing = crowd.crossing(i);
    if (crossing == nullptr || crossing->phase == CrossingPhase::kOver) continue;
    choices[i] = consider(crowd, i, slowest[i], *crossing, lookout);
  }
  hold_groups_together(crowd, choices);
  for (std::size_t i = 0; i < walking; ++i) {
    const StreetCrossing* const crossing = crowd.crossing(i);
    if (crossing == nullptr) continue;
    if (crossing->phase == CrossingPhase::kOver) {
      go_over(crowd, i, lookout, dt, ways);
    } else if (choices[i].ready) {
      step_out(crowd, i, choices[i], ways, begun);
    } else {
      wait_or_leave(crowd, i, choices[i], dt, ways);
    }
  }
}

void propose_crossings(const CrowdState& crowd, Proposals& proposals) {
  if (crowd.zone.streets.empty()) return;
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    if (!crowd.is_over(i)) continue;
    const Vec2 here = crowd.position(i);
    proposals.propose(
        i, towards(heading_point(crowd.walkers[i].route, here) - here, Behaviour::kCrossing));
  }
}

void restrain_crossings(const CrowdState& crowd, Restraints& restraints) {
  if (crowd.zone.streets.empty()) return;
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    const StreetCrossing* const crossing = crowd.crossing(i);
    if (crossing == nullptr) continue;
    if (crossing->phase == CrossingPhase::kOver) {
      Restraint only_vehicles;
      only_vehicles.most_speed = std::max(0.0, crossing->room) / kBraking;
      only_vehicles.waits = only_vehicles.most_speed < kHaltingSpeed;
      restraints.replace(i, only_vehicles);
    } else if (crossing->at_kerb) {
      const Vec2 here = crowd.position(i);
      restraints.wait(i);
      restraints.stand_facing(i, angle_of(kerb_beyond(crowd, i, crossing->at) - here));
    }
  }
}

}  // namespace pedzone
