#include "crowd/motion/moves.hpp"

#include <algorithm>
#include <cmath>

#include "crowd/state/parallel.hpp"
#include "crowd/state/state.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

/// dv/dt = (wanted − v) / τ over `dt`, solved exactly, so that substeps of any length agree.
struct Relaxation {
  double keep;   ///< share of the old velocity that is left
  double glide;  ///< [s] distance by which the old velocity still carries, per m/s

  Relaxation(double time, double dt) : keep(std::exp(-dt / time)), glide(time * (1.0 - keep)) {}
  static Relaxation none() { return {}; }

 private:
  Relaxation() : keep(0.0), glide(0.0) {}
};

/// Takes from `v` what exceeds `most` along the unit vector `e`.
Vec2 limited(const Vec2& v, const Vec2& e, double most) {
  const double along = v.dot(e);
  return along > most ? Vec2(v - (along - most) * e) : v;
}

/// A walking body faces where it goes; a standing one turns to where it would go.
double turned(double heading, const Vec2& velocity, const Decision& decision, double keep) {
  const double speed = velocity.norm();
  if (speed >= kFacingSpeed) return angle_of(velocity);
  return wrap_angle(heading + (1.0 - keep) * wrap_angle(decision.direction - heading));
}

}  // namespace

/// The velocity relaxes towards the decision. Since it lags, it could carry a person farther than
/// the free distance that the decision rests on (Eq. 3 alone with t_coll = τ overshoots): the
/// move is cut there. A model that gives velocities has seen to inertia itself. Seen persons and
/// vehicles simply move on.
void set_moves(const CrowdState& crowd, double dt, std::vector<WalkState>& walkers,
               Persons& persons, Moves& moves) {
  const Relaxation turning(crowd.zone.parameters.relaxation_time, dt);
  const Relaxation relaxation = crowd.model->sets_velocity() ? Relaxation::none() : turning;
  moves.by_vehicles.assign(persons.walking, 0.0);
  for (auto* list : {&moves.dx, &moves.dy, &moves.x, &moves.y, &moves.next_x, &moves.next_y}) {
    list->resize(persons.size());
  }
  for_each_block(persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Decision& decision = crowd.decisions[i];
      WalkState& walker = walkers[i];
      walker.waits = decision.waits && !walker.arrived;
      Vec2 move = Vec2::Zero(), velocity = Vec2::Zero();
      if (!walker.arrived || decision.escapes) {
        const Vec2 direction = unit(decision.direction);
        const Vec2 wanted = decision.speed * direction;
        const Vec2 lag = crowd.velocity(i) - wanted;
        move = limited(wanted * dt + lag * relaxation.glide, direction, decision.free_distance);
        velocity = limited(wanted + lag * relaxation.keep, direction, decision.free_distance / dt);
        const double speed = velocity.norm();
        const double most = std::max(persons.preferred_speed[i], decision.speed);
        if (speed > most) velocity *= most / speed;
        persons.heading[i] = turned(persons.heading[i], velocity, decision, turning.keep);
      }
      persons.vx[i] = velocity.x();
      persons.vy[i] = velocity.y();
      moves.dx[i] = move.x();
      moves.dy[i] = move.y();
    }
  });
  for (std::size_t i = persons.walking; i < persons.size(); ++i) {
    moves.dx[i] = persons.vx[i] * dt;
    moves.dy[i] = persons.vy[i] * dt;
  }
  double squared = 0.0;
  for (std::size_t i = 0; i < persons.size(); ++i) {
    squared = std::max(squared, moves.dx[i] * moves.dx[i] + moves.dy[i] * moves.dy[i]);
  }
  moves.reach = std::sqrt(squared);
}

}  // namespace pedzone
