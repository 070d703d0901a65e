// Whether a person is aware of a vehicle, as the model's perception has it.
#pragma once

#include "world/snapshot.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// The person of row `i` sees or hears the vehicle.
bool is_aware(const Persons& persons, std::size_t i, const VehicleState& vehicle, const Zone& zone);

}  // namespace pedzone
