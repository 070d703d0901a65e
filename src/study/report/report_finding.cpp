#include "study/report/report_finding.hpp"

namespace pedzone::report {

const char* tone_class(Sentence::Tone tone) {
  switch (tone) {
    case Sentence::Tone::kBetter:
      return "better";
    case Sentence::Tone::kWorse:
      return "worse";
    case Sentence::Tone::kWarning:
      return "warning";
    case Sentence::Tone::kPlain:
      break;
  }
  return "plain";
}

std::string finding_text(const Comparison& one) {
  switch (one.finding) {
    case Finding::kDifferent: {
      const Sentence::Tone tone = tone_of(one);
      std::string text = one.difference.mean < 0.0 ? "lower" : "higher";
      if (tone == Sentence::Tone::kBetter) text += ": better";
      if (tone == Sentence::Tone::kWorse) text += ": worse";
      return text;
    }
    case Finding::kNotShown:
      return "no difference shown";
    case Finding::kInconclusive:
      return "cannot say";
    case Finding::kSame:
      return "equal";
    case Finding::kTooFew:
      break;
  }
  return "too few pairs";
}

std::string finding_class(const Comparison& one) {
  switch (one.finding) {
    case Finding::kDifferent:
      return std::string("different ") + tone_class(tone_of(one));
    case Finding::kNotShown:
      return "not-shown";
    case Finding::kInconclusive:
      return "inconclusive";
    case Finding::kSame:
      return "same";
    case Finding::kTooFew:
      break;
  }
  return "too-few";
}

}  // namespace pedzone::report
