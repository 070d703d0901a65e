// What is compared is the way left to the destination: only members who go to the same place belong
// together. (People in groups also walk slower than alone, by 0.04 m/s for each of them: Moussaid et
// al. 2010. Speeds are the scenario's; here nobody walks slower for that.)
#include "crowd/behaviour/groups.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "crowd/sense/danger.hpp"
#include "geometry/segment.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kSamePlace = 10.0;  // [m] assumed: destinations that are farther apart differ
constexpr double kNearer = 0.5;  // [m] assumed: less within the patience is nothing (waypoints.cpp)
constexpr double kPastReach = 2.0;  // [m] assumed: who is so near before somebody is in its way
constexpr double kPastGap = 0.2;    // [m] assumed: gap that is enough to go past
constexpr double kHeldUpShare =
    0.5;  // assumed: who walks slower than so much of its speed is held up

/// The middle of where row i gets to at last [m].
Vec2 end_of_way(const CrowdState& crowd, std::size_t i) {
  const PathMemory& path = crowd.paths[crowd.handle(i)];
  const StreetCrossing* const street = crowd.crossing(i);
  const Destination& end = path != nullptr     ? path->destination
                           : street != nullptr ? street->destination
                                               : crowd.walkers[i].route.destination;
  return 0.5 * (end.a + end.b);
}

bool by_group(const GroupMember& one, const GroupMember& other) {
  return one.group != other.group ? one.group < other.group : one.key < other.key;
}

/// Makes those of each group who go to another place than those before them a group of their own.
/// Who waited for such members would wait for people who walk away, or lead a child astray.
void part_ways(const CrowdState& crowd, std::vector<GroupMember>& members) {
  const auto same_place = [&](const GroupMember& one, const GroupMember& other) {
    return (end_of_way(crowd, one.row) - end_of_way(crowd, other.row)).norm() <= kSamePlace;
  };
  for_each_group(members, [&](std::span<GroupMember> group) {
    for (std::size_t k = 1; k < group.size(); ++k) {
      const auto before = group.first(k);
      const auto there = std::ranges::find_if(
          before, [&](const GroupMember& one) { return same_place(one, group[k]); });
      group[k].group = there == before.end() ? group[k].key : there->group;
    }
  });
  std::ranges::sort(members, by_group);
}

/// D of row i [m]: its way to the waypoint of the user's that it is on the way to, if any, then by
/// the ones after it to the end. Straight from each to the next, so that members on different
/// waypoints of a path compare where those are in view of each other.
double left_in_all(const CrowdState& crowd, std::size_t i) {
  double left = way_left(crowd.walkers[i].route, crowd.position(i));
  const PathMemory& path = crowd.paths[crowd.handle(i)];
  if (path == nullptr) return left;
  const std::vector<Waypoint>& waypoints = path->waypoints;
  Vec2 at = path->current().at;
  for (std::size_t k = path->next + 1; k < waypoints.size(); ++k) {
    left += (waypoints[k].at - at).norm();
    at = waypoints[k].at;
  }
  const Destination& end = path->destination;
  return left + (nearest_on(end.a, end.b, at) - at).norm();
}

/// The rule itself. Whoever is waited for may take its time as long as it comes nearer. Who has
/// waited for its patience without that walks on for as long before it waits again: where the last
/// one is stuck the others come to their destination in twice their time, and where it is free
/// again they are still found. A maximum distance below the preferred one counts as that.
void update_wait(GroupMemory& memory, double ahead, const Parameters& parameters, double longest,
                 double dt) {
  if (ahead <= parameters.group_preferred_distance) {
    memory.waits = false;
    memory.in_vain = 0.0;
  } else if (memory.waits) {
    const bool nearer = ahead < memory.nearest - kNearer;
    if (nearer) memory.nearest = ahead;
    memory.in_vain = nearer ? 0.0 : memory.in_vain + dt;
    if (memory.in_vain < longest) return;
    memory.waits = false;
    memory.in_vain = -longest;
  } else {
    memory.in_vain = std::min(0.0, memory.in_vain + dt);
    memory.waits = memory.in_vain == 0.0 && ahead > parameters.group_maximum_distance;
    memory.nearest = ahead;
  }
}

