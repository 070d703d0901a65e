#include "model/senses.hpp"

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"
#include "model/trigonometry.hpp"

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

Walker onlooker(const Persons& persons, std::size_t i, const LatticeOrigin& origin) {
  Walker w;
  w.at = to_lattice(persons.x[i], persons.y[i], origin);
  w.heading = wrapped(persons.heading[i]);
  const SineCosine heading = sine_cosine(w.heading);
  w.heading_cos = static_cast<float>(heading.cos);
  w.heading_sin = static_cast<float>(heading.sin);
  w.vx = static_cast<float>(persons.vx[i]);
  w.vy = static_cast<float>(persons.vy[i]);
  w.radius = static_cast<float>(persons.radius[i]);
  w.turned_radius = static_cast<float>(persons.turned_radius[i]);
  return w;
}

}  // namespace pedzone
