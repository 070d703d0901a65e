// The summary of a run as a table for people and as JSON for programs.
#pragma once

#include <string>

#include "sumo/live/run_totals.hpp"

namespace pedzone {

std::string summary_table(const RunSummary& summary);
std::string summary_json(const RunSummary& summary);

}  // namespace pedzone
