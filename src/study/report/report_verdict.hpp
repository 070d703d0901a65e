// The verdict of a study as sentences. Plain text: whoever writes a page escapes it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "study/compare/results.hpp"
#include "study/measure/measure_list.hpp"

namespace pedzone::study {

/// A sentence of which the beginning matters most.
struct Sentence {
  std::string head, rest;
  enum class Tone { kPlain, kBetter, kWorse, kWarning } tone = Tone::kPlain;
};

/// Whether the models' free speeds agree with the reference's. For each model a sentence on the
/// conditions in which they do not, one on those where that is not known, one on those where they
/// do.
std::vector<Sentence> free_speed_sentences(std::span<const FreeSpeed> speeds, const Plan& plan);

/// One difference that was found: by how much, how sure, better or worse for those concerned.
Sentence difference_sentence(const Comparison& comparison);

/// All that is said of one model in one condition, of measures of the primary family.
struct Verdict {
  std::vector<Sentence> different;
  Sentence hints, not_shown, inconclusive, same, too_few;  ///< no head where there is none
};
Verdict verdict_of(std::span<const Comparison> comparisons);

/// What one model changes by one measure over several conditions; no head where it was not found
/// different in any.
Sentence overall_sentence(std::span<const Comparison> comparisons, std::string_view measure);

/// How many comparisons came out how; no head where there are none.
Sentence tally_sentence(std::span<const Comparison> comparisons);

/// A measure inside a sentence: "people's travel time".
std::string measure_label(const Measure& measure);

/// Tone of a difference by the measure's sense.
Sentence::Tone tone_of(const Comparison& comparison);

}  // namespace pedzone::study
