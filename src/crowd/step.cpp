// The step: one file to see the whole loop.
#include "crowd/step.hpp"

#include <algorithm>
#include <cmath>

#include "crowd/bystanding.hpp"
#include "crowd/jams.hpp"
#include "crowd/parallel.hpp"
#include "crowd/state.hpp"
#include "crowd/vehicle_motion.hpp"

namespace pedzone {
namespace {

constexpr double kRounding = 1e-9;  // numerical: 0.3 s are three substeps, not four

/// What pedzone does not walk moves on as it is seen to move.
void move_others_on(CrowdState& crowd, double dt) {
  for (SeenPerson& person : crowd.seen) person.position += person.velocity * dt;
  for (VehicleState& vehicle : crowd.vehicles) vehicle = moved_on(vehicle, dt);
}

void walk_substep(CrowdState& crowd, double dt) {
  append_seen(crowd);
  live(crowd, dt);
  perceive(crowd, dt);
  set_goals(crowd, dt);
  gather_groups(crowd, dt);
  go_to_seats(crowd);
  dash(crowd);
  leave_claims(crowd);
  decide(crowd, dt);
  stand_still(crowd);
  wait_beside_claims(crowd);
  wait_for_groups(crowd);
  set_moves(crowd, dt);
  notice_standing(crowd, dt);
  resolve_contacts(crowd, dt);
  remember_seen(crowd, dt);
  follow_waypoints(crowd, dt);
  notice_jams(crowd, dt);
  move_others_on(crowd, dt);
  crowd.person_steps += crowd.persons.walking;
  ++crowd.substep;
  crowd.time += dt;
}

}  // namespace

void append_seen(CrowdState& crowd) {
  Persons& persons = crowd.persons;
  resize_rows(persons, persons.walking + crowd.seen.size());
  for (std::size_t k = 0; k < crowd.seen.size(); ++k) {
    const SeenPerson& person = crowd.seen[k];
    const std::size_t i = persons.walking + k;
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
        std::lerp(person.radius, persons.turned_radius[i], crowd.bystanding[k].turn);
    persons.preferred_speed[i] = person.velocity.norm();
    persons.key[i] = 0;
  }
}

void resize_rows(Persons& persons, std::size_t rows) {
  for (std::vector<double>* column : persons.numbers()) column->resize(rows);
  persons.key.resize(rows);
}

void decide(CrowdState& crowd, double dt) {
  const Snapshot snapshot{&crowd.persons,
                          crowd.vehicles,
                          &crowd.zone.walls,
                          &crowd.zone.parameters,
                          crowd.differs ? &crowd.attention : nullptr,
                          crowd.seed,
                          dt,
                          crowd.time};
  crowd.decisions.resize(crowd.persons.size());
  crowd.model->prepare(snapshot);
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    crowd.model->decide(first, last, crowd.decisions);
  });
}

void walk(CrowdState& crowd, double dt) {
  crowd.jams.clear();
  const int substeps = static_cast<int>(std::ceil(dt / kLongestSubstep - kRounding));
  for (int k = 0; k < substeps; ++k) walk_substep(crowd, dt / substeps);
  resize_rows(crowd.persons, crowd.persons.walking);
}

}  // namespace pedzone
