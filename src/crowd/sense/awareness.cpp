#include "crowd/sense/awareness.hpp"

#include "model/senses.hpp"
#include "model/vehicle_view.hpp"

namespace pedzone {

bool is_aware(const Persons& persons, std::size_t i, const VehicleState& vehicle,
              const Parameters& parameters, VehicleForm form) {
  const LatticeOrigin origin{to_lattice(vehicle.centre.x()), to_lattice(vehicle.centre.y())};
  const Senses senses = senses_of(parameters, form);
  const Walker walker = onlooker(persons, i, origin);
  const VehicleShape shape = shape_of(vehicle, origin);
  return awareness(view_of(shape, walker), walker, senses) != Awareness::kNone;
}

}  // namespace pedzone
