// How each person perceives at present, and which vehicles it minds.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// [m] assumed: longer vehicles are too high to see over.
constexpr double kLargeVehicle = 6.0;

/// Whether anybody perceives otherwise than the zone's parameters say.
bool perceives_otherwise(const CrowdState& crowd);

/// Sets how each perceives; it minds all vehicles.
void set_perceptions(const CrowdState& crowd, Attention& attention);

/// Looks round for everybody at the time `now` [s] of the crowd's clock: what each has noticed, how
/// it perceives, and which vehicles it does not mind.
void perceive(const CrowdState& crowd, double now, ByHandle<TrafficMemory>& memory,
              Attention& attention);

}  // namespace pedzone
