// Who comes with whom, and when: groups and single persons of a panel.
#pragma once

#include <cstdint>
#include <vector>

#include "zone/panel.hpp"

namespace pedzone {

/// A group, or a person who walks alone.
struct Unit {
  int size = 1;
  double depart = 0.0;  ///< [s]
};

/// By departure. `begin`: of the simulation [s].
std::vector<Unit> plan_units(const PanelSpec& spec, std::uint64_t seed, double begin);

}  // namespace pedzone
