// How fast people would walk at present.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// By the weather and what each does beside walking; who runs in front of a vehicle runs. Who
/// stands still wants to walk as fast as ever: it stands by its decision (restrain_by_activity).
void set_paces(const CrowdState& crowd, std::vector<double>& preferred_speed);

}  // namespace pedzone
