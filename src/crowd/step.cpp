// The step: what happens to a person in 0.1 s, on one screen. Each phase reads the crowd as it is
// and writes what stands after it among the arguments. Who wins when behaviours disagree:
// state/proposals.hpp.
#include "crowd/step.hpp"

#include <algorithm>
#include <cmath>

#include "crowd/behaviour/activities.hpp"
#include "crowd/behaviour/bystanding.hpp"
#include "crowd/behaviour/claims.hpp"
#include "crowd/behaviour/crossings.hpp"
#include "crowd/behaviour/dash.hpp"
#include "crowd/behaviour/families.hpp"
#include "crowd/behaviour/groups.hpp"
#include "crowd/behaviour/jams.hpp"
#include "crowd/behaviour/kerbs.hpp"
#include "crowd/behaviour/pace.hpp"
#include "crowd/behaviour/rears.hpp"
#include "crowd/behaviour/rounding.hpp"
#include "crowd/behaviour/stepping_aside.hpp"
#include "crowd/behaviour/way.hpp"
#include "crowd/behaviour/waypoints.hpp"
#include "crowd/free_walk.hpp"
#include "crowd/motion/contacts.hpp"
#include "crowd/motion/moves.hpp"
#include "crowd/motion/shoulders.hpp"
#include "crowd/motion/vehicle_contacts.hpp"
#include "crowd/sense/perception.hpp"
#include "crowd/sense/street_traffic.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "crowd/state/parallel.hpp"

