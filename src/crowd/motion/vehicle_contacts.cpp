// A body gives way to a vehicle no faster than a person could step. Whoever would have to is run
// into: the bodies overlap, and come apart at that speed. Whom a slow vehicle moves along before
// it, farther than a step, it has run into as well (push_log.cpp).
#include "crowd/motion/vehicle_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "crowd/sense/vehicle_motion.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kGap = 0.05;      // [m] assumed: nobody lets a vehicle touch the clothes
constexpr double kGapTime = 0.04;  // [s] numerical: more room before and behind a moving vehicle:
                                   // where it gets to is predicted (SUMO may brake it)
constexpr double kGapTurn = 0.25;  // [s] numerical: the same for its corners when it turns and
                                   // nobody knows its way
constexpr double kSwing = 0.2;     // [m] numerical: that its rear swings from one place to the next
constexpr double kLeastApart = 0.2;  // [m] numerical: of these places
constexpr double kNoGap = 1e-3;      // [m] numerical: what counts as not touching
constexpr double kSlack = 0.2;       // [m] numerical: contacts of bodies move people farther than
                                     // they meant to
constexpr double kContact = 0.01;    // [m] numerical: bodies that overlap by less do not touch

/// Where a body at `local` could go to have `reach` to the rectangle, the nearest first: straight
/// away from it where it is outside, and out at each of the four sides.
std::array<Vec2, 5> exits(const Rectangle& frame, const Vec2& local, double reach) {
  const Vec2 far = frame.half + Vec2::Constant(reach);
  const Vec2 closest = local.cwiseMax(-frame.half).cwiseMin(frame.half);
  const Vec2 away = local - closest;
  std::array<Vec2, 5> places{Vec2(far.x(), local.y()), Vec2(-far.x(), local.y()),
                             Vec2(local.x(), far.y()), Vec2(local.x(), -far.y()),
                             Vec2(far.x(), local.y())};
  if (away.norm() > 0.0) places[4] = closest + away * (reach / away.norm());
  std::sort(places.begin(), places.end(), [&](const Vec2& a, const Vec2& b) {
    return (a - local).squaredNorm() < (b - local).squaredNorm();
  });
  return places;
}

/// Room [m] that bodies keep to a vehicle's sides: more when it turns on a way that is not known,
/// since where its corners get to is then less certain. On a known way only how far it gets is.
double gap_to(const VehicleState& vehicle) {
  if (vehicle.forwards) return kGap;
  return kGap + kGapTurn * 0.5 * vehicle.length * std::abs(vehicle.yaw_rate);
}

/// Where the vehicle may be, by its speed. Not to its sides: a car that passes a footway at 50 km/h
/// would move everybody at the kerb by 0.6 m.
Rectangle around(const VehicleState& vehicle, const Rectangle& body) {
  Rectangle frame = body;
  frame.half.x() += kGapTime * vehicle.velocity.norm();
  return frame;
}

/// Where a body at `here` gets out of the frame's way, to have `reach` [m] to it: towards the
/// nearest exit that no wall bars, or where there is room for `least` [m] at least; where all are
/// barred, to the place with most room that it can get to. To walls it keeps no more than `radius`
/// [m], as it is turned: between a wall and a vehicle, more would take it into the vehicle.
Vec2 moved_out(const WallIndex& walls, double radius, const Rectangle& frame, const Vec2& here,
               double reach, double least, double longest) {
  const Vec2 local = frame.into_frame(here);
  Vec2 best = here;
  if (frame.local_distance(local) >= reach || longest <= 0.0) return here;
  const double room_here = signed_distance(frame.half, local);
  double best_room = room_here;
  for (const Vec2& exit : exits(frame, local, reach)) {
    Vec2 step = frame.out_of_frame(exit) - here;
    if (step.norm() > longest) step *= longest / step.norm();
    const Vec2 at = walls.slide(here, here + step, radius);
    const double room = frame.signed_distance(at);
    const bool barred = (here + step - at).norm() > kNoGap;
    // The first steps to an exit across it lead farther under it.
    if (room >= least - kNoGap || (!barred && room > room_here + kNoGap)) return at;
    if (room > best_room) {
      best = at;
      best_room = room;
    }
  }
  return best;
}

/// [m] how far from where it is expected the vehicle may be, in `dt` [s].
double unsure(const VehicleState& vehicle, double dt) {
  return std::max({vehicle.lag + vehicle.slower * dt, vehicle.lead, vehicle.starts});
}

