// The verdict on a model in one sentence, and what the end of the runs cuts off.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "study/report/report_numbers.hpp"
#include "study/report/report_verdict.hpp"

namespace pedzone::study {
namespace {

constexpr std::size_t kMostTold = 3;  // differences in a sentence that is read once

/// What most people ask first; the other main measures follow in their order.
constexpr std::string_view kFirst[] = {"person.travelTime", "vehicle.travelTime",
                                       "conflict.serious",  "person.delay",
                                       "vehicle.delay",     "person.arrived"};

std::vector<std::string_view> by_interest() {
  std::vector<std::string_view> keys(std::begin(kFirst), std::end(kFirst));
  for (const Measure& measure : measure_list()) {
    const bool known = std::ranges::find(kFirst, measure.key) != std::end(kFirst);
    if (measure.primary && !known) keys.push_back(measure.key);
  }
  return keys;
}

/// Inside a sentence.
std::string lower(std::string text) {
  if (!text.empty()) {
    text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  }
  return text;
}

std::string without_stop(std::string text) {
  if (text.ends_with('.')) text.pop_back();
  return text;
}

bool is_main(const Comparison& one) {
  const Measure* const measure = find_measure(one.measure);
  return measure != nullptr && measure->primary;
}

/// Why no difference is told.
Sentence nothing_told(std::span<const Comparison> comparisons, const std::string& model) {
  std::size_t main = 0, compared = 0, unsure = 0, pairs = 0;
  for (const Comparison& one : comparisons) {
    if (!is_main(one)) continue;
    ++main;
    pairs = std::max(pairs, one.difference.n);
    if (one.finding == Finding::kTooFew) continue;
    ++compared;
    unsure += one.finding == Finding::kInconclusive ? 1 : 0;
  }
  if (compared == 0) {
    const std::size_t more = kLeastPairs - std::min(pairs, kLeastPairs - 1);
    return {fmt::format("Too few seeds to tell what {} changes: run {} more", model, more),
            ". Nothing was compared."};
  }
  Sentence sentence{fmt::format("No difference was found with {}", model), "."};
  if (unsure > 0) {
    sentence.rest = fmt::format(", and for {} of {} there are too few seeds to tell.", unsure,
                                count_text(main, "comparison", "comparisons"));
  }
  return sentence;
}

/// "62 %", or "62 % to 70 %" of several.
std::string range_text(const std::vector<double>& shares) {
  constexpr double kPercent = 100.0;
  const auto [low, high] = std::ranges::minmax(shares);
  const std::string least = percent_text(kPercent * low), most = percent_text(kPercent * high);
  return least == most ? least : least + " to " + most;
}

Sentence cut_off_sentence(std::span<const CutOff> cuts, const std::string& model,
                          const Plan& plan) {
  std::vector<double> reference, own;
  double end = 0.0;
  bool gets_there = true;
  for (const CutOff& cut : cuts) {
    reference.push_back(cut.reference);
    own.push_back(cut.model);
    end = std::max(end, cut.end.value_or(0.0));
    gets_there = gets_there && cut.end;
  }
  Sentence sentence;
  sentence.tone = Sentence::Tone::kWarning;
  sentence.head = "Warning: the end of the runs cuts off people's trips";
  if (plan.conditions.size() > 1) {
    sentence.head += fmt::format(" in {} of {} conditions", cuts.size(), plan.conditions.size());
  }
  sentence.rest = fmt::format(
      ": by then {} of them have arrived with {}, {} with {}. Their times are told as "
      "\u201cat least\u201d. ",
      range_text(reference), plan.study.reference, range_text(own), model);
  sentence.rest +=
      gets_there ? fmt::format("end=\"{:.0f}\" in the study file would let nearly all arrive.", end)
                 : std::string(
                       "In some runs nobody arrives any more in their last quarter: "
                       "no end may be late enough.");
  return sentence;
}

}  // namespace

Sentence summary_sentence(std::span<const Comparison> comparisons, const std::string& reference) {
  if (comparisons.empty()) return {};
  const std::string& model = comparisons.front().model;
  const bool several = std::ranges::any_of(comparisons, [&](const Comparison& one) {
    return one.condition != comparisons.front().condition;
  });
  std::vector<std::string> told;
  std::size_t main = 0, different = 0;
  for (const std::string_view key : by_interest()) {
    const Sentence overall = overall_sentence(comparisons, key);
    const bool found = !overall.head.empty();
    ++main;
    different += found ? 1 : 0;
    if (!found || told.size() == kMostTold) continue;
    const auto one = std::ranges::find(comparisons, key, &Comparison::measure);
    told.push_back(lower(several ? overall.head + without_stop(overall.rest)
                                 : difference_sentence(*one).head));
  }
  if (told.empty()) return nothing_told(comparisons, model);
  return {fmt::format("With {} instead of {}, {}", model, reference, joined(told)),
          fmt::format(". {} of {} main measures differ{}.", different, main,
                      several ? " in one condition or more" : "")};
}

std::vector<Sentence> cut_off_sentences(std::span<const Comparison> comparisons, const Plan& plan) {
  std::vector<Sentence> sentences;
  for (const std::string& model : plan.study.models) {
    std::vector<CutOff> cuts;
    for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
      if (const auto cut = cut_off(comparisons_of(comparisons, i, model))) cuts.push_back(*cut);
    }
    if (!cuts.empty()) sentences.push_back(cut_off_sentence(cuts, model, plan));
  }
  return sentences;
}

}  // namespace pedzone::study
