// What a run's record has to say, if anything.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "study/run/record.hpp"

namespace pedzone::study {

bool is_done(const std::optional<RunRecord>& record);
/// For tables: done, failed, or missing (not run yet, or to be run again).
std::string_view table_status(const std::optional<RunRecord>& record);
/// A measure of a run that is done; unset where it is undefined.
std::optional<double> measured(const std::optional<RunRecord>& record, const std::string& key);

}  // namespace pedzone::study
