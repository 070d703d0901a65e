// How a comparison came out, in a few words, and as a class of the style sheet.
#pragma once

#include <string>

#include "study/report/report_verdict.hpp"

namespace pedzone::study::report {

const char* tone_class(Sentence::Tone tone);
std::string finding_class(const Comparison& one);
/// "lower: better", "cannot say" ...
std::string finding_text(const Comparison& one);
/// For a narrow cell: the change in percent, in brackets where it is a hint, or a sign for none.
std::string finding_sign(const Comparison& one);

}  // namespace pedzone::study::report