namespace pedzone {
namespace {

constexpr int kRounds = 3;          // numerical: between vehicles, and people beside them
constexpr double kRounding = 1e-9;  // numerical: 0.3 s are three substeps, not four
constexpr double kCornerCell =
    4.0;  // [m] numerical: nobody touches anybody, but at corners they look

void find_bodies(std::span<const VehicleState> vehicles, std::vector<Rectangle>& bodies) {
  bodies.clear();
  for (const VehicleState& vehicle : vehicles) bodies.push_back(rectangle_of(vehicle));
}

/// Where vehicles are after `dt` [s] if they go on as they are seen to move.
void foresee_vehicles(std::span<const VehicleState> vehicles, double dt,
                      std::vector<VehicleState>& later) {
  later.clear();
  for (const VehicleState& vehicle : vehicles) later.push_back(moved_on(vehicle, dt));
}

Snapshot snapshot_of(const CrowdState& crowd, double dt, std::span<const VehicleState> vehicles,
                     const WallIndex& walls) {
  return {&crowd.persons,
          vehicles,
          &walls,
          &crowd.zone.parameters,
          crowd.perception_varies ? &crowd.attention : nullptr,
          crowd.seed,
          dt,
          crowd.clock.time};
}

/// Whoever is on a carriageway is between other walls, and looks after vehicles itself.
void decide_on_streets(const CrowdState& crowd, double dt, std::vector<Decision>& decisions) {
  if (crowd.zone.streets.empty()) return;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    if (crowd.is_over(i)) rows.push_back(i);
  }
  if (rows.empty()) return;
  const Snapshot snapshot = snapshot_of(crowd, dt, {}, crowd.zone.street_walls);
  WalkingModel& model = crowd.street_model != nullptr ? *crowd.street_model : *crowd.model;
  model.prepare(snapshot);
  for (const std::size_t i : rows) model.decide(i, i + 1, decisions);
}

void count(std::size_t walking, double dt, Clock& clock) {
  clock.person_steps += walking;
  ++clock.substep;
  clock.time += dt;
}

/// Whom a vehicle moves into others, these make room for. Returns whether it moved anybody.
bool keep_apart_from_vehicles(const CrowdState& crowd, double dt, std::vector<WalkState>& walkers,
                              Moves& moves, std::vector<VehiclePush>& pushes) {
  const bool any = keep_out_of_vehicles(crowd, dt, moves, pushes);
  bool moved = any;
  for (int round = 0; round < kRounds && moved && settle_cores(crowd, walkers, moves); ++round) {
    moved = keep_out_of_vehicles(crowd, dt, moves, pushes);
  }
  return any;
}

void walk_substep(CrowdState& crowd, double dt) {
  append_seen(crowd, crowd.persons);
  foresee_vehicles(crowd.vehicles, dt, crowd.vehicles_later);
  find_bodies(crowd.vehicles, crowd.vehicle_bodies);
  find_bodies(crowd.vehicles_later, crowd.bodies_later);

  // What each does and remembers, before it looks where to go.
  carry_on_activities(crowd, dt, crowd.activities);
  begin_dashes(crowd, dt, crowd.activities);
  set_paces(crowd, crowd.persons.preferred_speed);
  crowd.perception_varies = perceives_otherwise(crowd);
  if (crowd.perception_varies)
    perceive(crowd, crowd.clock.time + dt, crowd.traffic, crowd.attention);
  observe_streets(crowd.zone.streets, crowd.vehicles, dt, crowd.street_traffic);
  index_members(crowd, crowd.members, crowd.groups, crowd.children);
  guide_children(crowd, dt, crowd.children);
  update_waits(crowd, dt, crowd.groups);

  cross_streets(crowd, dt, crowd.ways(), crowd.crossings_begun);
  look_at_kerbs(crowd, dt, crowd.kerbs);
  order_claims(crowd, crowd.claimants);

  // Every behaviour proposes; the most important one wins.
  Proposals& proposals = crowd.proposals;
  proposals.begin(crowd.persons.walking);
  propose_way(crowd, dt, crowd.walkers, proposals);
  propose_ways_to_adults(crowd, proposals);
  propose_room_in_groups(crowd, crowd.members, proposals);
  propose_seats(crowd, proposals);
  propose_ways_round_vehicles(crowd, proposals);
  propose_dashes(crowd, proposals, crowd.attention);
  propose_ways_out_of_claims(crowd, proposals);
  propose_crossings(crowd, proposals);
  resolve(proposals, crowd.persons);

  // The model decides; behaviours hold people back.
  decide(crowd, dt, crowd.vehicles, crowd.decisions);
  decide_on_streets(crowd, dt, crowd.decisions);
  Restraints& restraints = crowd.restraints;
  restraints.begin(crowd.persons.walking);
  restrain_by_activity(crowd, restraints);
  restrain_beside_claims(crowd, restraints);
  restrain_beside_rears(crowd, restraints);
  restrain_by_groups(crowd, restraints);
  restrain_adults(crowd, restraints);
  restrain_at_kerbs(crowd, restraints);
  restrain_crossings(crowd, restraints);
  restraints.apply(crowd.decisions);
  step_aside(crowd, crowd.decisions);
  lead_by_hand(crowd, crowd.decisions);

  // Bodies move, and settle their contacts.
  set_moves(crowd, dt, crowd.walkers, crowd.persons, crowd.moves);
  notice_standing(crowd, dt, crowd.standing, crowd.moves.reach);
  find_neighbours(crowd, crowd.grid, crowd.near);
  make_room(crowd, dt, crowd.standing.passed, crowd.seen_memory, crowd.moves);
  hold_shoulders(crowd, dt, crowd.walkers, crowd.next_radius, crowd.persons);
  move_freely(crowd, crowd.walkers, crowd.moves);
  settle_contacts(crowd, crowd.walkers, crowd.moves);
  if (crowd.solid_vehicles &&
      keep_apart_from_vehicles(crowd, dt, crowd.walkers, crowd.moves, crowd.pushes)) {
    crowd.kept_out = true;
  }
  commit(crowd, crowd.walkers, crowd.persons, crowd.moves);

  // What has come of it.
  remember_seen(crowd, dt, crowd.seen_memory);
  follow_waypoints(crowd, dt, 1, crowd.ways());
  notice_jams(crowd, dt, crowd.jams, crowd.jam_notices);
  for (SeenPerson& person : crowd.seen) person.position += person.velocity * dt;
  crowd.vehicles.swap(crowd.vehicles_later);
  count(crowd.persons.walking, dt, crowd.clock);
}

/// Those who walk freely walk the whole step at once; the others see them walk meanwhile.
void walk_free(CrowdState& crowd, double dt, std::uint64_t substeps) {
  append_seen(crowd, crowd.persons);
  const std::size_t all = crowd.persons.walking, free = gather_free(crowd, dt);
  if (free == 0) return;
  crowd.persons.walking = free;
  crowd.others = all - free;

  set_paces(crowd, crowd.persons.preferred_speed);
  crowd.perception_varies = perceives_otherwise(crowd);
  if (crowd.perception_varies) set_perceptions(crowd, crowd.attention);
  crowd.proposals.begin(free);
  propose_way(crowd, dt, crowd.walkers, crowd.proposals);
  resolve(crowd.proposals, crowd.persons);
  decide(crowd, dt, {}, crowd.decisions);
  set_moves(crowd, dt, crowd.walkers, crowd.persons, crowd.moves);
  crowd.grid.build(crowd.persons.x, crowd.persons.y, kCornerCell);
  move_freely(crowd, crowd.walkers, crowd.moves);
  commit(crowd, crowd.walkers, crowd.persons, crowd.moves);
  follow_waypoints(crowd, dt, substeps, crowd.ways());
  forget_neighbours(crowd, crowd.near);
  notice_jams(crowd, dt, crowd.jams, crowd.jam_notices);

  crowd.clock.person_steps += free * substeps;
  set_apart(crowd, free, dt, crowd.free_walk_ends);
}

}  // namespace

