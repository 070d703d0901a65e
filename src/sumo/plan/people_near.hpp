// Whom one vehicle after the other may have to mind: of a town's people a few.
#pragma once

#include <span>
#include <vector>

#include "geometry/near_points.hpp"
#include "sumo/plan/yield_plan.hpp"

namespace pedzone {

class PeopleNear {
 public:
  /// `people` must outlive it.
  explicit PeopleNear(std::span<const PersonAhead> people);

  std::span<const PersonAhead> all() const { return people_; }
  /// Those within `reach` [m] of a place, and a few more, in their order.
  std::vector<PersonAhead> at(const Vec2& place, double reach) const;

 private:
  std::span<const PersonAhead> people_;
  NearPoints places_;
};

}  // namespace pedzone
