#include "model/heuristic_model.hpp"

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"

namespace pedzone {
namespace {

constexpr double kDegree = kPi / 180.0;
/// [m] added to the reach of wall lists, for rounding to the lattice.
constexpr double kListMargin = 0.01;

struct Segment {
  float h, x;      ///< [m] the walker's distance from the line (≥ 0) and foot point along it
  float nx, ny;    ///< unit normal towards the walker
  float px, py;    ///< [m] first point relative to the walker
  float distance;  ///< [m]
};

Segment segment_of(const WallFace& wall, const LatticePoint& at) {
  Segment s;
  s.px = lattice_difference(wall.from.x, at.x);
  s.py = lattice_difference(wall.from.y, at.y);
  const float left = s.px * wall.dy - s.py * wall.dx;  // d × (−p)
  const float side = left < 0.0F ? -1.0F : 1.0F;       // walls have two sides
  s.h = side * left;
  s.nx = -wall.dy * side;
  s.ny = wall.dx * side;
  s.x = -(s.px * wall.dx + s.py * wall.dy);
  const float beyond = std::max(std::max(-s.x, s.x - wall.length), 0.0F);
  s.distance = std::sqrt(s.h * s.h + beyond * beyond);
  return s;
}

}  // namespace

/// What one thread needs while it decides; reused from person to person and step to step.
struct HeuristicModel::Scratch {
  DiscList near_persons, persons, vehicle_discs, still_discs, one_discs;
  FaceList vehicle_faces, still_faces, one_faces;
  std::vector<SlotGroup> groups;
  std::vector<VehicleView> vehicles;  ///< moving ones that the person is aware of
  std::vector<Segment> segments;
  DirectionTimes times;
  float hit[kMaxDirections], one[kMaxDirections];
  bool heard = false;       ///< a vehicle outside the field of view
  bool threatened = false;  ///< a vehicle would run into the person if it stood still
};

/// One person's own state, in the kernel's units.
struct HeuristicModel::Aware : Onlooker {
  Senses senses;
  float static_reach = 10.0F;   ///< [m] what stands still counts up to here
  float collision_time = 0.5F;  ///< [s]
};

HeuristicModel::HeuristicModel(const DirectionKernel& kernel) : kernel_(kernel) {}

void HeuristicModel::prepare(const Snapshot& snapshot) {
  snapshot_ = snapshot;
  const Parameters& parameters = *snapshot.parameters;
  if (candidates_.field() != parameters.candidate_field) {
    candidates_ = Candidates(parameters.candidate_field);
  }
  const std::span<const Wall> walls =
      snapshot.walls != nullptr ? snapshot.walls->walls() : std::span<const Wall>();
  if (snapshot.walls != known_walls_ || walls.data() != known_first_ ||
      walls.size() != known_count_ || parameters.sight != known_reach_) {
    // Any lattice point near the scene serves as origin.
    const Persons& persons = *snapshot.persons;
    const Vec2 near = !walls.empty()       ? walls.front().a
                      : persons.size() > 0 ? Vec2(persons.x[0], persons.y[0])
                                           : Vec2::Zero();
    origin_ = {to_lattice(near.x()), to_lattice(near.y())};
    walls_.build(walls, parameters.sight + kListMargin, origin_);
    known_walls_ = snapshot.walls;
    known_first_ = walls.data();
    known_count_ = walls.size();
    known_reach_ = parameters.sight;
  }
  grid_.build(*snapshot.persons, origin_, parameters.sight, parameters.field_of_view * kDegree);
  vehicles_.clear();
  for (const VehicleState& vehicle : snapshot.vehicles) {
    vehicles_.push_back(shape_of(vehicle, origin_));
  }
}

void HeuristicModel::decide(std::size_t first, std::size_t last,
                            std::span<Decision> decisions) const {
  static thread_local Scratch scratch;
  for (std::size_t i = first; i < last; ++i) decisions[i] = decide_one(i, scratch);
}

Decision HeuristicModel::decide_one(std::size_t i, Scratch& scratch) const {
  const Persons& persons = *snapshot_.persons;
  const Parameters& parameters = *snapshot_.parameters;
  const double heading = persons.heading[i];
  const double speed = persons.preferred_speed[i];

  Aware self;
  self.at = to_lattice(persons.x[i], persons.y[i], origin_);
  self.heading_cos = static_cast<float>(std::cos(heading));
  self.heading_sin = static_cast<float>(std::sin(heading));
  self.radius = static_cast<float>(persons.radius[i]);
  self.speed = static_cast<float>(speed);
  self.senses = {static_cast<float>(parameters.sight), static_cast<float>(parameters.hearing),
                 static_cast<float>(std::cos(parameters.field_of_view * kDegree)),
                 static_cast<float>(std::sin(parameters.field_of_view * kDegree))};
  // Nobody avoids what stands behind its goal. Not nearer than what Eq. 3 brakes for, so that
  // the speed never depends on the goal.
  self.static_reach = static_cast<float>(std::min(
      std::max(persons.goal_distance[i], speed * parameters.collision_time), parameters.sight));

  scratch.vehicle_discs.clear();
  scratch.vehicle_faces.clear();
  scratch.still_discs.clear();
  scratch.still_faces.clear();
  perceive_persons(self, heading, scratch);
  perceive_walls(self, scratch);
  perceive_vehicles(self, scratch);
  scratch.still_discs.fill_group();
  scratch.still_faces.fill_group();

  DirectionTask task;
  task.candidates = candidates_.view();
  task.heading_cos = self.heading_cos;
  task.heading_sin = self.heading_sin;
  task.half_angle = parameters.equation >= 1.5;
  const double to_goal = wrap_angle(persons.goal_direction[i] - heading);
  const double angle = task.half_angle ? to_goal / 2.0 : to_goal;
  task.goal_cos = static_cast<float>(std::cos(angle));
  task.goal_sin = static_cast<float>(std::sin(angle));
  task.speed = self.speed;
  task.horizon = self.senses.sight / self.speed;
  task.static_horizon = self.static_reach / self.speed;
  task.near_discs = scratch.near_persons.view();
  task.far_discs = scratch.persons.view();
  task.vehicle_discs = scratch.vehicle_discs.view();
  task.vehicle_faces = scratch.vehicle_faces.view();
  task.still_discs = scratch.still_discs.view();
  task.still_faces = scratch.still_faces.view();

  DirectionChoice choice;
  if (scratch.threatened) {
    choice = make_way(self, task, scratch);
  } else {
    choice.index = kNoDirection;
    choice = kernel_.choose(task, 0, candidates_.main_count(), choice);
    const bool blocked = choice.time * self.speed < static_cast<float>(parameters.near_distance);
    const bool goal_outside = std::abs(to_goal) > candidates_.field() * kDegree;
    if ((blocked || goal_outside || scratch.heard) && candidates_.rest_count() > 0) {
      choice = kernel_.choose(task, candidates_.main_padded(), candidates_.rest_count(), choice);
    }
  }

  Decision decision;
  const double offset = candidates_.offset(choice.index);
  decision.direction = wrap_angle(heading + offset);
  decision.free_distance = std::min(static_cast<double>(choice.time) * speed, parameters.sight);
  decision.speed = std::min(speed, decision.free_distance / parameters.collision_time);  // Eq. 3
  const Vec2 e = unit(heading + offset);
  decision.waits = waits(self, static_cast<float>(e.x()), static_cast<float>(e.y()), scratch);
  if (decision.waits) decision.speed = 0.0;
  return decision;
}

void HeuristicModel::perceive_persons(const Aware& self, double heading, Scratch& scratch) const {
  Sight sight;
  sight.x = self.at.x;
  sight.y = self.at.y;
  sight.heading_cos = self.heading_cos;
  sight.heading_sin = self.heading_sin;
  sight.field_cos = self.senses.field_cos;
  sight.reach = self.senses.sight;
  sight.radius = self.radius;
  sight.speed = self.speed;
  sight.horizon = self.senses.sight / self.speed;
  sight.static_reach = self.static_reach;
  float from = 0.0F;
  const auto see = [&](Belt belt, double border, DiscList& discs) {
    sight.beyond = from;
    sight.reach = std::min(static_cast<float>(border), self.senses.sight);
    from = sight.reach;
    const auto groups = grid_.groups(belt, self.at, heading, scratch.groups);
    discs.reserve(discs.size + groups.size() * kSlotGroup);
    discs.size =
        kernel_.see(grid_.slots(), groups.data(), groups.size(), sight, discs.space(), discs.size);
  };
  scratch.near_persons.clear();
  scratch.persons.clear();
  see(Belt::kNear, kBeltBorders[0], scratch.near_persons);
  see(Belt::kMiddle, kBeltBorders[1], scratch.persons);
  see(Belt::kFar, snapshot_.parameters->sight, scratch.persons);
}

void HeuristicModel::perceive_walls(const Aware& self, Scratch& scratch) const {
  const std::span<const std::uint32_t> near = walls_.near(self.at);
  if (near.empty()) return;
  // A body that is closer to a wall than its radius only minds getting closer still.
  float contact = self.radius;
  scratch.segments.clear();
  for (const std::uint32_t w : near) {
    scratch.segments.push_back(segment_of(walls_.walls()[w], self.at));
    contact = std::min(contact, scratch.segments.back().distance - kSkin);
  }
  contact = std::max(contact, 0.0F);
  const float reach = self.static_reach + contact;
  const float speed2 = self.speed * self.speed;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Segment& s = scratch.segments[i];
    if (s.distance > reach) continue;
    const WallFace& wall = walls_.walls()[near[i]];
    scratch.still_faces.add({.nx = s.nx,
                             .ny = s.ny,
                             .dx = wall.dx,
                             .dy = wall.dy,
                             .vx = 0.0F,
                             .vy = 0.0F,
                             .gap = s.h - contact,
                             .x = s.x,
                             .length = wall.length});
    if (wall.begin) scratch.still_discs.add(s.px, s.py, 0.0F, 0.0F, contact, speed2);
    if (wall.end) {
      scratch.still_discs.add(s.px + wall.dx * wall.length, s.py + wall.dy * wall.length, 0.0F,
                              0.0F, contact, speed2);
    }
  }
}

