// Whom vehicles pushed and ran into.
#pragma once

#include <map>
#include <string>

namespace pedzone::study {

/// Appends conflict.pushed, .pushWay, .pushSpeed and .runInto: as told by the folder's
/// summary.json, which pedzone writes; 0 where there is none, since SUMO's own models push nobody.
/// Throws InputError where the file is damaged.
void measure_pushes(const std::string& folder, std::map<std::string, double>& values);

}  // namespace pedzone::study
