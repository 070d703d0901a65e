// The two kinds of scenes of a report.
#pragma once

#include <vector>

#include "study/report/report.hpp"
#include "study/report/run_recording.hpp"

namespace pedzone::study {

/// For each scenario and each model but the reference: the pair of runs of the median seed in the
/// middle condition side by side, in its busiest window.
std::vector<ReportScene> median_scenes(const Store& store, const Plan& plan, const Records& records,
                                       RunPlaces& places);

/// For each model its most dangerous encounters in the zones in the whole study.
std::vector<ReportScene> encounter_scenes(const Store& store, const Plan& plan,
                                          const Records& records, RunPlaces& places);

}  // namespace pedzone::study