void HeuristicModel::perceive_vehicles(const Aware& self, Scratch& scratch) const {
  scratch.vehicles.clear();
  scratch.heard = scratch.threatened = false;
  const float range = std::max(self.senses.sight, self.senses.hearing);
  const auto soon = static_cast<float>(snapshot_.parameters->wait_time);
  for (const VehicleShape& shape : vehicles_) {
    const float x = lattice_difference(shape.centre.x, self.at.x);
    const float y = lattice_difference(shape.centre.y, self.at.y);
    const float far = range + shape.reach;
    if (x * x + y * y > far * far) continue;
    const VehicleView view = view_of(shape, self);
    const Awareness aware = awareness(view, self, self.senses);
    if (aware == Awareness::kNone) continue;
    if (!shape.moving()) {
      if (view.distance <= self.static_reach + view.contact) {
        add_vehicle(view, self, scratch.still_discs, scratch.still_faces);
      }
      continue;
    }
    add_vehicle(view, self, scratch.vehicle_discs, scratch.vehicle_faces);
    scratch.vehicles.push_back(view);
    scratch.heard = scratch.heard || aware == Awareness::kHeard;
    scratch.threatened =
        scratch.threatened || time_to_standing(view, self, 0.0F, 0.0F, 0.0F) < soon;
  }
}

