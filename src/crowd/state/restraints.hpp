// What behaviours take from the decisions of the model: speed, never direction, but for who stands.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "model/walking_model.hpp"

namespace pedzone {

struct Restraint {
  double most_speed = std::numeric_limits<double>::infinity();  ///< [m/s] 0: stands
  bool waits = false;                                           ///< for a vehicle
  std::optional<double> facing;                                 ///< [rad] while it stands
};

/// Of each walked person, what all behaviours ask of it together: they agree on the least speed,
/// and whoever has it wait has it wait. Each person has its own place, as in Proposals.
class Restraints {
 public:
  void begin(std::size_t persons) { all_.assign(persons, {}); }

  void limit(std::size_t person, double speed) {
    all_[person].most_speed = std::min(all_[person].most_speed, speed);
  }
  void stand(std::size_t person) { all_[person].most_speed = 0.0; }
  void stand_facing(std::size_t person, double direction) {
    stand(person);
    all_[person].facing = direction;
  }
  void wait(std::size_t person) {
    stand(person);
    all_[person].waits = true;
  }

  /// Nothing else holds for that person.
  void replace(std::size_t person, const Restraint& restraint) { all_[person] = restraint; }

  /// To the decisions of all persons, in their order.
  void apply(std::vector<Decision>& decisions) const {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      decisions[i].speed = std::min(decisions[i].speed, all_[i].most_speed);
      decisions[i].waits = decisions[i].waits || all_[i].waits;
      if (all_[i].facing) decisions[i].direction = *all_[i].facing;
    }
  }

 private:
  std::vector<Restraint> all_;
};

}  // namespace pedzone
