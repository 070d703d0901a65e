#include "model/heuristic_model.hpp"

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"
#include "model/heuristic_scratch.hpp"
#include "model/trigonometry.hpp"

namespace pedzone {
namespace {

constexpr double kDegree = kPi / 180.0;

/// Unit vector.
struct Heading {
  float x, y;
};

Heading heading_of(const DirectionTask& task, const DirectionChoice& choice) {
  const float c = task.candidates.cosine[choice.index], s = task.candidates.sine[choice.index];
  return {task.heading_cos * c - task.heading_sin * s, task.heading_sin * c + task.heading_cos * s};
}

/// The goal by Eq. 2 or Eq. 1.
void set_goal(DirectionTask& task, double to_goal, bool half_angle) {
  const SineCosine goal = sine_cosine(half_angle ? to_goal / 2.0 : to_goal);
  task.half_angle = half_angle;
  task.goal_cos = static_cast<float>(goal.cos);
  task.goal_sin = static_cast<float>(goal.sin);
}

}  // namespace

HeuristicModel::HeuristicModel(VehicleForm form, const DirectionKernel& kernel, bool original)
    : form_(form), kernel_(kernel), original_(original) {}

void HeuristicModel::prepare(const Snapshot& snapshot) {
  snapshot_ = snapshot;
  const Parameters& parameters = *snapshot.parameters;
  scenery_.prepare(snapshot, form_);
  if (candidates_.field() != parameters.candidate_field) {
    candidates_ = Candidates(parameters.candidate_field);
  }
  if (gives_way()) cautions_.draw(snapshot);
}

void HeuristicModel::decide(std::size_t first, std::size_t last,
                            std::span<Decision> decisions) const {
  static thread_local Scratch scratch;
  for (std::size_t i = first; i < last; ++i) decisions[i] = decide_one(i, scratch);
}

DirectionTask HeuristicModel::look_around(std::size_t i, const Walker& self,
                                          Surroundings& around) const {
  const Parameters& parameters = *snapshot_.parameters;
  const Senses senses = scenery_.senses_of(i);
  around.see_persons(self, senses, scenery_.persons(), kernel_);
  around.see_walls(self, scenery_.walls());
  const double soon = gives_way() ? kLastMoment : parameters.wait_time;
  around.notice_vehicles(self, senses, scenery_.vehicles(), scenery_.vehicles_near(self.at),
                         static_cast<float>(soon),
                         [&](std::size_t v) { return scenery_.minds(i, v); });

  DirectionTask task;
  task.candidates = candidates_.view();
  task.cost = candidates_.excluded();
  task.heading_cos = self.heading_cos;
  task.heading_sin = self.heading_sin;
  // Those who give way by discomfort walk among people by Eq. 1, as Moussaid 2011 tested it, and by
  // Eq. 2 only where they feel a vehicle, for which it was made: by Eq. 2 turning aside costs so
  // little (of the weight of a way 79 % is left at 75 degrees, by Eq. 1 26 %) that people zigzag
  // before others who come towards them, close the width of a footway, and no lanes form.
  set_goal(task, wrapped(snapshot_.persons->goal_direction[i] - self.heading),
           extended() && (!gives_way() || around.threatened()));
  task.speed = self.speed;
  task.horizon = scenery_.senses().sight / self.speed;
  task.static_horizon = self.static_reach / self.speed;
  around.fill(task);
  return task;
}

Decision HeuristicModel::decide_one(std::size_t i, Scratch& scratch) const {
  const Parameters& parameters = *snapshot_.parameters;
  const Walker self = scenery_.walker(i);
  DirectionTask task = look_around(i, self, scratch.surroundings);
  scratch.turned = false;
  const double to_goal = wrapped(snapshot_.persons->goal_direction[i] - self.heading);
  PacedChoice chosen = gives_way() ? give_way(i, self, to_goal, task, scratch)
                                   : plain(i, self, to_goal, task, scratch);
  if (scratch.turned) {
    chosen.direction.time = time_to_queue(i, self, chosen.direction, task, scratch);
  }
  Decision decision;
  decision.turns = scratch.turned;
  const double speed = snapshot_.persons->preferred_speed[i];
  decision.direction = wrapped(self.heading + candidates_.offset(chosen.direction.index));
  decision.free_distance =
      std::min(static_cast<double>(chosen.direction.time) * speed, parameters.sight);
  decision.speed = std::min(chosen.share * speed,
                            decision.free_distance / parameters.collision_time);  // Eq. 3
  decision.waits = chosen.share == 0.0;
  decision.escapes = scratch.surroundings.threatened();
  return decision;
}

bool HeuristicModel::gives_way() const { return minds_discomfort(*snapshot_.parameters, form_); }

/// By Eq. 2.
bool HeuristicModel::extended() const {
  return !original_ && snapshot_.parameters->equation >= 1.5;
}

PacedChoice HeuristicModel::give_way(std::size_t i, const Walker& self, double to_goal,
                                     DirectionTask& task, Scratch& scratch) const {
  const Parameters& parameters = *snapshot_.parameters;
  if (scratch.surroundings.threatened()) {
    const Haste haste{static_cast<float>(kLastMoment), hurry(i),
                      static_cast<float>(parameters.relaxation_time),
                      snapshot_.persons->goal_distance[i] == 0.0};
    return scratch.making_way.choose(self, scratch.surroundings, candidates_, task, haste, kernel_);
  }
  DirectionChoice best = choose(i, self, to_goal, task, scratch);
  // Round a vehicle that stands across the way Eq. 1 finds no way: it would stand before it for
  // ever. Not for what is beyond its goal: that may lie right beside the vehicle.
  const auto near =
      static_cast<float>(std::min(parameters.near_distance, snapshot_.persons->goal_distance[i]));
  if (extended() && scratch.surroundings.nearest_bar() < near + self.radius &&
      best.time * self.speed < near) {
    set_goal(task, to_goal, true);
    best = choose(i, self, to_goal, task, scratch);
  }
  const std::span<const VehicleView> vehicles = scratch.surroundings.vehicles();
  if (vehicles.empty()) return {best, 1.0};
  const double pace = GivingWay::pace_near(self, vehicles, parameters);
  const double own = snapshot_.attention ? snapshot_.attention->persons[i].caution : 1.0;
  const auto caution = static_cast<float>(own * cautions_.of(i));
  GivingWay& giving_way = scratch.giving_way;
  const Heading way = heading_of(task, best);
  if (!giving_way.notice(self, vehicles, parameters, caution, way.x, way.y, best.time) ||
      giving_way.comfortable(task, best, parameters, kernel_)) {
    return {best, pace};
  }
  if (extended()) set_goal(task, to_goal, true);
  PacedChoice chosen = giving_way.choose(candidates_, task, parameters, best, hurry(i), kernel_);
  if (chosen.share <= 1.0) chosen.share *= pace;  // who hurries does not let it pass
  return chosen;
}

float HeuristicModel::hurry(std::size_t i) const {
  if (snapshot_.attention == nullptr) return kMostHurry;
  const double speed = snapshot_.persons->preferred_speed[i];
  const double most = speed > 0.0 ? snapshot_.attention->persons[i].top_speed / speed : 1.0;
  return std::clamp(static_cast<float>(most), 1.0F, kMostHurry);
}

PacedChoice HeuristicModel::plain(std::size_t i, const Walker& self, double to_goal,
                                  DirectionTask& task, Scratch& scratch) const {
  const Surroundings& around = scratch.surroundings;
  const Parameters& parameters = *snapshot_.parameters;
  const Haste haste{static_cast<float>(parameters.wait_time), 1.0F,
                    static_cast<float>(parameters.relaxation_time)};
  const DirectionChoice best =
      around.threatened()
          ? scratch.making_way.choose(self, around, candidates_, task, haste, kernel_).direction
          : choose(i, self, to_goal, task, scratch);
  const Heading way = heading_of(task, best);
  const bool stands = waits(self, way.x, way.y, around);
  return {best, stands ? 0.0 : 1.0};
}

void HeuristicModel::see_again(std::size_t i, const Walker& self, const Shoulders& shoulders,
                               float horizon, Scratch& scratch, DirectionTask& task) const {
  scratch.surroundings.see_again(self, scenery_.senses_of(i), shoulders, horizon,
                                 scenery_.persons(), kernel_);
  scratch.surroundings.fill(task);
}

bool HeuristicModel::meets_people(const DirectionTask& task, std::uint32_t direction) const {
  alignas(32) float times[kMaxDirections];
  const auto soon = static_cast<float>(snapshot_.parameters->turn_time);
  const std::size_t groups = candidates_.main_padded() / kDirectionGroup;
  for (std::size_t k = 0; k < groups; ++k) {
    const std::size_t first = (direction / kDirectionGroup + k) % groups * kDirectionGroup;
    const std::size_t last = std::min(first + kDirectionGroup, candidates_.main_count());
    for (const DiscView& people : {task.near_discs, task.far_discs}) {
      kernel_.times_of(task, people, {}, first, kDirectionGroup, times);
      if (*std::min_element(times + first, times + last) < soon) return true;
    }
  }
  return false;
}

float HeuristicModel::time_to_queue(std::size_t i, const Walker& self,
                                    const DirectionChoice& direction, DirectionTask& task,
                                    Scratch& scratch) const {
  see_again(i, self, Shoulders::by_facing(), direction.time, scratch, task);
  const std::size_t first = direction.index / kDirectionGroup * kDirectionGroup;
  alignas(32) float times[kMaxDirections];
  float least = direction.time;
  for (const DiscView& people : {task.near_discs, task.far_discs}) {
    kernel_.times_of(task, people, {}, first, kDirectionGroup, times);
    least = std::min(least, times[direction.index]);
  }
  return least;
}

DirectionChoice HeuristicModel::choose(std::size_t i, const Walker& self, double to_goal,
                                       DirectionTask& task, Scratch& scratch) const {
  const Parameters& parameters = *snapshot_.parameters;
  DirectionChoice none;
  none.index = kNoDirection;
  DirectionChoice best = kernel_.choose(task, 0, candidates_.main_count(), none);
  const bool blocked_soon = best.time < static_cast<float>(parameters.turn_time);
  if (!scratch.turned && blocked_soon && meets_people(task, best.index)) {
    scratch.turned = true;
    scratch.surroundings.see_walls_turned(self, scenery_.walls());
    see_again(i, self, Shoulders::turned(), task.horizon, scratch, task);
    best = kernel_.choose(task, 0, candidates_.main_count(), none);
  }
  const bool blocked = best.time * self.speed < static_cast<float>(parameters.near_distance);
  const bool goal_outside = std::abs(to_goal) > candidates_.field() * kDegree;
  if (blocked || goal_outside || scratch.surroundings.hears_vehicle()) {
    best = kernel_.choose(task, candidates_.main_padded(), candidates_.rest_count(), best);
  }
  return best;
}

bool HeuristicModel::waits(const Walker& self, float ex, float ey,
                           const Surroundings& surroundings) const {
  const Parameters& parameters = *snapshot_.parameters;
  const auto distance = static_cast<float>(parameters.wait_distance);
  const auto time = static_cast<float>(parameters.wait_time);
  // Whoever is in a vehicle's way walks out of it. Its way is at least as wide here as where a
  // yielding vehicle minds people, so that nobody waits for a vehicle that waits for it.
  const float margin = std::max(kVehicleRoom, static_cast<float>(parameters.yield_margin));
  bool crossed = false;
  for (const VehicleView& vehicle : surroundings.vehicles()) {
    const float ahead = distance_in_its_way(vehicle, self, margin);
    if (ahead <= vehicle.shape->speed * time) return false;
    crossed =
        crossed || (ahead == kNotInItsWay && crosses_way(vehicle, self, ex, ey, distance, time));
  }
  return crossed;
}

}  // namespace pedzone
