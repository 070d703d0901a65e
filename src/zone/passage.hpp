// Whether people can get from one place to another within an area.
#pragma once

#include <vector>

#include "zone/shapes.hpp"

namespace pedzone {

/// Least distance to walls at which a body passes [m]; the way finder's narrowest passage is
/// 2·0.2 m wide (way_finder.hpp), so what passes here passes there.
constexpr double kBodyRoom = 0.25;

/// The parts of an area between which nobody passes.
class Passages {
 public:
  /// Passages narrower than twice `room` [m] do not count.
  explicit Passages(const Region& area, double room = kBodyRoom);

  /// Whether one can pass from a to b. Both may lie up to `room` outside of where a body stands.
  bool joins(const Vec2& a, const Vec2& b) const;

  /// The part that a place lies in or within `room` of, -1 when there is none.
  int part_of(const Vec2& place) const;

  const Region& parts() const { return parts_; }

 private:
  Region parts_;
  std::vector<Box> boxes_;
  double room_;
};

/// The pieces of `area` within `box`.
Region clip(const Region& area, const Box& box);

}  // namespace pedzone
