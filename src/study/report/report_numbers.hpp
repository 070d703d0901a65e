// Numbers of the report as text: with as many digits as they deserve.
#pragma once

#include <optional>
#include <string>

#include "study/compare/results.hpp"

namespace pedzone::study {

/// Decimals with which a number is told that is known to within `uncertainty` (>= 0): two digits
/// of it. 0 to 6.
int decimals_for(double uncertainty);

/// With the typographic minus, never "-0".
std::string number_text(double value, int decimals);
/// The same with a plus where it is positive.
std::string signed_text(double value, int decimals);
/// "3.2 s"; `unit` may be empty.
std::string with_unit(const std::string& number, std::string_view unit);
/// With three significant digits; a dash where it is unset.
std::string digits_text(const std::optional<double>& value);
/// A sample's mean with so many decimals; a dash where it has none.
std::string mean_text(const SampleSummary& sample, int decimals);

/// "1 run", "2 runs".
std::string count_text(std::size_t count, std::string_view one, std::string_view more);
/// "a", "a and b", "a, b and c".
std::string joined(const std::vector<std::string>& words);

/// Decimals that a comparison's difference and interval are told with.
int decimals_of(const Comparison& comparison);
/// The difference in percent of the reference's mean; unset where that is 0, negative or unknown,
/// and where more than all of it would be gone.
std::optional<double> percent_of(const Comparison& comparison);
/// "14 %" of an absolute value: a digit after the point below 10.
std::string percent_text(double percent);
std::string signed_percent(double percent);

}  // namespace pedzone::study
