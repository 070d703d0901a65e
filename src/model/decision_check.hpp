// Whether what a walking model of somebody else decides makes sense.
#pragma once

#include <string>

#include "model/walking_model.hpp"

namespace pedzone {

/// Throws InputError, naming the model by `whose`, where a decision is outside of Decision's
/// ranges. `preferred_speed` [m/s]: the person's.
void check_decision(const std::string& whose, const Decision& decision, double preferred_speed);

}  // namespace pedzone
