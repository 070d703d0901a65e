// Everything a crowd holds. The step (step.cpp) tells which phase writes what.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "crowd/state/body_grid.hpp"
#include "crowd/state/memory.hpp"
#include "crowd/state/person.hpp"
#include "crowd/state/proposals.hpp"
#include "crowd/state/restraints.hpp"
#include "crowd/state/route.hpp"
#include "crowd/state/street_traffic.hpp"
#include "crowd/state/vehicles_near.hpp"
#include "crowd/state/wall_guard.hpp"
#include "geometry/rectangle.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// What a walked person holds beside its row in Persons: its way, and how it gets on.
struct WalkState {
  PersonHandle handle = 0;
  const Profile* profile = nullptr;
  Route route;
  WallRoom wall_room;          ///< around where the person is
  double heading_noise = 0.0;  ///< [rad] variation of the goal direction
  double least_left = std::numeric_limits<double>::infinity();  ///< [m] least way left so far
  double blocked = 0.0;                                         ///< [s] since that was
  double standing = 0.0;      ///< [s] since the person was last faster than standing
  std::uint64_t planned = 0;  ///< substep of the last plan
  double own_speed = 1.34;    ///< [m/s] preferred, but for activity and weather
  float full_radius = 0.24F;  ///< [m] of the body while it does not squeeze
  float turned_width = 0.5F;  ///< with the shoulders turned, over the full width
  std::uint32_t hiding = 0;   ///< wall that hid the waypoint after the next one last time
  bool entered = false;       ///< has been within the radius of the current waypoint
  bool waits = false;         ///< for a vehicle
  bool new_here = true;       ///< has not been walked yet
  bool pressed = false;       ///< others kept it from moving as it meant to in the last substep
  bool arrived = false, gave_up = false;

  /// A new way begins: what was counted on the last one does not hold.
  void start_clocks() {
    least_left = std::numeric_limits<double>::infinity();
    blocked = 0.0;
  }
};

/// A person that a vehicle may reach within the substep.
struct VehicleHit {
  std::uint32_t person, vehicle;
};

/// The moves of all bodies within one substep, in the order of Persons.
struct Moves {
  std::vector<double> dx, dy;          ///< [m] displacement that each body means to make
  std::vector<double> x, y;            ///< [m] where it gets to, as far as that is known
  std::vector<double> next_x, next_y;  ///< [m] the same after one more pass over the contacts
  std::vector<double> by_vehicles;     ///< [m] by which vehicles have moved it in this substep
  std::vector<VehicleHit> hits;        ///< by person, of the last look at vehicles
  double reach = 0.0;                  ///< [m] longest displacement
};

/// Who stands by its own choice, and not because others hold it up.
struct Standing {
  std::vector<std::uint8_t> stands;  ///< of all, 1: stands so
  std::vector<std::uint8_t> passed;  ///< of the walked, 1: stands so, and somebody goes past
  bool anybody = false;
};

/// Which bodies may touch within a substep.
struct Neighbourhood {
  /// Of each block of persons (parallel.hpp), of one person after the other.
  std::vector<std::vector<std::uint32_t>> lists;
  std::vector<std::uint32_t> first, last;  ///< of each walked person, in the list of its block

  /// Bodies that person i of that block may touch.
  std::span<const std::uint32_t> of(std::size_t block, std::size_t i) const {
    const std::uint32_t* const list = lists[block].data();
    return {list + first[i], list + last[i]};
  }
};

/// A person of a group that is still under way.
struct GroupMember {
  std::uint64_t group = 0, key = 0;  ///< what members are sorted by
  std::uint32_t row = 0;
  double left = 0.0;         ///< [m] D: way left to its destination
  bool steps_aside = false;  ///< waits, but is in the way of a member behind it
};

/// Where somebody is after the step, whom the others see walk there meanwhile.
struct FreeWalkEnd {
  PersonHandle handle = 0;
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
};

/// How far a crowd has come: its one clock.
struct Clock {
  double time = 0.0;               ///< [s] of all substeps so far
  std::uint64_t substep = 0;       ///< their number: a key of random numbers
  std::uint64_t person_steps = 0;  ///< substeps of all persons, added up
};

/// What those write who plan ways and follow them. To plan a way starts its clocks, and those of
/// jams, anew; it sets the goal at once.
struct Ways {
  std::vector<WalkState>& walkers;
  ByHandle<PathMemory>& paths;
  ByHandle<CrossingMemory>& crossings;
  ByHandle<JamMemory>& jams;
  Persons& persons;

  /// The street that row i has to cross: it has one.
  StreetCrossing& crossing(std::size_t i) { return *crossings[walkers[i].handle].now; }
};