/// A moving vehicle would soon run into the person if it stood still, so standing is no way out,
/// though Eq. 1 and 2 price it at 0 and any way back at more. Of all directions those count that
/// keep the person clear of vehicles for `waitTime`, it being taken to stop where something that
/// stands blocks it; where there is none, those that do so longest. Among them Eq. 1 or 2 decide.
DirectionChoice HeuristicModel::make_way(const Aware& self, const DirectionTask& task,
                                         Scratch& scratch) const {
  const auto soon = static_cast<float>(snapshot_.parameters->wait_time);
  kernel_.times(task, scratch.times);
  std::fill(std::begin(scratch.hit), std::end(scratch.hit), soon);
  const std::size_t main = candidates_.main_count();
  const std::size_t count = candidates_.main_padded() + candidates_.rest_count();
  for (const VehicleView& view : scratch.vehicles) {
    scratch.one_discs.clear();
    scratch.one_faces.clear();
    add_vehicle(view, self, scratch.one_discs, scratch.one_faces);
    kernel_.times_of(task, scratch.one_discs.view(), scratch.one_faces.view(), scratch.one);
    for (std::size_t k = 0; k < count; ++k) {
      float hit = scratch.one[k];
      const float stop = scratch.times.still[k];
      if (stop < hit) {
        const float c = task.candidates.cosine[k], s = task.candidates.sine[k];
        const float dx = (self.heading_cos * c - self.heading_sin * s) * (self.speed * stop);
        const float dy = (self.heading_sin * c + self.heading_cos * s) * (self.speed * stop);
        hit = time_to_standing(view, self, dx, dy, stop);
      }
      scratch.hit[k] = std::min(scratch.hit[k], hit);
    }
  }
  DirectionChoice best;
  float best_hit = -1.0F;
  for (std::size_t k = 0; k < count; ++k) {
    if (k >= main && k < candidates_.main_padded()) continue;
    const float time = scratch.times.all[k], d = scratch.times.weight[k];
    const DirectionChoice choice{static_cast<std::uint32_t>(k), time, time * (time - d), d};
    if (scratch.hit[k] > best_hit || (scratch.hit[k] == best_hit && better(choice, best))) {
      best = choice;
      best_hit = scratch.hit[k];
    }
  }
  return best;
}

bool HeuristicModel::waits(const Aware& self, float ex, float ey, const Scratch& scratch) const {
  const Parameters& p = *snapshot_.parameters;
  const auto distance = static_cast<float>(p.wait_distance);
  const auto time = static_cast<float>(p.wait_time);
  // Whoever is in a vehicle's way walks out of it. Its way is at least as wide here as where a
  // yielding vehicle minds people, so that nobody waits for a vehicle that waits for it.
  const float margin = std::max(kVehicleRoom, static_cast<float>(p.yield_margin));
  for (const VehicleView& view : scratch.vehicles) {
    if (in_its_way(view, self, margin)) return false;
  }
  return std::any_of(
      scratch.vehicles.begin(), scratch.vehicles.end(),
      [&](const VehicleView& view) { return crosses_way(view, self, ex, ey, distance, time); });
}

}  // namespace pedzone
