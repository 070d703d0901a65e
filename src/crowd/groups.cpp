// Groups without a leader: whoever is too far ahead of the last one waits for it. What is compared
// is the way left to the destination; members whose destinations differ compare what is left to
// their own. (People in groups also walk slower than alone, by 0.04 m/s for each of them: Moussaid
// et al. 2010. Speeds are the scenario's; here nobody walks slower for that.)
#include "crowd/groups.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "crowd/danger.hpp"
#include "crowd/families.hpp"
#include "crowd/state.hpp"

namespace pedzone {
namespace {

constexpr double kNearer = 0.5;  // [m] assumed: less within the patience is nothing (waypoints.cpp)
constexpr double kTurnSpeed = 0.3;  // [m/s] slower than this a body turns as it likes (moves.cpp)
constexpr double kPastReach = 2.0;  // [m] assumed: who is so near before somebody is in its way
constexpr double kPastGap = 0.2;    // [m] assumed: gap that is enough to go past
constexpr double kHeldUpShare =
    0.5;  // assumed: who walks slower than so much of its speed is held up

/// Calls what(members) for each group in the order of their numbers.
template <class What>
void for_each_group(CrowdState& crowd, const What& what) {
  const std::span<GroupMember> all(crowd.members);
  for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
    while (last < all.size() && all[last].group == all[first].group) ++last;
    what(all.subspan(first, last - first));
  }
}

/// D of row i [m]: its way to the waypoint of the user's that it is on the way to, if any, then by
/// the ones after it to the end. Straight from each to the next, so that members on different
/// waypoints of a path compare where those are in view of each other.
double left_in_all(const CrowdState& crowd, std::size_t i) {
  const WalkState& walker = crowd.walkers[i];
  double left = way_left(walker.route, crowd.position(i));
  if (walker.path == nullptr) return left;
  const std::vector<Waypoint>& waypoints = walker.path->waypoints;
  Vec2 at = waypoints[walker.path->next].at;
  for (std::size_t k = walker.path->next + 1; k < waypoints.size(); ++k) {
    left += (waypoints[k].at - at).norm();
    at = waypoints[k].at;
  }
  const Destination& end = walker.path->destination;
  return left + (nearest_on_segment(at, end.a, end.b) - at).norm();
}

/// Those under way. Sorted by keys and not by rows, so that the order in which people came does
/// not matter. Who has arrived counts no more, and is nobody's to wait for.
void index_members(CrowdState& crowd) {
  crowd.members.clear();
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    WalkState& walker = crowd.walkers[i];
    if (walker.group == 0) continue;
    if (walker.arrived) {
      walker.waits_for_group = false;
      let_go(walker);
      continue;
    }
    crowd.members.push_back(
        {walker.group, crowd.persons.key[i], static_cast<std::uint32_t>(i), left_in_all(crowd, i)});
  }
  std::sort(crowd.members.begin(), crowd.members.end(), [](const auto& one, const auto& other) {
    return one.group != other.group ? one.group < other.group : one.key < other.key;
  });
}

/// The rule itself. Whoever is waited for may take its time as long as it comes nearer. Who has
/// waited for its patience without that walks on for as long before it waits again: where the last
/// one is stuck the others come to their destination in twice their time, and where it is free
/// again they are still found. A maximum distance below the preferred one counts as that.
void update_wait(WalkState& walker, double ahead, const Zone& zone, double dt) {
  const Parameters& parameters = zone.parameters;
  if (ahead <= parameters.group_preferred_distance) {
    walker.waits_for_group = false;
    walker.group_clock = 0.0;
  } else if (walker.waits_for_group) {
    const bool nearer = ahead < walker.group_least - kNearer;
    if (nearer) walker.group_least = ahead;
    walker.group_clock = nearer ? 0.0 : walker.group_clock + dt;
    if (walker.group_clock < patience(zone, walker)) return;
    walker.waits_for_group = false;
    walker.group_clock = -patience(zone, walker);
  } else {
    walker.group_clock = std::min(0.0, walker.group_clock + dt);
    walker.waits_for_group = walker.group_clock == 0.0 && ahead > parameters.group_maximum_distance;
    walker.group_least = ahead;
  }
}

