#include "study/measure/vehicle_stops.hpp"

#include "study/measure/pedestrians.hpp"

namespace pedzone::study {

void VehicleStops::step(std::span<const VehicleSample> vehicles) {
  for (const VehicleSample& vehicle : vehicles) {
    if (vehicle.part > 0) continue;
    bool& under_way = under_way_[std::string(vehicle.id)];
    const double speed = vehicle.velocity.norm();
    if (under_way && speed < kHaltingSpeed) {
      under_way = false;
      ++count_;
    } else if (speed > kUnderWay) {
      under_way = true;
    }
  }
}

}  // namespace pedzone::study