void append_seen(const CrowdState& crowd, Persons& persons) {
  resize_rows(persons, crowd.first_seen() + crowd.seen.size());
  for (std::size_t k = 0; k < crowd.seen.size(); ++k) {
    const SeenPerson& person = crowd.seen[k];
    const std::size_t i = crowd.first_seen() + k;
    const Vec2 place = own_place(crowd, k);
    persons.x[i] = place.x();
    persons.y[i] = place.y();
    persons.vx[i] = person.velocity.x();
    persons.vy[i] = person.velocity.y();
    persons.heading[i] = persons.goal_direction[i] =
        person.velocity.isZero() ? wrap_angle(person.heading) : angle_of(person.velocity);
    persons.goal_distance[i] = 0.0;
    persons.radius[i] = person.radius;
    persons.turned_radius[i] =
        (person.turns ? crowd.zone.parameters.turned_width : 1.0) * person.radius;
    persons.present_radius[i] =
        std::lerp(person.radius, persons.turned_radius[i], crowd.seen_memory[k].turn);
    persons.preferred_speed[i] = person.velocity.norm();
    persons.key[i] = 0;
  }
}

void resize_rows(Persons& persons, std::size_t rows) {
  for (std::vector<double>* column : persons.numbers()) column->resize(rows);
  persons.key.resize(rows);
}

void decide(const CrowdState& crowd, double dt, std::span<const VehicleState> vehicles,
            std::vector<Decision>& decisions) {
  decisions.resize(crowd.persons.size());
  if (crowd.persons.walking == 0) return;
  crowd.model->prepare(snapshot_of(crowd, dt, vehicles, crowd.zone.walls));
  for_each_block(
      crowd.persons.walking,
      [&](std::size_t, std::size_t first, std::size_t last) {
        crowd.model->decide(first, last, decisions);
      },
      Work::kDecision);
}

void walk(CrowdState& crowd, double dt) {
  crowd.jam_notices.clear();
  crowd.pushes.clear();
  crowd.free_walk_ends.clear();
  crowd.crossings_begun.clear();
  const int substeps = static_cast<int>(std::ceil(dt / kLongestSubstep - kRounding));
  // Nobody is there to mind anything.
  if (crowd.persons.walking == 0 && crowd.seen.empty() && crowd.zone.streets.empty()) {
    for (VehicleState& vehicle : crowd.vehicles) vehicle = moved_on(vehicle, dt);
    for (int k = 0; k < substeps; ++k) count(0, dt / substeps, crowd.clock);
    return;
  }
  crowd.vehicles_near.build(crowd.vehicles, crowd.persons, dt);
  // A model that sets velocities is made for short steps.
  if (substeps > 1 && !crowd.model->sets_velocity()) {
    walk_free(crowd, dt, static_cast<std::uint64_t>(substeps));
  }
  for (int k = 0; k < substeps; ++k) walk_substep(crowd, dt / substeps);
  take_back(crowd, crowd.free_walk_ends);
  resize_rows(crowd.persons, crowd.persons.walking);
}

}  // namespace pedzone
