#include "model/surroundings.hpp"

#include <algorithm>
#include <cmath>

namespace pedzone {
namespace {

/// [s] persons whom some direction meets so soon are tried on many directions at once, since they
/// decide most of them. Numerical, by timing.
constexpr float kSoon = 1.3F;
/// [m] by which walls are longer at both ends, so that nobody slips through a joint of two that are
/// in line. Numerical: far above rounding, far below a body.
constexpr float kOverlap = 1e-3F;

Sight sight_of(const Walker& walker, const Senses& senses, const Shoulders& shoulders) {
  Sight sight;
  sight.x = walker.at.x;
  sight.y = walker.at.y;
  sight.heading_cos = walker.heading_cos;
  sight.heading_sin = walker.heading_sin;
  sight.field_cos = senses.field_cos;
  sight.radius = walker.radius;
  sight.turned_radius = walker.turned_radius;
  sight.shoulders = shoulders;
  sight.speed = walker.speed;
  sight.horizon = senses.sight / walker.speed;
  sight.static_reach = walker.static_reach;
  sight.reach = senses.sight;
  sight.soon = std::min(kSoon, sight.horizon);
  return sight;
}

}  // namespace

void Surroundings::see_persons(const Walker& walker, const Senses& senses, const PersonGrid& grid,
                               const DirectionKernel& kernel) {
  const Sight sight = sight_of(walker, senses, Shoulders::kept_straight());
  const auto groups = grid.groups(walker.at, walker.heading, groups_);
  met_ = see(grid, groups, sight, kernel, groups_.data()).groups;
}

void Surroundings::see_again(const Walker& walker, const Senses& senses, const Shoulders& shoulders,
                             float horizon, const PersonGrid& grid, const DirectionKernel& kernel) {
  Sight sight = sight_of(walker, senses, shoulders);
  sight.horizon = std::min(sight.horizon, horizon);
  // Nobody is in the way of narrower bodies who is not in that of straight ones.
  see(grid, {groups_.data(), met_}, sight, kernel, nullptr);
}

Seen Surroundings::see(const PersonGrid& grid, std::span<const SlotGroup> groups,
                       const Sight& sight, const DirectionKernel& kernel, SlotGroup* met) {
  const std::size_t most = groups.size() * kSlotGroup;
  const Seen seen = kernel.see(grid.slots(), groups, sight, near_room_.space(most, near_persons_),
                               far_room_.space(most, far_persons_), met);
  near_persons_.size = seen.near;
  far_persons_.size = seen.far;
  return seen;
}

SeenSpace Surroundings::Room::space(std::size_t persons, DiscList& discs) {
  const std::size_t needed = persons + 2 * kObstacleGroup;
  if (x.size() < needed) {
    for (auto* array : {&x, &y, &vx, &vy, &radius, &turned, &hx, &hy}) array->resize(needed);
  }
  discs.reserve(persons + kObstacleGroup);
  return {x.data(),      y.data(),  vx.data(), vy.data(),          radius.data(),
          turned.data(), hx.data(), hy.data(), discs.groups.data()};
}

Surroundings::Segment Surroundings::segment_of(const WallFace& wall, const LatticePoint& at) {
  const float x = lattice_difference(at.x, wall.middle.x);
  const float y = lattice_difference(at.y, wall.middle.y);
  Segment s;
  s.h = y * wall.dx - x * wall.dy;
  s.x = x * wall.dx + y * wall.dy;
  const float beyond = std::max(std::abs(s.x) - 0.5F * wall.length, 0.0F);
  s.distance2 = s.h * s.h + beyond * beyond;
  return s;
}

void Surroundings::see_walls(const Walker& walker, const WallTiles& walls) {
  still_discs_.clear();
  still_faces_.clear();
  const std::span<const std::uint32_t> near = walls.near(walker.at);
  if (near.empty()) return;
  if (segments_.size() < near.size()) segments_.resize(near.size());
  still_faces_.reserve(near.size());
  still_discs_.reserve(2 * near.size());
  float nearest2 = walker.static_reach * walker.static_reach;
  for (std::size_t i = 0; i < near.size(); ++i) {
    segments_[i] = segment_of(walls[near[i]], walker.at);
    nearest2 = std::min(nearest2, segments_[i].distance2);
  }
  // A body that is closer to a wall than its radius only minds getting closer still.
  const float contact = std::max(std::min(walker.radius, std::sqrt(nearest2) - kSkin), 0.0F);
  const float reach = walker.static_reach + contact;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (segments_[i].distance2 > reach * reach) continue;
    add_wall(walker, walls[near[i]], segments_[i], contact);
  }
}

