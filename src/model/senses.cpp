#include "model/senses.hpp"

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"

namespace pedzone {
namespace {

void set_field(Senses& senses, double field_of_view) {
  const double half_field = field_of_view * kPi / 180.0;
  senses.field_of_view = field_of_view;
  senses.field_cos = static_cast<float>(std::cos(half_field));
  senses.field_sin = static_cast<float>(std::sin(half_field));
}

}  // namespace

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
  senses.hearing = static_cast<float>(parameters.hearing);
  set_field(senses, parameters.field_of_view);
  return senses;
}

Senses with(Senses senses, const Perception& perception) {
  senses.hearing = static_cast<float>(perception.hearing);
  if (perception.field_of_view != senses.field_of_view) set_field(senses, perception.field_of_view);
  return senses;
}

}  // namespace pedzone
