// What varies in a study: <factor> and <combination> of a study file.
#pragma once

#include <cstddef>

#include "core/xml.hpp"
#include "study/plan/study_file.hpp"

namespace pedzone::study {

inline constexpr std::size_t kMostRuns = 1'000'000;  ///< numerical: a plan is held in memory

/// Reads them into a study whose scenarios are there; all combinations where the file lists none.
/// Throws InputError.
void read_factors(const XmlFile& file, Study& study);

}  // namespace pedzone::study
