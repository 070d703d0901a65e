#include "study/measure/attendance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.hpp"

namespace pedzone::study {
namespace {

void refuse(const std::vector<std::string>& missing, const char* what, const char* output,
            const char* device, const std::string& scenario) {
  if (missing.empty()) return;
  throw InputError(
      fmt::format("SUMO's {} leaves out {} of the {}, such as '{}': a study measures everybody",
                  output, missing.size(), what, *std::ranges::min_element(missing)),
      {.file = scenario,
       .allowed =
           fmt::format("no parameter has.{}.device that is false, of anybody or a vType", device)});
}

}  // namespace

void Attendance::step(std::span<const PersonSample> persons,
                      std::span<const VehicleSample> vehicles) {
  const auto note = [](std::string_view id, Ids& ids) {
    if (!ids.contains(id)) ids.emplace(id);
  };
  for (const PersonSample& person : persons) note(person.id, persons_);
  for (const VehicleSample& vehicle : vehicles) note(vehicle.id, vehicles_);
}

void Attendance::check(const Trips& trips, double dt, double end,
                       const std::string& scenario) const {
  std::vector<std::string> persons, vehicles, trips_missing;
  for (const PersonTrip& trip : trips.persons) {
    const bool walks = std::ranges::any_of(trip.walks, [&](const WalkStage& walk) {
      return walk.arrival.value_or(end) - walk.depart >= 2.0 * dt;
    });
    if (walks && !persons_.contains(trip.id)) persons.push_back(trip.id);
  }
  Ids known;
  for (const VehicleTrip& trip : trips.vehicles) {
    known.insert(trip.id);
    const double drives = trip.arrival.value_or(end) - trip.due - trip.depart_delay;
    if (trip.departed && drives >= 2.0 * dt && !vehicles_.contains(trip.id)) {
      vehicles.push_back(trip.id);
    }
  }
  for (const std::string& id : vehicles_) {
    if (!known.contains(id)) trips_missing.push_back(id);
  }
  refuse(persons, "persons", "fcd-output", "fcd", scenario);
  refuse(vehicles, "vehicles", "fcd-output", "fcd", scenario);
  refuse(trips_missing, "vehicles", "tripinfo-output", "tripinfo", scenario);
}

}  // namespace pedzone::study
