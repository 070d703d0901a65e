// Who waits where others pass: for a bus, a light, somebody, or because its SUMO stage says so. A
// person who is held up by somebody that stands asks it for room beside its line, for the more the
// longer it has got nowhere, and the one that stands steps out of that line sideways: away from
// the line if there is room, else to the other side of it. It goes no farther than it has to and,
// where SUMO holds its place, no farther from that than kStepBack; there it returns when nobody
// needs the room.
//
//          x   x   x   waiting                    x   x   x
//   o->      x   x                ==>     ---o->            -->
//          x   x   x                              x   x   x
//
// Everybody reads the places of the substep's beginning and writes its own, so the order of persons
// does not matter; of several passers the one who lacks most room is minded, of equals the one with
// the lower key.
#include "crowd/behaviour/bystanding.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "crowd/sense/vehicle_motion.hpp"
#include "crowd/state/parallel.hpp"
#include "crowd/state/state.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kStepBack = 0.5;      // [m] assumed: a step, and no more than a row of a bus stop
constexpr double kStepSpeed = 0.5;     // [m/s] assumed: a step to the side takes a second
constexpr double kReturnSpeed = 0.25;  // [m/s] assumed: nobody hurries back
constexpr double kTurnReach = 1.5;     // [m] assumed: for somebody so near the shoulders are turned
constexpr double kPassReach = 1.2;     // [m] assumed: beyond the bodies, along the passer's line
constexpr double kHeldUpShare = 0.5;   // assumed: slower than so much of its speed is held up
constexpr double kPassGap = 0.1;       // [m] assumed: between turned bodies that pass
constexpr double kGapPerSecond = 0.1;  // [m/s] assumed: more, for who gets nowhere for long ...
constexpr double kMostGap = 0.4;       // [m] ... up to the room of one more turned body
constexpr double kRejoin = 0.5;        // [s] assumed: who walks again is where SUMO has it by then
constexpr double kMoved = 0.3;         // [m] numerical: SUMO has put the person elsewhere
constexpr double kVehicleReach = 3.0;  // [m] assumed: nobody steps nearer to a vehicle so near
constexpr double kTolerance = 1e-9;    // [m] numerical

/// Room [m] beside its line that passer j asks of those who stand; nothing while it gets on.
std::optional<double> gap_asked(const CrowdState& crowd, std::size_t j) {
  const Vec2 along = unit(crowd.persons.goal_direction[j]);
  if (crowd.velocity(j).dot(along) > kHeldUpShare * crowd.persons.preferred_speed[j]) return {};
  return std::min(kMostGap, kPassGap + kGapPerSecond * crowd.walkers[j].blocked);
}

/// The line of somebody who is held up, as one sees it who stands in its way.
struct Line {
  double lacking = 0.0;  ///< [m] of room between their bodies; 0: is not in the way
  double lateral = 0.0;  ///< [m] of who stands, positive to the left of the line
  Vec2 left = Vec2::Zero();
  std::uint64_t key = 0;  ///< of who is held up
};

/// One person that stands.
class Stander {
 public:
  /// widest: [m] largest turned radius of all.
  Stander(const CrowdState& crowd, std::size_t i, double widest)
      : crowd_(crowd),
        i_(i),
        here_(crowd.position(i)),
        own_(crowd.persons.turned_radius[i]),
        widest_(widest) {
    const double reach = std::max(kTurnReach, own_ + widest + kPassReach + kMostGap);
    const Vec2 box = Vec2::Constant(reach);
    crowd.grid.visit_box(here_ - box, here_ + box,
                         [&](std::uint32_t j, const Vec2& there) { look_at(j, there); });
  }

  /// Whether somebody goes past, or would like to.
  bool passed() const { return passed_; }

  /// The step [m] of at most `most` for who is held up by it; nothing where there is nobody. Across
  /// the other's line only where it gets out of it there.
  std::optional<Vec2> step_aside(double most) {
    if (worst_.lacking <= 0.0) return std::nullopt;
    const double side = worst_.lateral >= 0.0 ? 1.0 : -1.0;
    const double across = worst_.lacking + 2.0 * std::abs(worst_.lateral);
    const Vec2 away = side * std::min(worst_.lacking, most) * worst_.left;
    if (free(away)) return away;
    const Vec2 over = -side * std::min(across, most) * worst_.left;
    if (in_reach(-side * across * worst_.left) && free(over)) return over;
    return Vec2::Zero();
  }

