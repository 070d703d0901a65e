#include "model/senses.hpp"

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"

namespace pedzone {

bool minds_discomfort(const Parameters& parameters, VehicleForm form) {
  return form == VehicleForm::kDiscomfort && parameters.discomfort > 0.0;
}

Senses senses_of(const Parameters& parameters, VehicleForm form) {
  const double vehicle_sight = minds_discomfort(parameters, form)
                                   ? std::max(parameters.sight, parameters.vehicle_sight)
                                   : parameters.sight;
  Senses senses;
  senses.sight = static_cast<float>(parameters.sight);
  senses.vehicle_sight = static_cast<float>(vehicle_sight);
  return with(senses, {parameters.field_of_view, parameters.hearing, 1.0});
}

Senses with(Senses senses, const Perception& perception) {
  const double half_field = perception.field_of_view * kPi / 180.0;
  senses.hearing = static_cast<float>(perception.hearing);
  senses.field_cos = static_cast<float>(std::cos(half_field));
  senses.field_sin = static_cast<float>(std::sin(half_field));
  return senses;
}

}  // namespace pedzone
