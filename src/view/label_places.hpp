// Places for labels in a picture, so that none covers another.
#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "zone/shapes.hpp"

namespace pedzone {

class LabelPlaces {
 public:
  /// Labels lie within `picture`, in its units.
  explicit LabelPlaces(const Box& picture) : picture_(picture) {}

  void keep_free(const Box& box) { taken_.push_back(box); }

  /// The middle of a free place for a label of that size, `distance` away from `at` to any side (0:
  /// right there); nothing where all are taken. The place is taken then.
  std::optional<Vec2> take(const Vec2& at, double distance, const Vec2& size);

 private:
  bool free(const Box& box) const;

  Box picture_;
  std::vector<Box> taken_;
};

}  // namespace pedzone
