#include "crowd/sense/awareness.hpp"

#include <cmath>

#include "model/senses.hpp"
#include "model/vehicle_view.hpp"

namespace pedzone {

bool is_aware(const Persons& persons, std::size_t i, const VehicleState& vehicle,
              const Parameters& parameters, VehicleForm form) {
  const LatticeOrigin origin{to_lattice(vehicle.centre.x()), to_lattice(vehicle.centre.y())};
  const Senses senses = senses_of(parameters, form);
  Walker walker;
  walker.at = to_lattice(persons.x[i], persons.y[i], origin);
  walker.heading = persons.heading[i];
  walker.heading_cos = static_cast<float>(std::cos(walker.heading));
  walker.heading_sin = static_cast<float>(std::sin(walker.heading));
  walker.radius = static_cast<float>(persons.radius[i]);
  const VehicleShape shape = shape_of(vehicle, origin);
  return awareness(view_of(shape, walker), walker, senses) != Awareness::kNone;
}

}  // namespace pedzone