/// [m] from its centre within which the vehicle may reach a body of at most `widest` [m].
double reach_of(const CrowdState& crowd, std::size_t v, double widest, double dt) {
  const VehicleState& vehicle = crowd.vehicles[v];
  return around(vehicle, crowd.vehicle_bodies[v]).half.norm() + widest + gap_to(vehicle) +
         unsure(vehicle, dt) + vehicle.velocity.norm() * dt + 2.0 * crowd.moves.reach + kSlack;
}

/// Lists who may be reached by which vehicle, ordered by person.
void find_hits(const CrowdState& crowd, double dt, std::vector<VehicleHit>& hits) {
  struct Reach {
    Vec2 centre;
    double squared;  ///< [m²]
  };
  thread_local std::vector<Reach> reaches;
  const Persons& persons = crowd.persons;
  const double widest = *std::max_element(persons.radius.begin(), persons.radius.end());
  reaches.clear();
  for (std::size_t v = 0; v < crowd.vehicles.size(); ++v) {
    const double reach = reach_of(crowd, v, widest, dt);
    reaches.push_back({crowd.vehicles[v].centre, reach * reach});
  }
  hits.clear();
  for (std::uint32_t i = 0; i < persons.walking; ++i) {
    const Vec2 there = crowd.position(i);
    for (const std::uint32_t v : crowd.vehicles_near.at(there)) {
      const bool reached = (there - reaches[v].centre).squaredNorm() <= reaches[v].squared;
      if (reached) hits.push_back({i, v});
    }
  }
}

/// Adds what the vehicle did to the person to what it did in this step already.
void tell(const VehiclePush& push, std::vector<VehiclePush>& pushes) {
  const auto pair = [](const VehiclePush& p) { return std::pair(p.person, p.vehicle); };
  const auto same = std::ranges::lower_bound(pushes, pair(push), {}, pair);
  if (same == pushes.end() || pair(*same) != pair(push)) {
    pushes.insert(same, push);
    return;
  }
  same->way += push.way;
  same->carried += push.carried;
  same->speed = std::max(same->speed, push.speed);
  if (same->run_into) return;  // its speed is that with which it did
  same->run_into = push.run_into;
  same->contact_speed = push.contact_speed;
  same->position = push.position;
}

/// Puts the person there; how far [m] that is from where it meant to be.
double put(std::uint32_t person, const Vec2& at, Moves& moves) {
  const double way = (at - Vec2(moves.x[person], moves.y[person])).norm();
  moves.x[person] = at.x();
  moves.y[person] = at.y();
  return way;
}

/// Whether another vehicle that may reach the person than that of `hit` is nearer to `at` [m] at
/// the substep's end than bodies keep from it, and nearer than to `here`.
bool is_near_another(const CrowdState& crowd, std::span<const VehicleHit> hits,
                     const VehicleHit& hit, const Vec2& here, const Vec2& at) {
  const double reach = crowd.persons.radius[hit.person] + kGap;
  const auto own = std::ranges::equal_range(hits, hit.person, {}, &VehicleHit::person);
  return std::ranges::any_of(own, [&](const VehicleHit& other) {
    if (other.vehicle == hit.vehicle) return false;
    const Rectangle& its = crowd.bodies_later[other.vehicle];
    return its.distance(at) < std::min(reach, its.distance(here) - kNoGap);
  });
}

/// [m] by which a move leads the way that the vehicle drives, of who is before its bumper.
double carried(const Rectangle& body, const Vec2& velocity, const Vec2& from, const Vec2& to) {
  const double drives = velocity.dot(body.axis) < 0.0 ? -1.0 : 1.0;
  if (drives * body.into_frame(from).x() <= body.half.x()) return 0.0;
  return std::max(0.0, drives * (to - from).dot(body.axis));
}

