// Everybody in and near the zones as one step of SUMO left them: what conflicts are measured on.
#pragma once

#include <memory>
#include <vector>

#include "conflict/tracker.hpp"
#include "sumo/live/takeover.hpp"

namespace pedzone {

/// Valid while it is observed.
struct Observation {
  double time = 0.0;  ///< [s] by which SUMO's own outputs name the step
  /// Those whom pedzone walks, then those near a zone whom SUMO walks, riders included.
  std::span<const PersonSample> persons;
  std::span<const VehicleSample> vehicles;  ///< within 60 m of a zone; of one that
                                            ///< bends, each part
  AwareOf aware;                            ///< not known of those whom SUMO walks
};

class ObservationReader {
 public:
  ObservationReader(const Fleet& fleet, Takeover& takeover,
                    const std::vector<std::unique_ptr<Crowd>>& crowds, const SumoPersons& sumo)
      : fleet_(fleet), takeover_(takeover), crowds_(crowds), sumo_(sumo) {}

  /// After fleet and takeover have read SUMO's state of the step named `time` [s].
  Observation read(double time);

 private:
  void add(const FleetVehicle& vehicle);
  void add_bystanders();
  std::optional<bool> aware(std::size_t person, std::size_t vehicle) const;

  const Fleet& fleet_;
  Takeover& takeover_;
  const std::vector<std::unique_ptr<Crowd>>& crowds_;
  const SumoPersons& sumo_;
  std::vector<PersonSample> persons_;
  std::vector<VehicleSample> vehicles_;
  std::vector<std::pair<double, double>> fronts_;  ///< [m] x, y of vehicles' reference points
  std::vector<std::string> ridden_;                ///< vehicles of those who ride
};

}  // namespace pedzone
