// What a validation found as one HTML page: tables, distributions, and the worst cases drawn.
#pragma once

#include <string>
#include <vector>

#include "validation/validation.hpp"

namespace pedzone {

/// The whole file, which fetches nothing. The last of the result's models is the one that the page
/// is about. Names from files are escaped.
std::string validation_page(const ValidationResult& result, const std::vector<DrawnCase>& worst);

}  // namespace pedzone
