// Who meets nobody within a step of the simulation walks it at once, and not in substeps: on the
// sidewalks of a town these are most people.
#pragma once

#include <cstddef>
#include <vector>

#include "crowd/state/state.hpp"

namespace pedzone {

/// Puts those first who walk freely for `dt` [s], and tells how many they are. Free is who walks
/// along its route, alone, and could touch nobody even if both hurried towards each other; who has
/// no corner, destination or vehicle that it minds within reach; and who has nothing else to do.
std::size_t gather_free(CrowdState& crowd, double dt);

/// Sets the rows of the first `free` apart as `others`, behind those still to be walked. They are
/// where they were, with the velocity that brings them to their `ends` within `dt` [s].
void set_apart(CrowdState& crowd, std::size_t free, double dt, std::vector<FreeWalkEnd>& ends);

/// All are walked again; those that were set apart are at their ends.
void take_back(CrowdState& crowd, const std::vector<FreeWalkEnd>& ends);

}  // namespace pedzone
