#include "crowd/behaviour/activities.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "crowd/state/parallel.hpp"

namespace pedzone {
namespace {

constexpr double kMinute = 60.0;
constexpr double kSeatReach = 15.0;  // [m] assumed: nobody goes farther to sit down
constexpr double kOnSeat = 0.4;      // [m] assumed

/// The activity that begins within dt; none nearly always.
Activity begun(const CrowdState& crowd, std::size_t i, const ActivityMemory& memory, double dt) {
  double drawn = -1.0, sum = 0.0;
  for (std::size_t k = 0; k < kActivities; ++k) {
    if (memory.rates[k] <= 0.0) continue;
    if (drawn < 0.0) {
      drawn =
          random_uniform(crowd.seed, crowd.persons.key[i], crowd.clock.substep, Purpose::kActivity);
    }
    sum += 1.0 - std::exp(-memory.rates[k] * dt / kMinute);
    if (drawn < sum) return static_cast<Activity>(k);
  }
  return Activity::kNone;
}

bool ended(const CrowdState& crowd, std::size_t i, Activity activity, double dt) {
  const double stays = std::exp(-dt / info_of(activity).duration);
  return random_uniform(crowd.seed, crowd.persons.key[i], crowd.clock.substep,
                        Purpose::kActivity) >= stays;
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
void begin(const CrowdState& crowd, std::size_t i, Activity activity, ActivityMemory& memory) {
  memory.seat = -1;
  if (activity == Activity::kSitting && !crowd.zone.seats.empty()) {
    memory.seat = free_seat(crowd, i);
    if (memory.seat < 0) return;
  }
  memory.activity = activity;
}

/// [m] way to the seat of a person who goes to sit down; zero where it has got there, or has none.
Vec2 way_to_seat(const CrowdState& crowd, std::size_t i) {
  const ActivityMemory& memory = crowd.activities[crowd.handle(i)];
  if (memory.activity != Activity::kSitting || memory.seat < 0) return Vec2::Zero();
  const Vec2 way = crowd.zone.seats[static_cast<std::size_t>(memory.seat)] - crowd.position(i);
  return way.norm() > kOnSeat ? way : Vec2(Vec2::Zero());
}

}  // namespace

void carry_on_activities(const CrowdState& crowd, double dt, ByHandle<ActivityMemory>& activities) {
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      ActivityMemory& memory = activities[crowd.handle(i)];
      if (memory.activity == Activity::kNone) {
        begin(crowd, i, begun(crowd, i, memory, dt), memory);
      } else if (ended(crowd, i, memory.activity, dt)) {
        memory.activity = Activity::kNone;
      }
    }
  });
}

void propose_seats(const CrowdState& crowd, Proposals& proposals) {
  if (crowd.zone.seats.empty()) return;
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    const Vec2 way = way_to_seat(crowd, i);
    if (crowd.walkers[i].arrived || way == Vec2::Zero()) continue;
    proposals.propose(i, towards(way, Behaviour::kSeat));
  }
}

void restrain_by_activity(const CrowdState& crowd, Restraints& restraints) {
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    const Activity activity = crowd.activities[crowd.handle(i)].activity;
    if (activity == Activity::kNone || info_of(activity).speed > 0.0) continue;
    if (way_to_seat(crowd, i) != Vec2::Zero()) continue;
    const bool disturbed =
        std::ranges::any_of(crowd.traffic[crowd.handle(i)].noticed,
                            [](const Noticed& noticed) { return noticed.minds && noticed.near; });
    if (!disturbed) restraints.stand(i);
  }
}

}  // namespace pedzone