/// Moves the person out of the way of where the vehicle gets to, by at most `longest`
/// [m]; what came of it.
VehiclePush push_out(const CrowdState& crowd, const VehicleHit& hit, double dt, double longest,
                     Moves& moves) {
  const Persons& persons = crowd.persons;
  const VehicleState& vehicle = crowd.vehicles[hit.vehicle];
  const VehicleState& later = crowd.vehicles_later[hit.vehicle];
  const Rectangle& body = crowd.bodies_later[hit.vehicle];
  const Rectangle frame = around(later, body);
  const Vec2 here(moves.x[hit.person], moves.y[hit.person]);
  // Past one that stands people go with turned shoulders. One that drives gets all the room that
  // there is; where that is too little a slow one still passes who has turned.
  const double straight = persons.radius[hit.person], turned = persons.present_radius[hit.person];
  const double speed = vehicle.velocity.norm();
  const double radius = speed < kStaticSpeed ? turned : straight;
  const double least = lets_squeeze_past(speed) ? turned : straight;
  const auto out = [&](double gap) {
    return moved_out(crowd.walls_of(hit.person), turned, frame, here, radius + gap, least, longest);
  };
  Vec2 at = out(gap_to(later));
  // Room that one may need when it turns moves nobody under another.
  if (at != here && is_near_another(crowd, moves.hits, hit, here, at)) at = out(kGap);
  VehiclePush push{persons.key[hit.person], vehicle.key};
  push.way = put(hit.person, at, moves);
  push.carried = carried(body, vehicle.velocity, here, at);
  push.speed = push.way / dt;
  push.run_into = body.distance(at) < least - kContact;
  push.contact_speed = vehicle.velocity.norm();
  push.position = at;
  return push;
}

/// The person gets no nearer to a body than `reach` [m], or than it is. Returns how far [m] that
/// moves it, at most `longest`.
double keep_from(const CrowdState& crowd, const Rectangle& body, std::uint32_t person, double reach,
                 double longest, Moves& moves) {
  const Vec2 here(moves.x[person], moves.y[person]);
  const double least = std::min(reach, body.distance(crowd.position(person)));
  const double radius = crowd.persons.present_radius[person];
  return put(person, moved_out(crowd.walls_of(person), radius, body, here, least, least, longest),
             moves);
}

/// [m] of its way from one place to the next, so that nobody fits between what they cover.
double apart_of_places(const VehicleState& vehicle) {
  const double swing = std::abs(vehicle.yaw_rate) * vehicle.length;  // [m/s]
  const double apart = vehicle.velocity.norm() * kSwing / std::max(swing, kNoGap);
  return std::max(kLeastApart, std::min(apart, vehicle.length));
}

/// A vehicle took its speed for the step before people walk, and SUMO may brake it or let it drive
/// off. Nobody walks to where it may get until the step ends, nor to where it may still be. Returns
/// how far [m] the person is held back, at most `longest`.
double hold_back(const CrowdState& crowd, std::uint32_t person, const VehicleState& later,
                 double longest, Moves& moves) {
  const double straight = crowd.persons.radius[person];
  const double beside = crowd.persons.present_radius[person] + kGap;
  double way = 0.0;
  const auto keep = [&](const Rectangle& body, double reach) {
    way += keep_from(crowd, body, person, reach, std::max(0.0, longest - way), moves);
  };
  const double apart = apart_of_places(later);
  for (double behind = later.lag; behind > kNoGap; behind -= apart) {
    keep(body_shifted(later, -behind), straight);
  }
  for (double ahead = later.lead; ahead > kNoGap; ahead -= apart) {
    keep(body_shifted(later, ahead), straight);
  }
  if (later.starts > kNoGap) {
    const double places = std::ceil(later.starts / kLeastApart);
    for (double place = 1.0; place <= places; place += 1.0) {
      const double ahead = later.starts * place / places;
      keep(flanks_if_started(later, ahead), beside);
      // Who comes to its front is seen there, and the vehicle stays: a step later they may pass.
      keep(body_if_started(later, ahead), straight);
    }
  }
  return way;
}

}  // namespace

bool keep_out_of_vehicles(const CrowdState& crowd, double dt, Moves& moves,
                          std::vector<VehiclePush>& pushes) {
  if (crowd.vehicles.empty() || crowd.persons.size() == 0) return false;
  find_hits(crowd, dt, moves.hits);
  bool moved = false;
  for (const VehicleHit& hit : moves.hits) {
    const VehicleState& later = crowd.vehicles_later[hit.vehicle];
    double& way = moves.by_vehicles[hit.person];
    const auto left = [&] { return std::max(0.0, kSteppingSpeed * dt - way); };
    const double held = hold_back(crowd, hit.person, later, left(), moves);
    way += held;
    const VehiclePush push = push_out(crowd, hit, dt, left(), moves);
    way += push.way;
    moved = moved || held + push.way > 0.0;
    const bool drives = crowd.vehicles[hit.vehicle].velocity.norm() >= kHaltingSpeed;
    if (drives && (push.way > 0.0 || push.run_into)) tell(push, pushes);
  }
  return moved;
}

}  // namespace pedzone
