// What `pedzone validate` and `pedzone calibrate` print and write.
#pragma once

#include <string>

#include "validation/calibration.hpp"
#include "validation/validation.hpp"

namespace pedzone {

std::string validation_table(const ValidationResult& result);
std::string validation_json(const ValidationResult& result);

std::string calibration_table(const CalibrationResult& result);
std::string calibration_json(const CalibrationResult& result);
/// src/world/calibrated.inc: the defaults of parameter_list(), with the scores they come from.
std::string calibrated_include(const CalibrationResult& result, const CalibrationOptions& options);
/// src/validation/tuned_clips.inc: the clips of `data` that they come from.
std::string tuned_include(const std::vector<Clip>& data);
/// A zone file with these parameters.
std::string calibrated_zone(const CalibrationResult& result);

}  // namespace pedzone