  /// Whether others leave so much room, and a gap, for the step, or it takes nobody's.
  bool others_allow(const Vec2& step, double gap) const {
    const Vec2 to = here_ + step;
    for (const std::uint32_t v : crowd_.vehicles_near.at(to, kVehicleReach)) {
      const Rectangle& body = crowd_.vehicle_bodies[v];
      const double distance = body.distance(to);
      if (distance < kVehicleReach && distance < body.distance(here_)) return false;
    }
    bool free = true;
    const Vec2 box = Vec2::Constant(own_ + widest_ + gap);
    crowd_.grid.visit_box(to - box, to + box, [&](std::uint32_t j, const Vec2& there) {
      const double bodies = own_ + crowd_.persons.turned_radius[j] + gap;
      const double after = (there - to).squaredNorm();
      free =
          free && (j == i_ || after >= bodies * bodies || after >= (there - here_).squaredNorm());
    });
    return free;
  }

 private:
  void look_at(std::uint32_t j, const Vec2& there) {
    const bool walked = j < crowd_.persons.walking;
    if (crowd_.standing.stands[j] != 0 || (!walked && crowd_.velocity(j).norm() < kHaltingSpeed))
      return;
    passed_ = passed_ || (there - here_).squaredNorm() < kTurnReach * kTurnReach;
    const auto gap = walked ? gap_asked(crowd_, j) : std::nullopt;
    if (!gap) return;
    const Vec2 from_other = here_ - there, along = unit(crowd_.persons.goal_direction[j]);
    const double bodies = own_ + crowd_.persons.turned_radius[j], ahead = from_other.dot(along);
    if (ahead <= -bodies || ahead > bodies + kPassReach) return;
    const double lateral = cross(along, from_other);
    const Line line{bodies + *gap - std::abs(lateral), lateral, left_of(along),
                    crowd_.persons.key[j]};
    const bool worse =
        line.lacking > worst_.lacking || (line.lacking == worst_.lacking && line.key < worst_.key);
    if (worse) worst_ = line;
  }

  /// Whether it gets as far as that: SUMO holds the places of those whom it walks.
  bool in_reach(const Vec2& step) const {
    const std::size_t walking = crowd_.persons.walking;
    return i_ < walking ||
           (crowd_.seen_memory[i_ - crowd_.first_seen()].stepped + step).norm() <= kStepBack;
  }

  bool free(const Vec2& step) { return walls_allow(here_ + step) && others_allow(step, 0.0); }

  /// Whether it is inside at `to`, and no nearer to walls than it is or needs to be.
  bool walls_allow(const Vec2& to) {
    const WallIndex& walls = crowd_.zone.walls;
    if (!walls.sees(here_, to) || !walls.inside(to)) return false;
    return walls.room(to, own_) >= walls.room(here_, own_) - kTolerance;
  }

  const CrowdState& crowd_;
  std::size_t i_;
  Vec2 here_;
  double own_, widest_;
  bool passed_ = false;
  Line worst_;
};

/// Whether a walked person stands because it wants to, and not because others hold it up.
bool stands_by_choice(const CrowdState& crowd, std::size_t i) {
  const WalkState& walker = crowd.walkers[i];
  const bool stays = walker.arrived || walker.waits || crowd.groups[walker.handle].waits ||
                     info_of(crowd.activities[walker.handle].activity).speed <= 0.0;
  return stays && crowd.velocity(i).norm() < kStaticSpeed;
}

/// Of a step of somebody whom SUMO holds, what stays within kStepBack of SUMO's place.
Vec2 within_reach(const SeenMemory& seen, const Vec2& step) {
  const Vec2 stepped = seen.stepped + step;
  const double length = stepped.norm();
  return length <= kStepBack ? step : Vec2(stepped * (kStepBack / length) - seen.stepped);
}

