// Phase: what people do beside walking begins and ends along the walk, by rate; and how fast each
// would walk at present. Impulsive people now and then run in front of a vehicle.
#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "crowd/parallel.hpp"
#include "crowd/state.hpp"

namespace pedzone {
namespace {

constexpr double kMinute = 60.0;
constexpr double kDashReach = 15.0;  // [m] assumed: from farther away nobody runs at a vehicle
constexpr double kSeatReach = 15.0;  // [m] assumed: nobody goes farther to sit down
constexpr double kOnSeat = 0.4;      // [m] assumed
constexpr double kDashTime = 3.0;    // [s] assumed: and so long it runs

/// The activity that begins within dt; none nearly always.
Activity begun(const CrowdState& crowd, std::size_t i, double dt) {
  const WalkState& walker = crowd.walkers[i];
  double drawn = -1.0, sum = 0.0;
  for (std::size_t k = 0; k < kActivities; ++k) {
    if (walker.rates[k] <= 0.0) continue;
    if (drawn < 0.0) {
      drawn = random_uniform(crowd.seed, crowd.persons.key[i], crowd.substep, Purpose::kActivity);
    }
    sum += 1.0 - std::exp(-walker.rates[k] * dt / kMinute);
    if (drawn < sum) return static_cast<Activity>(k);
  }
  return Activity::kNone;
}

/// Index of the nearest seat that the person can go straight to; -1: none within kSeatReach.
std::int32_t free_seat(const CrowdState& crowd, std::size_t i) {
  std::int32_t nearest = -1;
  const Vec2 here = crowd.position(i);
  double least = kSeatReach;
  for (std::size_t k = 0; k < crowd.zone.seats.size(); ++k) {
    const Vec2& seat = crowd.zone.seats[k];
    const double distance = (seat - here).norm();
    if (distance >= least || !crowd.zone.walls.free_line(here, seat, 0.0)) continue;
    least = distance;
    nearest = static_cast<std::int32_t>(k);
  }
  return nearest;
}

/// Where there are seats people sit on seats, else where they are.
void begin(CrowdState& crowd, std::size_t i, Activity activity) {
  WalkState& walker = crowd.walkers[i];
  walker.seat = -1;
  if (activity == Activity::kSitting && !crowd.zone.seats.empty()) {
    walker.seat = free_seat(crowd, i);
    if (walker.seat < 0) return;
  }
  walker.activity = activity;
}

/// [m] way to the seat of a person who goes to sit down; zero where it has got there, or has none.
Vec2 way_to_seat(const CrowdState& crowd, std::size_t i) {
  const WalkState& walker = crowd.walkers[i];
  if (walker.activity != Activity::kSitting || walker.seat < 0) return Vec2::Zero();
  const Vec2 way = crowd.zone.seats[static_cast<std::size_t>(walker.seat)] - crowd.position(i);
  return way.norm() > kOnSeat ? way : Vec2(Vec2::Zero());
}

bool ended(const CrowdState& crowd, std::size_t i, double dt) {
  const double stays = std::exp(-dt / info_of(crowd.walkers[i].activity).duration);
  return random_uniform(crowd.seed, crowd.persons.key[i], crowd.substep, Purpose::kActivity) >=
         stays;
}

/// The moving vehicle nearest to the person within kDashReach; null: none.
const VehicleState* nearest_moving(const CrowdState& crowd, std::size_t i) {
  const VehicleState* nearest = nullptr;
  double least = kDashReach;
  for (const VehicleState& vehicle : crowd.vehicles) {
    const double distance = (vehicle.centre - crowd.position(i)).norm();
    if (distance >= least || vehicle.velocity.norm() < 0.5) continue;
    least = distance;
    nearest = &vehicle;
  }
  return nearest;
}

void begin_dash(CrowdState& crowd, std::size_t i, double dt) {
  WalkState& walker = crowd.walkers[i];
  if (walker.profile == nullptr || walker.profile->impulsiveness <= 0.0) return;
  if (walker.dash > 0.0 || walker.arrived || nearest_moving(crowd, i) == nullptr) return;
  const double stays = std::exp(-walker.profile->impulsiveness * dt / kMinute);
  if (random_uniform(crowd.seed, crowd.persons.key[i], crowd.substep, Purpose::kImpulse) >= stays) {
    walker.dash = kDashTime;
  }
}

}  // namespace

void live(CrowdState& crowd, double dt) {
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      WalkState& walker = crowd.walkers[i];
      if (walker.activity == Activity::kNone) {
        begin(crowd, i, begun(crowd, i, dt));
      } else if (ended(crowd, i, dt)) {
        walker.activity = Activity::kNone;
      }
      walker.dash = std::max(0.0, walker.dash - dt);
      begin_dash(crowd, i, dt);
      // Who stands still wants to walk as fast as ever: it stands by its decision (stand_still).
      const double pace = info_of(walker.activity).speed;
      crowd.persons.preferred_speed[i] =
          walker.own_speed * crowd.zone.weather->speed * (pace > 0.0 ? pace : 1.0);
      if (walker.dash > 0.0) crowd.persons.preferred_speed[i] = walker.profile->top_speed;
    }
  });
}

void go_to_seats(CrowdState& crowd) {
  if (crowd.zone.seats.empty()) return;
  Persons& persons = crowd.persons;
  for (std::size_t i = 0; i < persons.walking; ++i) {
    const Vec2 to = way_to_seat(crowd, i);
    if (crowd.walkers[i].arrived || to == Vec2::Zero()) continue;
    persons.goal_direction[i] = angle_of(to);
    persons.goal_distance[i] = to.norm();
  }
}

/// Towards where the vehicle's front will be when the person gets there, not minding it.
void dash(CrowdState& crowd) {
  Persons& persons = crowd.persons;
  for (std::size_t i = 0; i < persons.walking; ++i) {
    if (crowd.walkers[i].dash <= 0.0) continue;
    const VehicleState* vehicle = nearest_moving(crowd, i);
    if (vehicle == nullptr) continue;
    const Vec2 here = crowd.position(i);
    const Vec2 front = vehicle->centre + unit(vehicle->heading) * (0.5 * vehicle->length);
    const double time = (front - here).norm() / persons.preferred_speed[i];
    const Vec2 to = front + vehicle->velocity * time - here;
    persons.goal_direction[i] = angle_of(to);
    persons.goal_distance[i] = to.norm();
    crowd.attention.ignore(i, static_cast<std::size_t>(vehicle - crowd.vehicles.data()));
  }
}

/// Who chats or sits stands, unless a vehicle makes it step aside.
void stand_still(CrowdState& crowd) {
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    const WalkState& walker = crowd.walkers[i];
    if (walker.activity == Activity::kNone || info_of(walker.activity).speed > 0.0) continue;
    if (way_to_seat(crowd, i) != Vec2::Zero()) continue;
    const bool disturbed = std::ranges::any_of(
        walker.noticed, [&](const Noticed& noticed) { return noticed.minds && noticed.near; });
    if (!disturbed) crowd.decisions[i].speed = 0.0;
  }
}

}  // namespace pedzone
