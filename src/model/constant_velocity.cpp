#include "model/constant_velocity.hpp"

namespace pedzone {

void ConstantVelocityModel::decide(std::size_t first, std::size_t last,
                                   std::span<Decision> decisions) const {
  const Persons& persons = *snapshot_.persons;
  for (std::size_t i = first; i < last; ++i) {
    decisions[i] = {.direction = persons.goal_direction[i],
                    .speed = persons.preferred_speed[i],
                    .free_distance = snapshot_.parameters->sight};
  }
}

}  // namespace pedzone
