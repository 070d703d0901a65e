#include "study/report/report_finding.hpp"

#include <algorithm>

#include "study/report/report_numbers.hpp"

namespace pedzone::study::report {
namespace {

struct Words {
  Finding finding;
  const char *style, *text, *sign;  ///< of hints and differences the text is about the direction
};
constexpr Words kWords[] = {{Finding::kDifferent, "different ", "", ""},
                            {Finding::kHint, "hint", "hint: ", ""},
                            {Finding::kNotShown, "not-shown", "no difference shown", "\u2248"},
                            {Finding::kInconclusive, "inconclusive", "cannot say", "?"},
                            {Finding::kSame, "same", "equal", "="},
                            {Finding::kTooFew, "too-few", "too few pairs", "\u2013"}};

const Words& words_of(Finding finding) {
  return *std::ranges::find(kWords, finding, &Words::finding);
}

bool has_direction(Finding finding) {
  return finding == Finding::kDifferent || finding == Finding::kHint;
}

}  // namespace

const char* tone_class(Sentence::Tone tone) {
  switch (tone) {
    case Sentence::Tone::kLower:
      return "lower";
    case Sentence::Tone::kHigher:
      return "higher";
    case Sentence::Tone::kWarning:
      return "warning";
    case Sentence::Tone::kPlain:
      break;
  }
  return "plain";
}

std::string finding_text(const Comparison& one) {
  if (one.bound == Bound::kUnknown) return "cut off";
  std::string text = words_of(one.finding).text;
  if (!has_direction(one.finding)) return text;
  text += one.difference.mean < 0.0 ? "lower" : "higher";
  return one.bound == Bound::kAtLeast ? text + ", at least" : text;
}

std::string finding_class(const Comparison& one) {
  if (one.bound == Bound::kUnknown) return "inconclusive";
  std::string style = words_of(one.finding).style;
  if (one.finding == Finding::kDifferent) style += tone_class(tone_of(one));
  return style;
}

std::string finding_sign(const Comparison& one) {
  if (one.bound == Bound::kUnknown) return "\u2702";
  if (!has_direction(one.finding)) return words_of(one.finding).sign;
  const auto percent = percent_of(one);
  std::string change =
      percent ? signed_percent(*percent) : signed_text(one.difference.mean, decimals_of(one));
  if (one.bound == Bound::kAtLeast) change += " \u2702";
  return one.finding == Finding::kHint ? "(" + change + ")" : change;
}

}  // namespace pedzone::study::report
