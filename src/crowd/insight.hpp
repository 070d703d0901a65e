// What walked persons are about to do, for pictures.
#pragma once

#include <span>
#include <vector>

#include "crowd/state/state.hpp"

namespace pedzone {

/// Of those rows of Persons, in that order. Changes nothing that a later step depends on.
std::vector<Insight> look_into(CrowdState& crowd, std::span<const std::size_t> rows);

}  // namespace pedzone
