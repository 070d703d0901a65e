// Who was to travel in a run, as checksums: runs of a fair pair have the same.
#pragma once

#include <map>
#include <string>

#include "study/measure/tripinfo_reader.hpp"

namespace pedzone::study {

/// "persons" and "vehicles": SHA-256 of their lines `id,type,intended departure [s]`, sorted.
std::map<std::string, std::string> demand_signature(const Trips& trips);

}  // namespace pedzone::study
