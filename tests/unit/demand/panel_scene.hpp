// People of a panel on the plaza of networks/.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "demand/people.hpp"

namespace pedzone::test {

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// A network with its zones, and panels for it.
struct PanelScene {
  explicit PanelScene(Network net);
  static PanelScene plaza();

  /// As an element of the zone file.
  PanelScene& add(const Attributes& attributes);
  /// What planning complains about; empty when it does not.
  std::string complaint() const;
  std::vector<PlannedPerson> people(std::uint64_t seed = 1, double begin = 0.0) const;
  std::string file(std::uint64_t seed) const;

  Network network;
  std::vector<Zone> zones;
  Profiles profiles;
  std::vector<PanelSpec> panels;
};

/// What reading these attributes complains about; empty when it does not.
std::string panel_complaint(const Attributes& attributes);

}  // namespace pedzone::test
