#include "crowd/motion/vehicle_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "crowd/sense/vehicle_motion.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kGap = 0.05;      // [m] assumed: nobody lets a vehicle touch the clothes
constexpr double kGapTime = 0.04;  // [s] numerical: more room to a moving vehicle, since where it
                                   // gets to is predicted (SUMO then brakes or turns otherwise)
constexpr double kGapTurn = 0.25;  // [s] numerical: the same for its corners when it turns
constexpr double kNoGap = 1e-3;    // [m] numerical: what counts as not touching
constexpr double kStep = 0.2;      // [m] numerical: beyond what the vehicle itself moves, nobody is
                                   // moved farther by it in one substep

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

/// Room [m] that bodies keep to a vehicle: more when it is fast or turns, since where its corners
/// get to is then less certain (SUMO turns it about its front, and by other angles in each step).
double gap_to(const VehicleState& vehicle) {
  const double corner_speed = 0.5 * vehicle.length * std::abs(vehicle.yaw_rate);
  return kGap + kGapTime * vehicle.velocity.norm() + kGapTurn * corner_speed;
}

/// Where a body of `radius` at `here` gets out of the vehicle's way: towards the nearest exit that
/// no wall bars; where all are barred, to the place with most room that it can get to.
Vec2 moved_out(const WallIndex& walls, const VehicleState& vehicle, const Vec2& here, double radius,
               double longest) {
  const Rectangle frame = rectangle_of(vehicle);
  const Vec2 local = frame.into_frame(here);
  Vec2 best = here;
  double best_room = frame.local_distance(local);
  const double reach = radius + gap_to(vehicle);
  if (best_room >= reach) return here;
  for (const Vec2& exit : exits(frame, local, reach)) {
    Vec2 step = frame.out_of_frame(exit) - here;
    if (step.norm() > longest) step *= longest / step.norm();
    const Vec2 at = walls.slide(here, here + step, radius);
    const double room = frame.distance(at);
    const bool barred = (here + step - at).norm() > kNoGap;
    if (room >= radius - kNoGap || !barred) return at;
    if (room > best_room) {
      best = at;
      best_room = room;
    }
  }
  return best;
}

/// [m] to which a vehicle gets to a body: past one that stands, people go with turned shoulders.
double reach_of(const CrowdState& crowd, std::size_t i, const VehicleState& vehicle) {
  const bool stands = vehicle.velocity.norm() < kStaticSpeed;
  return stands ? crowd.persons.present_radius[i] : crowd.persons.radius[i];
}

/// Lists who may be reached by which vehicle, ordered by person.
void find_hits(const CrowdState& crowd, double dt, std::vector<VehicleHit>& hits) {
  const Persons& persons = crowd.persons;
  const double widest = *std::max_element(persons.radius.begin(), persons.radius.end());
  hits.clear();
  for (std::size_t v = 0; v < crowd.vehicles.size(); ++v) {
    const VehicleState& vehicle = crowd.vehicles[v];
    const double around = 0.5 * std::hypot(vehicle.length, vehicle.width) + widest +
                          gap_to(vehicle) + vehicle.velocity.norm() * dt + 2.0 * crowd.moves.reach +
                          kStep;
    const Vec2 box = Vec2::Constant(around);
    const Vec2 low = vehicle.centre - box, high = vehicle.centre + box;
    crowd.grid.visit_box(low, high, [&](std::uint32_t i, const Vec2& there) {
      if (i >= persons.walking) return;
      if ((there - vehicle.centre).squaredNorm() > around * around) return;
      hits.push_back({i, static_cast<std::uint32_t>(v)});
    });
  }
  std::sort(hits.begin(), hits.end(), [](const VehicleHit& a, const VehicleHit& b) {
    return a.person != b.person ? a.person < b.person : a.vehicle < b.vehicle;
  });
}

}  // namespace

void keep_out_of_vehicles(const CrowdState& crowd, double dt, std::vector<VehicleHit>& hits,
                          Moves& moves) {
  if (crowd.vehicles.empty() || crowd.persons.size() == 0) return;
  find_hits(crowd, dt, hits);
  for (const VehicleHit& hit : hits) {
    const VehicleState& now = crowd.vehicles[hit.vehicle];
    const VehicleState later = moved_on(now, dt);
    const double turn = std::abs(wrap_angle(later.heading - now.heading)) * 0.5 * now.length;
    const double longest = kStep + (later.centre - now.centre).norm() + turn;
    const Vec2 here(moves.x[hit.person], moves.y[hit.person]);
    const Vec2 at =
        moved_out(crowd.zone.walls, later, here, reach_of(crowd, hit.person, now), longest);
    moves.x[hit.person] = at.x();
    moves.y[hit.person] = at.y();
  }
}

}  // namespace pedzone