/// Back towards SUMO's place, wherever that is, when it is free.
Vec2 step_home(const Stander& stander, const SeenMemory& seen, double most) {
  const double far = seen.stepped.norm();
  if (far < kTolerance) return Vec2::Zero();
  const Vec2 step = seen.stepped * (-std::min(far, most) / far);
  return stander.others_allow(step, kPassGap) ? step : Vec2(Vec2::Zero());
}

/// What somebody in SUMO's hands, who stands, does for others: turns, and makes the step [m] that
/// is returned.
Vec2 make_room_by_seen(Stander& stander, double dt, double turn_time, SeenMemory& seen) {
  const auto aside = stander.step_aside(kStepSpeed * dt);
  seen.turn = stander.passed() ? 1.0 : std::max(0.0, seen.turn - dt / std::max(turn_time, dt));
  if (seen.key == 0) return Vec2::Zero();
  const Vec2 step =
      within_reach(seen, aside ? *aside : step_home(stander, seen, kReturnSpeed * dt));
  seen.stepped += step;
  return step;
}

}  // namespace

void recognise_seen(std::vector<SeenPerson>& seen, std::vector<SeenMemory>& memory,
                    std::vector<SeenMemory>& before) {
  std::ranges::sort(seen, {}, &SeenPerson::key);
  std::swap(memory, before);
  memory.clear();
  auto known = before.begin();
  for (const SeenPerson& person : seen) {
    while (known != before.end() && known->key < person.key) ++known;
    SeenMemory& now = memory.emplace_back();
    if (person.key == 0) continue;
    const bool again = known != before.end() && known->key == person.key &&
                       (known->foreseen - person.position).norm() < kMoved;
    if (again) now = *known;
    now.key = person.key;
    now.foreseen = person.position;
  }
}

void notice_standing(const CrowdState& crowd, double dt, Standing& standing, double& reach) {
  const std::size_t walking = crowd.persons.walking, first_seen = crowd.first_seen();
  standing.stands.assign(crowd.persons.size(), 0);
  standing.passed.assign(walking, 0);
  standing.anybody = false;
  for (std::size_t i = 0; i < standing.stands.size(); ++i) {
    const bool stands =
        i < walking ? stands_by_choice(crowd, i)
                    : i >= first_seen && crowd.seen_memory[i - first_seen].still >= kStandingTime;
    standing.stands[i] = stands ? 1 : 0;
    standing.anybody = standing.anybody || stands;
  }
  if (standing.anybody) reach = std::max(reach, kStepSpeed * dt);
}

void make_room(const CrowdState& crowd, double dt, std::vector<std::uint8_t>& passed,
               std::vector<SeenMemory>& seen_memory, Moves& moves) {
  if (!crowd.standing.anybody) return;
  const double widest = std::ranges::max(crowd.persons.turned_radius);
  const double turn_time = crowd.zone.parameters.turn_time;
  const auto make_room_by = [&](std::size_t i) {
    Stander stander(crowd, i, widest);
    std::optional<Vec2> step;
    if (i < crowd.persons.walking) {
      passed[i] = stander.passed() ? 1 : 0;
      step = stander.step_aside(kStepSpeed * dt);
    } else {
      step = make_room_by_seen(stander, dt, turn_time, seen_memory[i - crowd.first_seen()]);
    }
    if (!step) return;
    moves.dx[i] = step->x();
    moves.dy[i] = step->y();
  };
  for_each_block(crowd.persons.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (crowd.standing.stands[i] != 0) make_room_by(i);
    }
  });
}

void remember_seen(const CrowdState& crowd, double dt, std::vector<SeenMemory>& memory) {
  for (std::size_t k = 0; k < crowd.seen.size(); ++k) {
    const SeenPerson& person = crowd.seen[k];
    SeenMemory& now = memory[k];
    now.foreseen = person.position + person.velocity * dt;
    if (person.velocity.norm() < kStaticSpeed) {
      now.still += dt;
    } else {  // goes on from where it stood and not from where SUMO had it stand
      now.still = 0.0;
      now.turn = 1.0;
      now.stepped *= std::max(0.0, 1.0 - dt / kRejoin);
    }
  }
}

Vec2 own_place(const CrowdState& crowd, std::size_t k) {
  return crowd.seen[k].position + crowd.seen_memory[k].stepped;
}

}  // namespace pedzone
