// A child is never told to wait for the group: it follows its adult, who is. The paper has no
// families; "a child under five walks with an adult" is what this is for.
#include "crowd/behaviour/families.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "crowd/behaviour/groups.hpp"
#include "crowd/sense/danger.hpp"
#include "model/making_way.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kClose = 1.5;       // [m] assumed: farther from its adult, a child goes to it
constexpr double kVehicleNear = 10;  // [m] assumed: a vehicle this near is a reason for the hand
constexpr double kAhead = 5.0;       // [s] assumed: ... also if it is not there before. With less
                                     // the two give way to different sides before they hold hands
constexpr double kCalm = 2.0;        // [s] assumed: after so long without one it is let go
constexpr double kArm = 0.7;        // [m] assumed: a hand is taken over this gap between bodies ...
constexpr double kTorn = 1.5;       // [m] ... and lost over this one
constexpr double kBesideGap = 0.1;  // [m] assumed: gap between the bodies hand in hand
constexpr double kTug = 1.0;        // [s] assumed: in which the hand brings the child to its place
constexpr double kLead = 0.5;       // [s] assumed: a child goes to where its adult will be then
constexpr double kOtherSide = 1.0;  // [m] assumed: so far aside a vehicle makes them change sides
constexpr double kHandShare = 0.9;  // assumed: of the child's speed, so that it keeps up
constexpr double kCatchUpShare = 0.5;      // assumed: while the child is behind
constexpr double kLastMomentMargin = 0.1;  // [m] numerical
constexpr double kRound = kPi / 3.0;       // [rad] numerical: of the way round the adult at a time

Vec2 facing(const CrowdState& crowd, std::size_t i) { return unit(crowd.persons.heading[i]); }

/// The adult with whom the child went until now, or else the nearest: who has let a child walk
/// beside it is not left for another who comes by. One adult may have several children.
const GroupMember* adult_of(const CrowdState& crowd, std::span<const GroupMember> group,
                            std::size_t child) {
  const GroupMember* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const GroupMember& member : group) {
    if (goes_with_adult(crowd.walkers[member.row].profile)) continue;
    if (member.key == crowd.children[crowd.handle(child)].adult) return &member;
    const double squared = (crowd.position(member.row) - crowd.position(child)).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    best = &member;
  }
  return best;
}

/// Gap [m] between two bodies.
double gap(const CrowdState& crowd, std::size_t i, std::size_t j) {
  return (crowd.position(i) - crowd.position(j)).norm() - crowd.persons.radius[i] -
         crowd.persons.radius[j];
}

/// 1: the point is to the left of where row i faces, -1: to the right.
double side_of(const CrowdState& crowd, std::size_t i, const Vec2& point) {
  return cross(facing(crowd, i), point - crowd.position(i)) < 0.0 ? -1.0 : 1.0;
}

/// Away from the vehicle. One that is almost straight ahead or behind is no reason to change.
void choose_side(const CrowdState& crowd, std::size_t adult, const VehicleState& vehicle,
                 ChildMemory& child) {
  const double lateral = cross(facing(crowd, adult), vehicle.centre - crowd.position(adult));
  if (std::abs(lateral) > kOtherSide) child.hand_side = lateral > 0.0 ? -1.0 : 1.0;
}

/// Takes the hand while a vehicle drives near the child, and lets it go some time after.
void update_hand(const CrowdState& crowd, std::size_t i, std::size_t adult, double dt,
                 ChildMemory& child) {
  const VehicleState* vehicle = moving_near(crowd, crowd.position(i), kVehicleNear, kAhead);
  const double apart = gap(crowd, i, adult);
  child.calm = vehicle != nullptr ? 0.0 : child.calm + dt;
  child.awaited = vehicle != nullptr && !child.holds_hand ? child.awaited + dt : 0.0;
  if (child.calm > kCalm || apart > kTorn) child.holds_hand = false;
  if (vehicle == nullptr) return;
  if (!child.holds_hand && apart <= kArm) {
    child.holds_hand = true;
    child.hand_side = side_of(crowd, adult, crowd.position(i));
  }
  if (child.holds_hand) choose_side(crowd, adult, *vehicle, child);
}

/// Beside the adult, on the side where the child is.
Vec2 near_side(const CrowdState& crowd, std::size_t i, std::size_t adult) {
  const double aside = crowd.persons.radius[i] + crowd.persons.radius[adult] + kBesideGap;
  const double side = side_of(crowd, adult, crowd.position(i));
  return crowd.position(adult) + kLead * crowd.velocity(adult) +
         side * aside * left_of(facing(crowd, adult));
}

/// Where the hand leads the child next: to the adult's side, round behind it where the child is on
/// the other one, and behind it where a wall leaves no room at that side.
Vec2 hand_place(const CrowdState& crowd, std::size_t i, std::size_t adult) {
  const double reach = crowd.persons.radius[i] + crowd.persons.radius[adult] + kBesideGap;
  const double heading = crowd.persons.heading[adult],
               side = crowd.children[crowd.handle(i)].hand_side;
  const Vec2 centre = crowd.position(adult);
  const auto place = [&](double angle) -> Vec2 {
    return centre + reach * unit(heading + side * angle);
  };
  // Angles about the adult, from its heading towards the side it wants.
  double angle = side * wrap_angle(angle_of(crowd.position(i) - centre) - heading);
  if (angle < -0.25 * kPi) angle += 2.0 * kPi;  // across its front only where nearly there
  const double room = 0.5 * crowd.persons.radius[i];
  const bool fits = crowd.zone.walls.free_line(centre, place(0.5 * kPi), room);
  const double wanted = fits ? 0.5 * kPi : kPi;
  return place(angle + std::clamp(wanted - angle, -kRound, kRound));
}

