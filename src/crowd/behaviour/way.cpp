#include "crowd/behaviour/way.hpp"

#include <cmath>

#include "core/random.hpp"
#include "crowd/state/parallel.hpp"

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

Wish wish_of_route(const CrowdState& crowd, std::size_t i) {
  const WalkState& walker = crowd.walkers[i];
  if (walker.arrived) return {crowd.persons.heading[i], 0.0, Behaviour::kWay};
  const Vec2 to_goal = heading_point(walker.route, crowd.position(i)) - crowd.position(i);
  const double noise = info_of(crowd.activities[walker.handle].activity).noise;
  return {wrap_angle(angle_of(to_goal) + walker.heading_noise * noise), to_goal.norm(),
          Behaviour::kWay};
}

/// The variation turns the goal and not the movement: what the person then chooses is checked
/// for contacts like any other direction, so the noise carries nobody into anything.
void propose_way(const CrowdState& crowd, double dt, std::vector<WalkState>& walkers,
                 Proposals& proposals) {
  const Parameters& parameters = crowd.zone.parameters;
  const double deviation = parameters.heading_noise * kPi / 180.0;
  const Variation variation(deviation, parameters.heading_noise_time, dt);
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      WalkState& walker = walkers[i];
      if (deviation > 0.0 && !walker.arrived) {
        walker.heading_noise =
            variation.keep * walker.heading_noise +
            variation.add * random_normal(crowd.seed, crowd.persons.key[i], crowd.clock.substep,
                                          Purpose::kHeadingNoise);
      }
      proposals.propose(i, wish_of_route(crowd, i));
    }
  });
}

}  // namespace pedzone
