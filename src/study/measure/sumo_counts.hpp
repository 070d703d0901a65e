// What SUMO counts itself in a run: jams of people, teleports of vehicles.
#pragma once

#include <map>
#include <string>

namespace pedzone::study {

/// Appends
/// - person.jams, how often people were stuck among people until their model let them squeeze
///   through: the jams that SUMO counts of those whom it walks (`jammed` of statistics.xml), and
///   those of people whom pedzone walks (`jams` of summary.json, where the folder has one);
/// - vehicle.teleports, those of statistics.xml.
/// Nothing without statistics.xml. Throws InputError where a file is damaged.
void take_sumo_counts(const std::string& folder, std::map<std::string, double>& values);

}  // namespace pedzone::study
