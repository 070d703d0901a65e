#include "study/measure/trip_measures.hpp"

namespace pedzone::study {
namespace {

/// What persons' and vehicles' trips have in common.
template <typename Trip>
void measure_all(const std::vector<Trip>& trips, double end, const std::string& who,
                 std::map<std::string, double>& values) {
  const auto count = static_cast<double>(trips.size());
  values[who + ".count"] = count;
  if (trips.empty()) return;
  double time = 0.0, arrived = 0.0;
  for (const Trip& trip : trips) {
    time += trip.arrival.value_or(end) - trip.due;
    if (trip.arrival) arrived += 1.0;
  }
  values[who + ".travelTime"] = time / count;
  values[who + ".arrived"] = arrived / count;
}

}  // namespace

void measure_trips(const Trips& trips, double end, std::map<std::string, double>& values) {
  measure_all(trips.persons, end, "person", values);
  measure_all(trips.vehicles, end, "vehicle", values);
  if (trips.vehicles.empty()) return;
  double delay = 0.0;
  for (const VehicleTrip& trip : trips.vehicles) delay += trip.time_loss + trip.depart_delay;
  values["vehicle.delay"] = delay / static_cast<double>(trips.vehicles.size());
}

}  // namespace pedzone::study