void update_waits(CrowdState& crowd, std::span<const GroupMember> group, double dt) {
  double most = 0.0;
  for (const GroupMember& member : group) most = std::max(most, member.left);
  for (const GroupMember& member : group) {
    WalkState& walker = crowd.walkers[member.row];
    // A child that is on its way to its adult, or held by it, waits for nobody else.
    const double ahead = walker.led ? 0.0 : most - member.left;
    update_wait(walker, ahead, crowd.zone, dt);
  }
}

/// The way [m] that row i makes to let row j past; nothing where it is not in its way. To the side
/// where it stands already, else across, else ahead of the other.
std::optional<Vec2> way_aside(const CrowdState& crowd, std::size_t i, std::size_t j) {
  const Vec2 here = crowd.position(i), from_other = here - crowd.position(j);
  const double bodies = crowd.persons.radius[i] + crowd.persons.radius[j];
  if (from_other.squaredNorm() > (bodies + kPastReach) * (bodies + kPastReach)) return {};
  const Vec2 along = unit(crowd.persons.goal_direction[j]);
  if (crowd.velocity(j).dot(along) > kHeldUpShare * crowd.persons.preferred_speed[j]) return {};
  const double ahead = from_other.dot(along), lateral = cross(along, from_other);
  const double lacking = bodies + kPastGap - std::abs(lateral);
  if (ahead <= 0.0 || lacking <= 0.0) return {};
  const double side =
      lateral != 0.0 ? std::copysign(1.0, lateral) : (crowd.persons.key[i] % 2 == 0 ? 1.0 : -1.0);
  const Vec2 outward = side * left_of(along);
  const double body = 0.5 * crowd.persons.radius[i];
  const Vec2 near = lacking * outward, across = -(lacking + 2.0 * std::abs(lateral)) * outward;
  if (crowd.zone.walls.free_line(here, here + near, body)) return near;
  if (crowd.zone.walls.free_line(here, here + across, body)) return across;
  return bodies * along;
}

/// Who waits minds the middle of the others and not its way.
void turn_to_others(CrowdState& crowd, std::span<const GroupMember> group, std::size_t i) {
  Vec2 sum = Vec2::Zero();
  for (const GroupMember& other : group) sum += crowd.position(other.row) - crowd.position(i);
  if (sum == Vec2::Zero()) return;
  crowd.persons.goal_direction[i] = angle_of(sum);
  crowd.persons.goal_distance[i] = sum.norm() / static_cast<double>(group.size());
}

/// Who waits makes room for the first (by key) who is behind it and cannot get past. It is the
/// goal that changes: where it steps, and whether it can, is the model's choice.
void make_room(CrowdState& crowd, std::span<GroupMember> group) {
  for (GroupMember& member : group) {
    if (!crowd.walkers[member.row].waits_for_group) continue;
    turn_to_others(crowd, group, member.row);
    for (const GroupMember& other : group) {
      if (crowd.walkers[other.row].waits_for_group || other.left <= member.left) continue;
      const auto way = way_aside(crowd, member.row, other.row);
      if (!way) continue;
      member.steps_aside = true;
      crowd.persons.goal_direction[member.row] = angle_of(*way);
      crowd.persons.goal_distance[member.row] = way->norm();
      break;
    }
  }
}

/// Stands, turned to the others.
void stand(CrowdState& crowd, std::size_t i) {
  Decision& decision = crowd.decisions[i];
  decision.speed = 0.0;
  // A body that still moves keeps the direction in which its way is known to be free.
  if (crowd.velocity(i).norm() < kTurnSpeed) decision.direction = crowd.persons.goal_direction[i];
}

}  // namespace

void gather_groups(CrowdState& crowd, double dt) {
  if (crowd.grouped == 0) return;
  index_members(crowd);
  for_each_group(crowd, [&](std::span<GroupMember> group) {
    guide_children(crowd, group, dt);
    update_waits(crowd, group, dt);
    make_room(crowd, group);
  });
}

/// Nobody waits in the way of a vehicle: there the model's decision stands.
void wait_for_groups(CrowdState& crowd) {
  if (crowd.grouped == 0) return;
  for_each_group(crowd, [&](std::span<const GroupMember> group) {
    for (const GroupMember& member : group) {
      const bool waits = crowd.walkers[member.row].waits_for_group && !member.steps_aside;
      if (waits && may_stand(crowd, member.row)) stand(crowd, member.row);
    }
    lead_children(crowd, group);
  });
}

}  // namespace pedzone
