#include "geometry/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pedzone {

double length_of(std::span<const Vec2> line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

LinePoint point_on(std::span<const Vec2> line, double offset) { return LineWalk(line).to(offset); }

LineWalk::LineWalk(std::span<const Vec2> line)
    : line_(line), last_{line.empty() ? Vec2(0, 0) : line.front(), Vec2(1, 0)} {}

LinePoint LineWalk::to(double offset) {
  for (; next_ < line_.size(); ++next_) {
    const Vec2 piece = line_[next_] - line_[next_ - 1];
    const double length = piece.norm();
    if (length <= 0.0) continue;
    last_.direction = piece / length;
    if (offset <= passed_ + length) {
      last_.point = line_[next_ - 1] + last_.direction * std::max(0.0, offset - passed_);
      return last_;
    }
    passed_ += length;
    last_.point = line_[next_];
  }
  return last_;
}

void insert_point(double offset, Polyline& line) {
  double passed = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 piece = line[i] - line[i - 1];
    const double length = piece.norm(), into = offset - passed;
    if (into > 0.0 && into < length) {
      line.insert(line.begin() + static_cast<std::ptrdiff_t>(i),
                  line[i - 1] + piece * (into / length));
      return;
    }
    passed += length;
  }
}

LineProjection project_on(std::span<const Vec2> line, const Vec2& point) {
  LineProjection best{0.0, 0.0};
  double best_distance = std::numeric_limits<double>::infinity();
  double passed = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 piece = line[i] - line[i - 1];
    const double length = piece.norm();
    if (length <= 0.0) continue;
    const Vec2 direction = piece / length;
    const double along = std::clamp((point - line[i - 1]).dot(direction), 0.0, length);
    const Vec2 away = point - (line[i - 1] + direction * along);
    if (away.norm() < best_distance) {
      best_distance = away.norm();
      best = {passed + along, cross(direction, away) < 0.0 ? -best_distance : best_distance};
    }
    passed += length;
  }
  return best;
}

std::optional<LineStretch> stretch_within(std::span<const Vec2> line, const Vec2& point,
                                          double distance) {
  std::optional<LineStretch> stretch;
  double passed = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 piece = line[i] - line[i - 1];
    const double length = piece.norm();
    if (length <= 0.0) continue;
    const Vec2 direction = piece / length, there = point - line[i - 1];
    const double along = there.dot(direction), lateral = cross(direction, there);
    const double half = std::sqrt(std::max(0.0, distance * distance - lateral * lateral));
    const double begin = std::max(0.0, along - half), end = std::min(length, along + half);
    if (std::abs(lateral) <= distance && begin <= end) {
      if (!stretch) stretch = {passed + begin, passed + end};
      stretch->last = passed + end;
    }
    passed += length;
  }
  return stretch;
}

double most_cut(std::span<const Vec2> line, double length) {
  double turned = 0.0;
  Vec2 before = Vec2::Zero();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 piece = line[i] - line[i - 1];
    if (piece.isZero()) continue;
    if (!before.isZero()) turned += std::abs(std::atan2(cross(before, piece), before.dot(piece)));
    before = piece;
  }
  // The most at one corner in its middle: by half of it times sin, and shorter by 1 - cos < sin.
  return 0.5 * length * std::sin(0.5 * std::min(turned, kPi));
}

}  // namespace pedzone
