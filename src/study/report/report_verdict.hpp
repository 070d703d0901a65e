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
  /// Lower or higher says nothing about good or bad: models are no designs.
  enum class Tone { kPlain, kLower, kHigher, kWarning } tone = Tone::kPlain;
};

/// Whether the models' free speeds agree with the reference's. For each model a sentence on the
/// conditions in which they do not, one on those where that is not known, one on those where they
/// do.
std::vector<Sentence> free_speed_sentences(std::span<const FreeSpeed> speeds, const Plan& plan);

/// How much of the differences of times and ways is there without others, too, and how much comes
/// from interaction; no head where it is not known. `comparisons`: of one model in one condition.
Sentence interaction_sentence(std::span<const Comparison> comparisons, const FreeSpeed& free);

/// The whole verdict on one model in one sentence: the differences that matter most, how many there
/// are, or why none is told. `comparisons`: all of that model, in one condition or several.
Sentence summary_sentence(std::span<const Comparison> comparisons, const std::string& reference);

/// Whether nobody has walked in a zone by either model. `comparisons`: as summary_sentence().
bool nobody_walked(std::span<const Comparison> comparisons);

/// What throws doubt on all that is told of a model: nobody walked in the zones; the end of the
/// runs cuts off people's trips, with the `end` that would do; SUMO teleported vehicles.
std::vector<Sentence> warning_sentences(std::span<const Comparison> comparisons, const Plan& plan);

/// One difference that was found: by how much, how sure.
Sentence difference_sentence(const Comparison& comparison);

/// All that is said of one model in one condition, of measures of the primary family.
struct Verdict {
  std::vector<Sentence> different;
  Sentence hints, not_shown, inconclusive, same, too_few, cut_off;  ///< no head: there is none
};
Verdict verdict_of(std::span<const Comparison> comparisons);

/// What one model changes by one measure over several conditions; no head where it was not found
/// different in any.
Sentence overall_sentence(std::span<const Comparison> comparisons, std::string_view measure);

/// How many comparisons came out how; no head where there are none.
Sentence tally_sentence(std::span<const Comparison> comparisons);

/// A measure inside a sentence: "people's travel time".
std::string measure_label(const Measure& measure);

Sentence::Tone tone_of(const Comparison& comparison);

/// Whether a difference was found that the end of the runs does not throw doubt on.
bool is_told(const Comparison& comparison);

}  // namespace pedzone::study
