// Everything a crowd holds.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "crowd/body_grid.hpp"
#include "crowd/bystanding.hpp"
#include "crowd/crowd.hpp"
#include "crowd/groups.hpp"
#include "crowd/route.hpp"
#include "crowd/wall_guard.hpp"

namespace pedzone {

/// A vehicle that a person has perceived.
struct Noticed {
  std::uint64_t vehicle = 0;       ///< its key
  double since = 0.0, last = 0.0;  ///< [s] on the crowd's clock
  bool warned = false;             ///< it has sounded its horn
  bool minds = false;              ///< gives way to it at present
  bool near = false;               ///< so near that nobody stands and chats before it
};

/// The user's waypoints of a person. While it has them, its route leads to the current one.
struct PathWalk {
  std::vector<Waypoint> waypoints;
  std::size_t next = 0;     ///< the current one
  Destination destination;  ///< after the last
};

/// Somebody who does not get on among people.
struct Jam {
  float least_left = std::numeric_limits<float>::infinity();  ///< [m] least way left so far
  float stuck = 0.0F;                                         ///< [s] without room since that was
  float squeezed = 0.0F;  ///< [s] since it began to squeeze; 0: it does not
  float free = 0.0F;      ///< [s] since it last lacked room

  bool squeezes() const { return squeezed > 0.0F; }
};

/// What a walked person holds beside its row in Persons: its way and its clocks.
struct WalkState {
  Crowd::Handle handle = 0;
  Route route;
  std::unique_ptr<PathWalk> path;  ///< null: none, or all its waypoints are behind it
  double noise = 0.0;              ///< [rad] variation of the goal direction
  WallRoom wall_room;              ///< around where the person is
  double least_left = std::numeric_limits<double>::infinity();  ///< [m] least way left so far
  double blocked = 0.0;                                         ///< [s] since that was
  Jam jam;
  double slow = 0.0;          ///< [s] since the person was last faster than standing
  std::uint64_t planned = 0;  ///< substep of the last plan
  const Profile* profile = nullptr;
  std::uint64_t group = 0;                 ///< 0: alone
  std::array<float, kActivities> rates{};  ///< [1/min]
  double own_speed = 1.34;                 ///< [m/s] preferred, but for activity and weather
  std::vector<Noticed> noticed;
  std::int32_t seat = -1;    ///< index in Zone::seats of where it sits, or goes to; -1: where it is
  double dash = 0.0;         ///< [s] that it still runs in front of a vehicle
  double group_clock = 0.0;  ///< [s] waiting for the group in vain; below 0: goes on
  double group_least = 0.0;  ///< [m] nearest that the last one has come meanwhile
  std::uint64_t guardian = 0;  ///< key of the adult that a child goes with
  double calm = 0.0;           ///< [s] since a vehicle drove near the child
  double awaited = 0.0;        ///< [s] since the adult began to wait for the child's hand
  double hand_side = 1.0;      ///< 1: at the adult's left hand, -1: at its right
  float full_radius = 0.24F;   ///< [m] of the body while it does not squeeze
  float turned_width = 0.5F;   ///< with the shoulders turned, over the full width
  Activity activity = Activity::kNone;
  bool aware = true;  ///< of vehicles
  bool waits_for_group = false;
  bool led = false;         ///< a child on its way to its adult, or by its hand
  bool holds_hand = false;  ///< of its adult
  bool entered = false;     ///< has been within the radius of the current waypoint
  bool waits = false;       ///< for a vehicle
  bool new_here = true;     ///< has not been walked yet
  bool pressed = false;     ///< others kept it from moving as it meant to in the last substep
  bool arrived = false, gave_up = false;
};

/// [s] blocked for so long, the person goes on elsewhere.
inline double patience(const Zone& zone, const WalkState& walker) {
  return walker.profile != nullptr ? walker.profile->patience : zone.parameters.patience;
}

/// The motion of all bodies within one substep, in the order of Persons.
struct Moves {
  std::vector<double> dx, dy;          ///< [m] displacement that each body means to make
  std::vector<double> x, y;            ///< [m] where it gets to, as far as that is known
  std::vector<double> next_x, next_y;  ///< [m] the same after one more pass over the contacts
  double reach = 0.0;                  ///< [m] longest displacement
};

/// What one block of persons works with; no two blocks share it.
struct BlockScratch {
  std::vector<std::uint32_t> neighbours;  ///< of the block's persons, one after the other
  std::vector<std::uint32_t> walls;
  bool touching = false;  ///< somebody of the block was pushed in the last pass
};

/// A person that a vehicle may reach within the substep.
struct VehicleHit {
  std::uint32_t person, vehicle;
};

struct CrowdState {
  CrowdState(const Zone& its_zone, std::uint64_t its_seed, std::unique_ptr<WalkingModel> its_model)
      : zone(its_zone), seed(its_seed), model(std::move(its_model)) {}