struct CrowdState {
  CrowdState(const Zone& its_zone, std::uint64_t its_seed, std::unique_ptr<WalkingModel> its_model)
      : zone(its_zone), seed(its_seed), model(std::move(its_model)) {}

  const Zone& zone;
  std::uint64_t seed;
  std::unique_ptr<WalkingModel> model;
  std::unique_ptr<WalkingModel> street_model;  ///< of who crosses a street; null: the same

  // Who is there. Rows: those pedzone walks; within a step, then those of ours that walk the whole
  // of it at once (free_walk.hpp), and those it only sees.
  Persons persons;
  std::size_t others = 0;                            ///< of ours, not walked at present
  std::vector<WalkState> walkers;                    ///< of the first persons.walking rows
  std::vector<std::uint32_t> row;                    ///< of each handle
  std::vector<PersonHandle> unused;                  ///< handles to give out again
  std::vector<SeenPerson> seen;                      ///< by key
  std::vector<SeenMemory> seen_memory, seen_before;  ///< of each of them; and of those before
  std::vector<VehicleState> vehicles;  ///< as they are in this substep; after a step, at its end

  // What behaviours remember.
  ByHandle<TrafficMemory> traffic;
  ByHandle<ActivityMemory> activities;
  ByHandle<GroupMemory> groups;
  ByHandle<ChildMemory> children;
  ByHandle<PathMemory> paths;
  ByHandle<JamMemory> jams;
  ByHandle<CrossingMemory> crossings;  ///< empty where the zone has no streets to cross
  ByHandle<KerbMemory> kerbs;          ///< empty where the zone has no crosswalks
  std::size_t grouped = 0;             ///< how many walkers have a group

  Clock clock;

  VehiclesNear vehicles_near;  ///< made anew in every step

  // Made anew in every substep, each by one phase.
  std::vector<VehicleState> vehicles_later;             ///< as they are at its end
  std::vector<Rectangle> vehicle_bodies, bodies_later;  ///< of each vehicle, at its begin and end
  Attention attention;                   ///< where people differ in what they perceive
  bool perception_varies = false;        ///< they do
  std::vector<std::uint32_t> claimants;  ///< vehicles that claim room, those first that come first
  std::vector<GroupMember> members;      ///< of groups, by group and key
  Proposals proposals;
  std::vector<Decision> decisions;
  Restraints restraints;
  Moves moves;
  Standing standing;
  BodyGrid grid;
  Neighbourhood near;
  std::vector<double> next_radius;          ///< [m] of each walked person's body, while it is found
  std::vector<FreeWalkEnd> free_walk_ends;  ///< of this step
  std::vector<JamNotice> jam_notices;       ///< begun in this step
  std::vector<VehiclePush> pushes;          ///< of this step, by person and vehicle
  std::vector<CrossingBegun> crossings_begun;  ///< in this step
  std::vector<StreetTraffic> street_traffic;   ///< of each of the zone's streets
  bool solid_vehicles = true;                  ///< bodies are kept out of vehicles
  bool kept_out = false;                       ///< one ever was

  Ways ways() { return {walkers, paths, crossings, jams, persons}; }

  /// Row of the first of crowd.seen.
  std::size_t first_seen() const { return persons.walking + others; }
  Vec2 position(std::size_t i) const { return {persons.x[i], persons.y[i]}; }
  Vec2 velocity(std::size_t i) const { return {persons.vx[i], persons.vy[i]}; }
  PersonHandle handle(std::size_t i) const { return walkers[i].handle; }
  /// The street that row i may cross; null: none.
  const StreetCrossing* crossing(std::size_t i) const {
    return zone.streets.empty() ? nullptr : crossings[handle(i)].now.get();
  }
  /// Whether row i is on a carriageway between the junctions.
  bool is_over(std::size_t i) const {
    const StreetCrossing* const street = crossing(i);
    return street != nullptr && street->phase == CrossingPhase::kOver;
  }
  /// What keeps row i inside: for who crosses a street its kerbs are none.
  const WallIndex& walls_of(std::size_t i) const {
    return is_over(i) ? zone.street_walls : zone.walls;
  }
};

/// [s] assumed: so long slower than walking, a person stands.
constexpr double kStandingTime = 1.0;

/// [m/s] fastest preferred speed, as Persons::preferred_speed.
constexpr double kMostSpeed = 5.0;

/// Substeps are at most this long [s].
constexpr double kLongestSubstep = 0.1;

/// [s] blocked for so long, the person goes on elsewhere.
inline double patience(const Zone& zone, const WalkState& walker) {
  return walker.profile != nullptr ? walker.profile->patience : zone.parameters.patience;
}

}  // namespace pedzone
