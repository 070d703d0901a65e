// The verdict on a model in one sentence.
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
  std::size_t main = 0, compared = 0, unsure = 0, hints = 0, pairs = 0, missing = 0;
  for (const Comparison& one : comparisons) {
    if (!is_main(one)) continue;
    ++main;
    pairs = std::max(pairs, one.difference.n);
    missing = std::max(missing, one.missing);
    if (one.finding == Finding::kTooFew) continue;
    ++compared;
    unsure += one.finding == Finding::kInconclusive ? 1 : 0;
    hints += one.finding == Finding::kHint && one.bound != Bound::kUnknown ? 1 : 0;
  }
  if (compared == 0 && pairs + missing >= kLeastPairs) {
    return {fmt::format("Too few runs are done to tell what {} changes", model),
            fmt::format(
                ": {} {} missing, since runs failed or are not there yet. Nothing was compared.",
                count_text(missing, "pair", "pairs"), missing == 1 ? "is" : "are")};
  }
  if (compared == 0) {
    const std::size_t more = kLeastPairs - std::min(pairs, kLeastPairs - 1);
    return {fmt::format("Too few seeds to tell what {} changes: run {} more", model, more),
            ". Nothing was compared."};
  }
  const std::string all = count_text(main, "comparison", "comparisons");
  if (hints > 0) {
    return {fmt::format("Nothing is certain from {} with {}", count_text(pairs, "seed", "seeds"),
                        model),
            fmt::format(": {} of {} {}, no more. Run more seeds to tell.", hints, all,
                        hints == 1 ? "is a hint" : "are hints")};
  }
  Sentence sentence{fmt::format("No difference was found with {}", model), "."};
  if (unsure > 0) {
    sentence.rest = fmt::format(", and for {} of {} there are too few seeds to tell.", unsure, all);
  }
  return sentence;
}

}  // namespace

Sentence summary_sentence(std::span<const Comparison> comparisons, const std::string& reference) {
  if (comparisons.empty()) return {};
  if (nobody_walked(comparisons)) {
    return {"Nobody walked in the zones", ": nothing was compared.", Sentence::Tone::kWarning};
  }
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

}  // namespace pedzone::study
