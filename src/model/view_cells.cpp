#include "model/view_cells.hpp"

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"

namespace pedzone {
namespace {

constexpr double kSectorWidth = 2.0 * kPi / static_cast<double>(ViewCells::kSectors);
/// [rad], [m] added to the view. Numerical: protects from rounding at the borders.
constexpr double kMargin = 1e-4;

struct Box {
  double left, low, right, high;
  bool contains(double x, double y) const {
    return x >= left && x <= right && y >= low && y <= high;
  }
};

/// Whether the ray from the origin meets the box.
bool ray_meets(const Vec2& direction, const Box& box) {
  double enter = 0.0, leave = 1e9;
  const auto cut = [&](double d, double low, double high) {
    if (std::abs(d) < 1e-12) {
      if (low > 0.0 || high < 0.0) leave = -1.0;
      return;
    }
    enter = std::max(enter, std::min(low / d, high / d));
    leave = std::min(leave, std::max(low / d, high / d));
  };
  cut(direction.x(), box.left, box.right);
  cut(direction.y(), box.low, box.high);
  return enter <= leave;
}

/// Whether the cone about `middle` with half angle `half` [rad] meets the box.
bool cone_meets(double middle, double half, const Box& box) {
  if (half >= kPi || box.contains(0.0, 0.0)) return true;
  for (const double x : {box.left, box.right}) {
    for (const double y : {box.low, box.high}) {
      if (std::abs(wrap_angle(std::atan2(y, x) - middle)) <= half) return true;
    }
  }
  return ray_meets(unit(middle - half), box) || ray_meets(unit(middle + half), box);
}

bool circle_meets(double radius, const Box& box) {
  const double x = std::max({box.left, -box.right, 0.0});
  const double y = std::max({box.low, -box.high, 0.0});
  return std::hypot(x, y) <= radius;
}

}  // namespace

std::size_t ViewCells::sector(double heading) {
  const auto s = static_cast<std::ptrdiff_t>(std::floor((heading + kPi) / kSectorWidth));
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(s, 0, static_cast<std::ptrdiff_t>(kSectors) - 1));
}

ViewCells::ViewCells(double sight, double half_field, double width, double height) {
  columns_ = static_cast<int>(std::ceil(sight / width)) + 1;
  rows_ = static_cast<int>(std::ceil(sight / height)) + 1;
  start_.push_back(0);
  for (std::size_t s = 0; s < kSectors; ++s) {
    const double middle = -kPi + (static_cast<double>(s) + 0.5) * kSectorWidth;
    const double half = half_field + kSectorWidth / 2.0 + kMargin;
    for (int row = -rows_; row <= rows_; ++row) {
      bool open = false;  // the last run may go on
      for (int column = -columns_; column <= columns_; ++column) {
        // Where somebody in that cell can be relative to somebody anywhere in the middle one.
        const Box box{(column - 1) * width, (row - 1) * height, (column + 1) * width,
                      (row + 1) * height};
        const bool meets = circle_meets(sight + kMargin, box) && cone_meets(middle, half, box);
        if (meets && open) runs_.back().right = column;
        if (meets && !open) runs_.push_back({row, column, column});
        open = meets;
      }
    }
    start_.push_back(runs_.size());
  }
}

}  // namespace pedzone
