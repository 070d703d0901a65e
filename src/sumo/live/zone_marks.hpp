// Marks in a running SUMO on the zones that a pedzone walks, so that a second one keeps away.
#pragma once

#include <vector>

#include "sumo/calls/session.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// Marks the zones' edges by a parameter. Throws InputError where one is marked already.
void mark_zones(Session& sumo, const Network& network, const std::vector<Zone>& zones);
/// Takes the marks away.
void unmark_zones(Session& sumo, const Network& network, const std::vector<Zone>& zones);

}  // namespace pedzone
