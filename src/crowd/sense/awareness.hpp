// Whether a person is aware of a vehicle, as the model's perception has it.
#pragma once

#include "model/walking_model.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

/// The person of row `i` sees or hears the vehicle, with a model that minds vehicles in that form.
bool is_aware(const Persons& persons, std::size_t i, const VehicleState& vehicle,
              const Parameters& parameters, VehicleForm form);

}  // namespace pedzone
