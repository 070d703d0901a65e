// The step of a crowd.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Walks everybody for `dt` [s] among crowd.seen and crowd.vehicles, in as many equal substeps as
/// keep each at most kLongestSubstep.
void walk(CrowdState& crowd, double dt);

/// Appends those who are only seen to those who are walked.
void append_seen(const CrowdState& crowd, Persons& persons);

/// Sets the length of every column.
void resize_rows(Persons& persons, std::size_t rows);

/// What everybody who is walked chooses by the model for the next `dt` [s], with those vehicles.
void decide(const CrowdState& crowd, double dt, std::span<const VehicleState> vehicles,
            std::vector<Decision>& decisions);

}  // namespace pedzone
