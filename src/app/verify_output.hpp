// What `pedzone verify` prints and writes beside its page.
#pragma once

#include <string>

#include "verify/verification.hpp"

namespace pedzone {

/// For a terminal: each test, its figures with their limits, all models side by side.
std::string verification_table(const verify::Verification& verification);
/// The same with curves, for programs.
std::string verification_json(const verify::Verification& verification);
/// Ids, titles and sources of all tests.
std::string test_list_text();

}  // namespace pedzone