bool waits(const CrowdState& crowd, const GroupMember& member) {
  return crowd.groups[crowd.handle(member.row)].waits;
}

/// The way [m] that row i makes to let row j past; nothing where it is not in its way. To the side
/// where it stands already, else across, else ahead of the other.
std::optional<Vec2> way_aside(const CrowdState& crowd, std::size_t i, std::size_t j,
                              double others_direction) {
  const Vec2 here = crowd.position(i), from_other = here - crowd.position(j);
  const double bodies = crowd.persons.radius[i] + crowd.persons.radius[j];
  if (from_other.squaredNorm() > (bodies + kPastReach) * (bodies + kPastReach)) return {};
  const Vec2 along = unit(others_direction);
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

/// Towards the middle of the others; nothing where that is where it is.
std::optional<Wish> towards_others(const CrowdState& crowd, std::span<const GroupMember> group,
                                   std::size_t i) {
  Vec2 sum = Vec2::Zero();
  for (const GroupMember& other : group) sum += crowd.position(other.row) - crowd.position(i);
  if (sum == Vec2::Zero()) return {};
  return Wish{angle_of(sum), sum.norm() / static_cast<double>(group.size()), Behaviour::kGroup};
}

/// It is the goal that changes: where it steps, and whether it can, is the model's choice.
void make_room(const CrowdState& crowd, std::span<const GroupMember> group, GroupMember& member,
               Proposals& proposals) {
  for (const GroupMember& other : group) {
    if (waits(crowd, other) || other.left <= member.left) continue;
    const auto way = way_aside(crowd, member.row, other.row, proposals.best(other.row).direction);
    if (!way) continue;
    member.steps_aside = true;
    proposals.propose(member.row, towards(*way, Behaviour::kGroup));
    return;
  }
}

}  // namespace

/// Sorted by keys and not by rows, so that the order in which people came does not matter.
void index_members(const CrowdState& crowd, std::vector<GroupMember>& members,
                   ByHandle<GroupMemory>& groups, ByHandle<ChildMemory>& children) {
  members.clear();
  if (crowd.grouped == 0) return;
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    const PersonHandle handle = crowd.handle(i);
    const std::uint64_t group = groups[handle].group;
    if (group == 0) continue;
    if (crowd.walkers[i].arrived) {
      groups[handle].waits = false;
      children[handle] = {};
      continue;
    }
    members.push_back(
        {group, crowd.persons.key[i], static_cast<std::uint32_t>(i), left_in_all(crowd, i)});
  }
  std::ranges::sort(members, by_group);
  part_ways(crowd, members);
}

void update_waits(const CrowdState& crowd, double dt, ByHandle<GroupMemory>& groups) {
  for_each_group(crowd.members, [&](std::span<const GroupMember> group) {
    double most = 0.0;
    for (const GroupMember& member : group) most = std::max(most, member.left);
    for (const GroupMember& member : group) {
      const WalkState& walker = crowd.walkers[member.row];
      // A child that is on its way to its adult, or held by it, waits for nobody else.
      const double ahead = crowd.children[walker.handle].led ? 0.0 : most - member.left;
      update_wait(groups[walker.handle], ahead, crowd.zone.parameters, patience(crowd.zone, walker),
                  dt);
    }
  });
}

void propose_room_in_groups(const CrowdState& crowd, std::vector<GroupMember>& members,
                            Proposals& proposals) {
  for_each_group(members, [&](std::span<GroupMember> group) {
    for (GroupMember& member : group) {
      if (!waits(crowd, member)) continue;
      if (const auto wish = towards_others(crowd, group, member.row)) {
        proposals.propose(member.row, *wish);
      }
      make_room(crowd, group, member, proposals);
    }
  });
}

void restrain_by_groups(const CrowdState& crowd, Restraints& restraints) {
  for (const GroupMember& member : crowd.members) {
    const std::size_t i = member.row;
    if (!waits(crowd, member) || member.steps_aside || !may_stand(crowd, i)) continue;
    // A body that still moves keeps the direction in which its way is known to be free.
    if (crowd.velocity(i).norm() < kFacingSpeed) {
      restraints.stand_facing(i, crowd.persons.goal_direction[i]);
    } else {
      restraints.stand(i);
    }
  }
}

}  // namespace pedzone
