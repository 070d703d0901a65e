#include "study/measure/trip_measures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/statistics.hpp"

namespace pedzone::study {
namespace {

constexpr double kNearlyAll = 0.99;  // usual: some never arrive, whatever the model
constexpr double kLastPart = 0.25;   // of the run, from which it is foreseen how it would go on

/// [s] when nearly all have arrived, as foreseen where that is after `end`; unset where in the last
/// part of the run nobody arrived.
std::optional<double> nearly_all(const std::vector<PersonTrip>& trips, double end) {
  std::vector<double> arrivals;
  double first = end;
  for (const PersonTrip& trip : trips) {
    if (trip.arrival) arrivals.push_back(*trip.arrival);
    first = std::min(first, trip.due);
  }
  std::ranges::sort(arrivals);
  const auto wanted =
      static_cast<std::size_t>(std::ceil(kNearlyAll * static_cast<double>(trips.size())));
  if (arrivals.size() >= wanted) return arrivals[wanted - 1];
  const double last_part = kLastPart * (end - first);
  const auto late = arrivals.end() - std::ranges::upper_bound(arrivals, end - last_part);
  if (late == 0) return {};
  const auto missing = static_cast<double>(wanted - arrivals.size());
  return end + missing * last_part / static_cast<double>(late);
}

/// What persons' and vehicles' trips have in common.
template <typename Trip>
void measure_all(const std::vector<Trip>& trips, double end, const std::string& who,
                 std::map<std::string, double>& values) {
  const auto count = static_cast<double>(trips.size());
  values[who + ".count"] = count;
  if (trips.empty()) return;
  double arrived = 0.0;
  std::vector<double> times;
  for (const Trip& trip : trips) {
    times.push_back(trip.arrival.value_or(end) - trip.due);
    if (trip.arrival) arrived += 1.0;
  }
  values[who + ".travelTime"] = mean(times);
  if (who == "person") add_percentiles("person.travelTime", times, values);
  values[who + ".arrived"] = arrived / count;
}

}  // namespace

void add_percentiles(const std::string& key, const std::vector<double>& sample,
                     std::map<std::string, double>& values) {
  if (sample.empty()) return;
  values[key + "85"] = quantile(sample, 0.85);
  values[key + "95"] = quantile(sample, 0.95);
}

void measure_trips(const Trips& trips, double end, std::map<std::string, double>& values) {
  measure_all(trips.persons, end, "person", values);
  measure_all(trips.vehicles, end, "vehicle", values);
  if (!trips.persons.empty()) {
    if (const auto when = nearly_all(trips.persons, end)) values["person.nearlyAll"] = *when;
  }
  if (trips.vehicles.empty()) return;
  double delay = 0.0;
  for (const VehicleTrip& trip : trips.vehicles) delay += trip.time_loss + trip.depart_delay;
  values["vehicle.delay"] = delay / static_cast<double>(trips.vehicles.size());
}

}  // namespace pedzone::study
