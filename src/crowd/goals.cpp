// Phase 1: where each person wants to go, with the small variation of its heading.
#include <cmath>

#include "core/random.hpp"
#include "crowd/parallel.hpp"
#include "crowd/state.hpp"

namespace pedzone {
namespace {

/// One step of an Ornstein–Uhlenbeck process, exact for any step length: stationary standard
/// deviation `deviation`, correlation time `time`.
struct Variation {
  double keep, add;

  Variation(double deviation, double time, double dt)
      : keep(std::exp(-dt / time)), add(deviation * std::sqrt(1.0 - keep * keep)) {}
};

}  // namespace

void set_goal(CrowdState& crowd, std::size_t i) {
  Persons& persons = crowd.persons;
  const WalkState& walker = crowd.walkers[i];
  if (walker.arrived) {
    persons.goal_direction[i] = persons.heading[i];
    persons.goal_distance[i] = 0.0;
    return;
  }
  const Vec2 to_goal = heading_point(walker.route, crowd.position(i)) - crowd.position(i);
  persons.goal_direction[i] =
      wrap_angle(angle_of(to_goal) + walker.noise * info_of(walker.activity).noise);
  persons.goal_distance[i] = to_goal.norm();
}

/// The variation turns the goal and not the movement: what the person then chooses is checked
/// for contacts like any other direction, so the noise carries nobody into anything.
void set_goals(CrowdState& crowd, double dt) {
  const Parameters& parameters = crowd.zone.parameters;
  const double deviation = parameters.heading_noise * kPi / 180.0;
  const Variation variation(deviation, parameters.heading_noise_time, dt);
  Persons& persons = crowd.persons;
  for_each_block(persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      WalkState& walker = crowd.walkers[i];
      if (deviation > 0.0 && !walker.arrived) {
        walker.noise = variation.keep * walker.noise +
                       variation.add * random_normal(crowd.seed, persons.key[i], crowd.substep,
                                                     Purpose::kHeadingNoise);
      }
      set_goal(crowd, i);
    }
  });
}

}  // namespace pedzone
