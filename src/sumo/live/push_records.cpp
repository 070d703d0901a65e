#include "sumo/live/push_records.hpp"

#include <algorithm>

#include "core/random.hpp"

namespace pedzone {
namespace {

// [s] assumed: whom it meets later it could have braked for. One that drives to a zone is near it
// for longer before it is among people.
constexpr double kJustInserted = 3.0;

}  // namespace

// The crowds know keys only. Few are run into: to look through all is cheap enough.

std::string PushRecords::person(std::uint64_t key) const {
  const auto found = std::ranges::find_if(
      takeover_.guests(), [&](const Guest& guest) { return person_key(guest.id) == key; });
  return found != takeover_.guests().end() ? found->id : std::string();
}

const FleetVehicle* PushRecords::vehicle(std::uint64_t key) const {
  const auto found = std::ranges::find_if(fleet_.vehicles(), [&](const FleetVehicle& vehicle) {
    return person_key(vehicle.id) == key;
  });
  return found != fleet_.vehicles().end() ? &*found : nullptr;
}

std::vector<std::string> PushRecords::take(double time, double dt) {
  std::vector<std::string> vehicles;
  for (std::size_t z = 0; z < crowds_.size(); ++z) {
    const std::size_t known = log_.run_into().size();
    log_.add(time, dt, crowds_[z]->pushes());
    for (std::size_t k = known; k < log_.run_into().size(); ++k) {
      const RunInto& event = log_.run_into()[k];
      const FleetVehicle* const by = vehicle(event.vehicle);
      run_into_.push_back({event.time, person(event.person), by != nullptr ? by->id : std::string(),
                           zones_[z].id, event.speed, event.position,
                           by != nullptr && by->seen_for < kJustInserted});
    }
    for (const VehiclePush& push : crowds_[z]->pushes()) {
      if (!push.run_into) continue;
      if (const FleetVehicle* const by = vehicle(push.vehicle)) vehicles.push_back(by->id);
    }
  }
  return vehicles;
}

}  // namespace pedzone