/// The child goes where its adult does: not by its own choice, which knows nothing of hands and
/// keeps clear of the adult, but for the last-moment guard before vehicles. Out of the room that a
/// held-up vehicle claims it goes with the adult, too, or the vehicle would drive between them.
void pull(const CrowdState& crowd, std::size_t i, std::size_t adult,
          std::vector<Decision>& decisions) {
  if (is_swept(crowd, i, kLastMomentMargin, kLastMoment)) return;
  const Vec2 wanted =
      crowd.velocity(adult) + (hand_place(crowd, i, adult) - crowd.position(i)) / kTug;
  const double speed = wanted.norm();
  Decision& decision = decisions[i];
  decision.direction = speed > kHaltingSpeed ? angle_of(wanted) : crowd.persons.heading[adult];
  decision.speed = speed > kHaltingSpeed ? std::min(speed, crowd.persons.preferred_speed[i]) : 0.0;
  decision.free_distance = crowd.zone.parameters.sight;  // bodies and walls stop it on contact
  decision.waits = decisions[adult].waits;
}

/// Whether the adult stands until the child has come to its hand. Where the child cannot, no longer
/// than its patience.
bool awaits_hand(const CrowdState& crowd, std::size_t child, std::size_t adult) {
  const ChildMemory& memory = crowd.children[crowd.handle(child)];
  return memory.led && !memory.holds_hand && memory.awaited > 0.0 &&
         memory.awaited < patience(crowd.zone, crowd.walkers[adult]) && may_stand(crowd, adult);
}

/// To 0 only for a hand that is wanted: an adult whose child cannot move waits for it as for
/// anybody else of the group.
void slow_down(const CrowdState& crowd, const GroupMember& child, const GroupMember& adult,
               Restraints& restraints) {
  if (is_swept(crowd, adult.row, kLastMomentMargin, kLastMoment)) return;
  const double apart = (crowd.position(child.row) - crowd.position(adult.row)).norm();
  const bool behind = apart > kClose && child.left > adult.left;
  const bool by_the_hand = crowd.children[crowd.handle(child.row)].holds_hand;
  const double share = awaits_hand(crowd, child.row, adult.row) ? 0.0
                       : behind                                 ? kCatchUpShare
                       : by_the_hand                            ? kHandShare
                                                                : 1.0;
  restraints.limit(adult.row, share * crowd.persons.preferred_speed[child.row]);
}

const GroupMember* find_member(std::span<const GroupMember> group, std::uint64_t key) {
  const auto found = std::find_if(group.begin(), group.end(),
                                  [&](const GroupMember& member) { return member.key == key; });
  return found != group.end() ? &*found : nullptr;
}

/// Calls what(child, adult) for all children that go with an adult.
template <class What>
void for_each_child(const CrowdState& crowd, const What& what) {
  for_each_group(crowd.members, [&](std::span<const GroupMember> group) {
    for (const GroupMember& member : group) {
      const std::uint64_t key = crowd.children[crowd.handle(member.row)].adult;
      const GroupMember* const adult = key == 0 ? nullptr : find_member(group, key);
      if (adult != nullptr) what(member, *adult);
    }
  });
}

/// Who leads the child at present, whether by the hand, and whether to its side.
void guide(const CrowdState& crowd, std::span<const GroupMember> group, std::size_t i, double dt,
           ChildMemory& child) {
  const GroupMember* const adult = adult_of(crowd, group, i);
  if (adult == nullptr || adult->key != child.adult) child = {};
  if (adult == nullptr) return;
  child.adult = adult->key;
  update_hand(crowd, i, adult->row, dt, child);
  const Vec2 here = crowd.position(i), there = crowd.position(adult->row);
  const bool far = (there - here).norm() > kClose || child.calm == 0.0;
  // Whose adult is out of sight goes its own way, which leads to the same place.
  child.led = child.holds_hand || (far && crowd.zone.walls.free_line(here, there));
}

}  // namespace

bool goes_with_adult(const Profile* profile) {
  return profile != nullptr && (profile->guarded > 0.0 || profile->id == "child");
}

void guide_children(const CrowdState& crowd, double dt, ByHandle<ChildMemory>& children) {
  for_each_group(crowd.members, [&](std::span<const GroupMember> group) {
    for (const GroupMember& member : group) {
      if (!goes_with_adult(crowd.walkers[member.row].profile)) continue;
      guide(crowd, group, member.row, dt, children[crowd.handle(member.row)]);
    }
  });
}

void propose_ways_to_adults(const CrowdState& crowd, Proposals& proposals) {
  for_each_child(crowd, [&](const GroupMember& child, const GroupMember& adult) {
    if (!crowd.children[crowd.handle(child.row)].led) return;
    const Vec2 way = near_side(crowd, child.row, adult.row) - crowd.position(child.row);
    proposals.propose(child.row, towards(way, Behaviour::kChild));
  });
}

void restrain_adults(const CrowdState& crowd, Restraints& restraints) {
  for_each_child(crowd, [&](const GroupMember& child, const GroupMember& adult) {
    slow_down(crowd, child, adult, restraints);
  });
}

void lead_by_hand(const CrowdState& crowd, std::vector<Decision>& decisions) {
  for_each_child(crowd, [&](const GroupMember& child, const GroupMember& adult) {
    if (!crowd.children[crowd.handle(child.row)].holds_hand) return;
    pull(crowd, child.row, adult.row, decisions);
  });
}

}  // namespace pedzone
