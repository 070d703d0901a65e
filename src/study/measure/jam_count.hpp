// How often people were stuck among people until their model let them squeeze through.
#pragma once

#include <map>
#include <string>

namespace pedzone::study {

/// Appends person.jams: the jams that SUMO counts of those whom it walks (`jammed` of
/// statistics.xml), and those of people whom pedzone walks (`jams` of summary.json, where the
/// folder has one). Nothing without statistics.xml. Throws InputError where a file is damaged.
void count_jams(const std::string& folder, std::map<std::string, double>& values);

}  // namespace pedzone::study
