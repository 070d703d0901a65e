#include "conflict/search.hpp"

#include <algorithm>

namespace pedzone {
namespace {

constexpr double kRounding = 0.01;  // [m] numerical: ways are summed up in single precision

}  // namespace

void PersonExtremes::take(const PersonRow& person) {
  speed = std::max(speed, person.velocity.norm());
  radius = std::max(radius, person.radius);
  travelled = std::max(travelled, person.travelled);
  moved = std::max(moved, person.moved);
}

Search::Search(const Trail<VehiclePose>& trail, const Vec2& velocity, const Sizes& sizes,
               const PersonExtremes& most, const ConflictLimits& limits)
    : centre_(trail[0].centre),
      axis_(trail[0].axis),
      velocity_(velocity),
      body_(Vec2(sizes.half_length, sizes.half_width).norm()),
      horizon_(limits.horizon) {
  if (trail.size() > 1) moved_ = trail[0].travelled - trail[1].travelled;
  for (std::size_t k = 0; k < trail.size(); ++k) {
    const Vec2 at = to_frame(axis_, trail[k].centre - centre_);
    const Vec2 turned = to_frame(axis_, trail[k].axis).cwiseAbs();
    const double bulge = k > 0 ? bulge_between(trail[k], trail[k - 1], body_) : 0.0;
    const Vec2 extent(turned.x() * sizes.half_length + turned.y() * sizes.half_width + bulge,
                      turned.y() * sizes.half_length + turned.x() * sizes.half_width + bulge);
    low_ = low_.cwiseMin(at - extent);
    high_ = high_.cwiseMax(at + extent);
  }
  const double ahead = std::min((velocity.norm() + most.speed) * horizon_, limits.range);
  const double behind = (high_ - low_).norm() + most.moved;
  reach_ = body_ + most.radius + kRounding +
           std::max({ahead, behind, kNear + most.moved + moved_, most.travelled + moved_});
}

Search::Reasons Search::look_at(const PersonRow& person) const {
  const Vec2 to = person.at - centre_;
  const double room = to.norm() - body_ - person.radius - kRounding;
  const bool near = room <= kNear + person.moved + moved_;
  return {near,
          near || on_collision_course(person, to, room),
          {has_been_at(person, to), room <= person.travelled + moved_}};
}

/// Whether the vehicle has been where the person's last step was.
bool Search::has_been_at(const PersonRow& person, const Vec2& to) const {
  const Vec2 at = to_frame(axis_, to);
  const double beside = person.radius + person.moved + kRounding;
  return (at.array() >= low_.array() - beside).all() &&
         (at.array() <= high_.array() + beside).all();
}

/// Whether the relative way leads through the circle of both bodies, soon enough.
bool Search::on_collision_course(const PersonRow& person, const Vec2& to, double room) const {
  const Vec2 relative = person.velocity - velocity_;
  const double closing = -to.dot(relative), square = relative.squaredNorm();
  if (closing <= 0.0 || room * room > square * horizon_ * horizon_) return false;
  const double contact = body_ + person.radius + kRounding;
  return to.squaredNorm() * square - closing * closing <= contact * contact * square;
}

}  // namespace pedzone
