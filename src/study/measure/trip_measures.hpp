// Measures of whole trips, of people and vehicles.
//
// Over all who were due to depart before the end of the run, whether they departed, arrived or not:
// the same in every run of a fair pair. Were those left out who did not get through, a model that
// jams would look fast. What had not happened by the end counts up to the end; so times are least
// ones as far as the shares arrived are below 1.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/measure/tripinfo_reader.hpp"

namespace pedzone::study {

/// The 85th and 95th percentile of a sample as KEY85 and KEY95; nothing of an empty one.
void add_percentiles(const std::string& key, const std::vector<double>& sample,
                     std::map<std::string, double>& values);

/// Appends person.travelTime, its percentiles, person.arrived, person.count, vehicle.travelTime,
/// vehicle.delay, vehicle.arrived, vehicle.count. `trips`: settled at the end of the run [s] `end`.
void measure_trips(const Trips& trips, double end, std::map<std::string, double>& values);

}  // namespace pedzone::study
