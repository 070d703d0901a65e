// Measures of whole trips, of people and vehicles.
//
// Over all who were due to depart before the end of the run, whether they departed, arrived or not:
// the same in every run of a fair pair. Were those left out who did not get through, a model that
// jams would look fast. What had not happened by the end counts up to the end; so times are least
// ones as far as the shares arrived are below 1.
#pragma once

#include <map>
#include <string>

#include "study/measure/tripinfo_reader.hpp"

namespace pedzone::study {

/// Appends person.travelTime, person.arrived, person.count, vehicle.travelTime, vehicle.delay,
/// vehicle.arrived, vehicle.count. `trips`: settled at the end of the run [s] `end`.
void measure_trips(const Trips& trips, double end, std::map<std::string, double>& values);

}  // namespace pedzone::study