void Surroundings::see_walls_turned(const Walker& walker, const WallTiles& walls) {
  Walker narrow = walker;
  narrow.radius = walker.turned_radius;
  see_walls(narrow, walls);
  add_standing(walker);
}

void Surroundings::add_wall(const Walker& walker, const WallFace& wall, const Segment& s,
                            float contact) {
  const bool front = s.h >= 0.0F;
  if (front) {
    still_faces_.add({.nx = -wall.dy,
                      .ny = wall.dx,
                      .dx = wall.dx,
                      .dy = wall.dy,
                      .vx = 0.0F,
                      .vy = 0.0F,
                      .gap = s.h - contact,
                      .x = s.x,
                      .half_length = 0.5F * wall.length + kOverlap});
  }
  const float x = lattice_difference(wall.from.x, walker.at.x);
  const float y = lattice_difference(wall.from.y, walker.at.y);
  const bool front_before = x * wall.before_y - y * wall.before_x >= 0.0F;
  const float speed2 = walker.speed * walker.speed;
  if (wall.begins || (wall.corner && (front || front_before))) {
    still_discs_.add(x, y, 0.0F, 0.0F, contact, speed2);
  }
  if (wall.ends) {
    still_discs_.add(lattice_difference(wall.to.x, walker.at.x),
                     lattice_difference(wall.to.y, walker.at.y), 0.0F, 0.0F, contact, speed2);
  }
}

void Surroundings::add_standing(const Walker& walker) {
  for (const VehicleView& view : standing_) {
    add_vehicle(view, walker, still_discs_, still_faces_);
  }
  still_discs_.fill_group();
  still_faces_.fill_group();
}

void Surroundings::forget_vehicles() {
  vehicles_.clear();
  standing_.clear();
  vehicle_discs_.clear();
  vehicle_faces_.clear();
  hears_vehicle_ = threatened_ = false;
  nearest_bar_ = std::numeric_limits<float>::infinity();
}

void Surroundings::notice(const Walker& walker, const Senses& senses, const VehicleShape& vehicle,
                          float soon) {
  const VehicleView view = view_of(vehicle, walker);
  const Awareness aware = awareness(view, walker, senses);
  if (aware == Awareness::kNone) return;
  if (!vehicle.moving()) {
    if (view.distance <= walker.static_reach + view.contact) {
      standing_.push_back(view);
      nearest_bar_ = std::min(nearest_bar_, view.distance);
    }
    return;
  }
  // One that lets people go first is nothing to give way to, but still nothing to walk into.
  if (!vehicle.invites) vehicles_.push_back(view);
  hears_vehicle_ = hears_vehicle_ || aware == Awareness::kHeard;
  if (!touchable(view, walker, senses.sight / walker.speed)) return;
  add_vehicle(view, walker, vehicle_discs_, vehicle_faces_);
  if (vehicle.invites) nearest_bar_ = 0.0F;  // it drives: how far away it is now says little
  threatened_ = threatened_ || time_to_touch(view, walker, {}, 0.0F) < soon;
}

void Surroundings::fill(DirectionTask& task) const {
  task.near_discs = near_persons_.view();
  task.far_discs = far_persons_.view();
  task.vehicle_discs = vehicle_discs_.view();
  task.vehicle_faces = vehicle_faces_.view();
  task.still_discs = still_discs_.view();
  task.still_faces = still_faces_.view();
}

}  // namespace pedzone
