#include "crowd/state/proposals.hpp"

namespace pedzone {

Wish towards(const Vec2& way, Behaviour by) { return {angle_of(way), way.norm(), by}; }

void resolve(const Proposals& proposals, Persons& persons) {
  for (std::size_t i = 0; i < proposals.size(); ++i) {
    persons.goal_direction[i] = proposals.best(i).direction;
    persons.goal_distance[i] = proposals.best(i).distance;
  }
}

}  // namespace pedzone
