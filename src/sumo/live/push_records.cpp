#include "sumo/live/push_records.hpp"

#include <algorithm>

#include "core/random.hpp"

namespace pedzone {

// The crowds know keys only. Few are run into: to look through all is cheap enough.

std::string PushRecords::person(std::uint64_t key) const {
  const auto found = std::ranges::find_if(
      takeover_.guests(), [&](const Guest& guest) { return person_key(guest.id) == key; });
  return found != takeover_.guests().end() ? found->id : std::string();
}

std::string PushRecords::vehicle(std::uint64_t key) const {
  const auto found = std::ranges::find_if(fleet_.vehicles(), [&](const FleetVehicle& vehicle) {
    return person_key(vehicle.id) == key;
  });
  return found != fleet_.vehicles().end() ? found->id : std::string();
}

std::vector<std::string> PushRecords::take(double time, double dt) {
  std::vector<std::string> vehicles;
  for (std::size_t z = 0; z < crowds_.size(); ++z) {
    const std::size_t known = log_.run_into().size();
    log_.add(time, dt, crowds_[z]->pushes());
    for (std::size_t k = known; k < log_.run_into().size(); ++k) {
      const RunInto& event = log_.run_into()[k];
      run_into_.push_back({event.time, person(event.person), vehicle(event.vehicle), zones_[z].id,
                           event.speed, event.position});
    }
    for (const VehiclePush& push : crowds_[z]->pushes()) {
      if (push.run_into) vehicles.push_back(vehicle(push.vehicle));
    }
  }
  return vehicles;
}

}  // namespace pedzone
