#include "geometry/rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pedzone {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

}  // namespace

void cut_to_slab(double x, double w, double half, Stretch& stretch) {
  if (w == 0.0) {
    if (std::abs(x) > half) stretch.leave = -kForever;
    return;
  }
  const double a = (-half - x) / w, b = (half - x) / w;
  stretch.enter = std::max(stretch.enter, std::min(a, b));
  stretch.leave = std::min(stretch.leave, std::max(a, b));
}

double signed_distance(const Vec2& half, const Vec2& local) {
  const Vec2 out = local.cwiseAbs() - half;
  if (out.x() <= 0.0 && out.y() <= 0.0) return out.maxCoeff();
  return out.cwiseMax(0.0).norm();
}

double Rectangle::signed_distance(const Vec2& point) const {
  return pedzone::signed_distance(half, into_frame(point));
}

std::optional<double> first_within(const Vec2& half, const Vec2& at, const Vec2& velocity,
                                   double radius, double last) {
  Stretch inside{0.0, last};
  cut_to_slab(at.x(), velocity.x(), half.x() + radius, inside);
  cut_to_slab(at.y(), velocity.y(), half.y() + radius, inside);
  if (inside.empty()) return std::nullopt;
  const Vec2 entry = at + velocity * inside.enter;
  if (std::abs(entry.x()) <= half.x() || std::abs(entry.y()) <= half.y()) return inside.enter;
  // In the square about a round corner; whoever leaves it towards a side has met its circle.
  const Vec2 corner(std::copysign(half.x(), entry.x()), std::copysign(half.y(), entry.y()));
  const Vec2 to = entry - corner;
  const double c = to.squaredNorm() - radius * radius;
  if (c <= 0.0) return inside.enter;
  const double b = to.dot(velocity), square = b * b - velocity.squaredNorm() * c;
  if (b >= 0.0 || square < 0.0) return std::nullopt;
  const double touch = inside.enter + c / (std::sqrt(square) - b);
  return touch <= inside.leave ? std::optional(touch) : std::nullopt;
}

bool runs_through(const Rectangle& rectangle, const Vec2& a, const Vec2& b) {
  const Vec2 from = rectangle.into_frame(a), way = rectangle.into_frame(b) - from;
  Stretch inside{0.0, 1.0};
  cut_to_slab(from.x(), way.x(), rectangle.half.x(), inside);
  cut_to_slab(from.y(), way.y(), rectangle.half.y(), inside);
  return inside.enter < inside.leave;
}

}  // namespace pedzone
