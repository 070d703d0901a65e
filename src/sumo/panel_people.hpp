// People of a study's panels, in the form in which SUMO takes them.
#pragma once

#include <cstdio>
#include <memory>
#include <vector>

#include "sumo/simulation.hpp"

namespace pedzone {

/// The panels' people as a file that SUMO reads when it starts. It has no name, so that nothing of
/// it is left however the process ends.
class PanelPeople {
 public:
  /// Throws std::runtime_error where it cannot be written, and what people_file() throws.
  PanelPeople(const SimulationOptions& options, const Network& network,
              const std::vector<Zone>& zones);

  /// The scenario with that file.
  const Scenario& scenario() const { return scenario_; }

 private:
  Scenario scenario_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, std::fclose};
};

}  // namespace pedzone
