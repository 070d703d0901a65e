// The page of `pedzone verify`: one file that needs no other.
#pragma once

#include <string>

#include "verify/verification.hpp"

namespace pedzone::verify {

/// Which `command` made it is told for those who want to repeat it.
std::string verification_page(const Verification& verification, const std::string& command);

/// "1.3 to 1.9", "≥ 26.0", or empty where a figure is only reported.
std::string limits_text(const FigureSpec& figure);

}  // namespace pedzone::verify