  const Zone& zone;
  std::uint64_t seed;
  std::unique_ptr<WalkingModel> model;

  Persons persons;                    ///< those pedzone walks, then, within a step, the seen
  std::vector<WalkState> walkers;     ///< of the first persons.walking rows
  std::vector<std::uint32_t> row;     ///< of each handle
  std::vector<Crowd::Handle> unused;  ///< handles to give out again
  std::vector<SeenPerson> seen;       ///< by key
  std::vector<Bystanding> bystanding, bystanding_before;  ///< of each of them; and of those before
  std::vector<std::uint8_t> stands;    ///< of all, 1: not because others hold it up
  std::vector<std::uint8_t> passed;    ///< of the walked, 1: stands so, and somebody goes past
  bool somebody_stands = false;        ///< of all
  std::vector<GroupMember> members;    ///< of groups, by group and key
  std::size_t grouped = 0;             ///< how many walkers have a group
  std::vector<VehicleState> vehicles;  ///< as they are in this substep; after a step, at its end

  double clock = 0.0;    ///< [s] walked so far
  Attention attention;   ///< of this substep, where people differ
  bool differs = false;  ///< they do

  std::vector<Decision> decisions;
  Moves moves;
  BodyGrid grid;
  std::vector<BlockScratch> blocks;
  std::vector<std::uint32_t> first_neighbour, last_neighbour;  ///< in the list of one's block
  std::vector<VehicleHit> hits;
  std::vector<JamNotice> jams;      ///< begun in this step
  std::vector<double> next_radius;  ///< [m] of each walked person's body, while it is found

  std::uint64_t substep = 0;  ///< number of substeps so far: a key of random numbers
  double time = 0.0;          ///< [s] of all substeps so far
  std::uint64_t person_steps = 0;

  /// Bodies that person i of that block may touch within the substep.
  std::span<const std::uint32_t> neighbours_of(std::size_t block, std::size_t i) const {
    const std::uint32_t* const list = blocks[block].neighbours.data();
    return {list + first_neighbour[i], list + last_neighbour[i]};
  }
  Vec2 position(std::size_t i) const { return {persons.x[i], persons.y[i]}; }
  Vec2 velocity(std::size_t i) const { return {persons.vx[i], persons.vy[i]}; }
};

/// [s] assumed: so long slower than walking, a person stands.
constexpr double kStandingTime = 1.0;

/// Substeps are at most this long [s].
constexpr double kLongestSubstep = 0.1;

// The phases of a substep of `dt` [s], in their order (step.cpp).
void live(CrowdState& crowd, double dt);              // activities.cpp
void perceive(CrowdState& crowd, double dt);          // perception.cpp
void set_goals(CrowdState& crowd, double dt);         // goals.cpp
void gather_groups(CrowdState& crowd, double dt);     // groups.cpp
void go_to_seats(CrowdState& crowd);                  // activities.cpp
void dash(CrowdState& crowd);                         // activities.cpp
void set_goal(CrowdState& crowd, std::size_t i);      // goals.cpp: of one, as it varies now
void leave_claims(CrowdState& crowd);                 // claims.cpp
void decide(CrowdState& crowd, double dt);            // step.cpp
void stand_still(CrowdState& crowd);                  // activities.cpp
void wait_beside_claims(CrowdState& crowd);           // claims.cpp
void wait_for_groups(CrowdState& crowd);              // groups.cpp
void set_moves(CrowdState& crowd, double dt);         // moves.cpp
void resolve_contacts(CrowdState& crowd, double dt);  // contacts.cpp
void follow_waypoints(CrowdState& crowd, double dt);  // waypoints.cpp

}  // namespace pedzone
