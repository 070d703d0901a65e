// What throws doubt on all that is told of a model: nobody was there, trips were cut off, vehicles
// were put farther on.
#include <fmt/format.h>

#include <algorithm>

#include "study/report/report_numbers.hpp"
#include "study/report/report_verdict.hpp"

namespace pedzone::study {
namespace {

/// "62 %", or "62 % to 70 %" of several.
std::string range_text(const std::vector<double>& shares) {
  constexpr double kPercent = 100.0;
  const auto [low, high] = std::ranges::minmax(shares);
  const std::string least = percent_text(kPercent * low), most = percent_text(kPercent * high);
  return least == most ? least : least + " to " + most;
}

/// " in 2 of 3 conditions"; nothing of a study that has one.
std::string in_conditions(std::size_t count, const Plan& plan) {
  if (plan.conditions.size() == 1) return {};
  return fmt::format(" in {} of {} conditions", count, plan.conditions.size());
}

Sentence cut_off_sentence(std::span<const CutOff> cuts, const std::string& model,
                          const Plan& plan) {
  std::vector<double> reference, own;
  double end = 0.0;
  bool gets_there = true, all_apart = true;
  for (const CutOff& cut : cuts) {
    reference.push_back(cut.reference);
    own.push_back(cut.model);
    end = std::max(end, cut.end.value_or(0.0));
    gets_there = gets_there && cut.end;
    all_apart = all_apart && cut.apart;
  }
  Sentence sentence;
  sentence.tone = Sentence::Tone::kWarning;
  sentence.head = "Warning: the end of the runs cuts off people's trips";
  sentence.head += in_conditions(cuts.size(), plan);
  sentence.rest = fmt::format(
      ": by then {} of them have arrived with {}, {} with {}. Their times are told as "
      "\u201cat least\u201d{}. ",
      range_text(reference), plan.study.reference, range_text(own), model,
      all_apart ? "" : ", or not at all");
  sentence.rest +=
      gets_there ? fmt::format("end=\"{:.0f}\" in the study file would let nearly all arrive.", end)
                 : std::string(
                       "In some runs nobody arrives any more in their last quarter: "
                       "no end may be late enough.");
  return sentence;
}

Sentence nobody_sentence(std::size_t conditions, const Plan& plan) {
  return {"Warning: nobody walked in the zones" + in_conditions(conditions, plan),
          ": all models do the same there. Does a zone lie where people walk? pedzone inspect "
          "shows its edges.",
          Sentence::Tone::kWarning};
}

/// Of one measure of a model and of the reference, over all conditions that have it.
struct Totals {
  double reference = 0.0, own = 0.0;  ///< sums of the means
  std::size_t all = 0, any = 0;       ///< conditions; of them those in which it is not 0 with both
};

Totals totals_of(std::span<const Comparison> comparisons, const std::string& model,
                 std::string_view measure) {
  Totals totals;
  for (const Comparison& one : comparisons) {
    if (one.model != model || one.measure != measure || !one.reference.mean) continue;
    totals.reference += *one.reference.mean;
    const double own = one.sample.mean.value_or(0.0);
    totals.own += own;
    ++totals.all;
    totals.any += *one.reference.mean + own != 0.0 ? 1 : 0;
  }
  return totals;
}

/// SUMO's teleports, means over the runs of all conditions that have some with the model or the
/// reference.
Sentence teleport_sentence(std::span<const Comparison> comparisons, const std::string& model,
                           const Plan& plan) {
  const Totals teleports = totals_of(comparisons, model, "vehicle.teleports");
  if (teleports.any == 0) return {};
  const double share = 1.0 / static_cast<double>(teleports.any);
  return {"Warning: SUMO teleported vehicles" + in_conditions(teleports.any, plan),
          fmt::format(", {} a run with {} and {} with {}: their trips are shorter by that.",
                      number_text(share * teleports.reference, 1), plan.study.reference,
                      number_text(share * teleports.own, 1), model),
          Sentence::Tone::kWarning};
}

/// Of the one of the two models whose people jump more; empty where they hardly do.
Sentence jump_sentence(std::span<const Comparison> comparisons, const std::string& model,
                       const Plan& plan) {
  constexpr double kMuch = 1.0;  // [m] assumed: about a second
  const Totals jumps = totals_of(comparisons, model, "person.jumped");
  const double most = std::max(jumps.reference, jumps.own);
  if (jumps.all == 0 || most < kMuch * static_cast<double>(jumps.all)) return {};
  const std::string& jumps_most = jumps.reference > jumps.own ? plan.study.reference : model;
  const char* const where =
      jumps_most == "nonInteracting"
          ? ", from edge to edge over junctions, as it always does"
          : ", over junctions that have no walking areas (netconvert makes them with "
            "--walkingareas)";
  return {fmt::format("Warning: {} puts people on by {} m each without walking them", jumps_most,
                      number_text(most / static_cast<double>(jumps.all), 1)),
          fmt::format("{}: its times and delays in the zone are too short by that.", where),
          Sentence::Tone::kWarning};
}

}  // namespace

bool nobody_walked(std::span<const Comparison> comparisons) {
  bool known = false;
  for (const Comparison& one : comparisons) {
    if (one.measure != "person.visitors" || !one.reference.mean) continue;
    known = true;
    if (*one.reference.mean > 0.0 || *one.sample.mean > 0.0) return false;
  }
  return known;
}

std::vector<Sentence> warning_sentences(std::span<const Comparison> comparisons, const Plan& plan) {
  std::vector<Sentence> sentences;
  for (const std::string& model : plan.study.models) {
    if (model == plan.study.reference) continue;
    std::vector<CutOff> cuts;
    std::size_t empty = 0;
    for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
      const std::vector<Comparison> here = comparisons_of(comparisons, i, model);
      empty += nobody_walked(here) ? 1 : 0;
      if (const auto cut = cut_off(here)) cuts.push_back(*cut);
    }
    if (empty > 0) sentences.push_back(nobody_sentence(empty, plan));
    if (!cuts.empty()) sentences.push_back(cut_off_sentence(cuts, model, plan));
    for (const auto& sentence :
         {teleport_sentence(comparisons, model, plan), jump_sentence(comparisons, model, plan)}) {
      const bool told = std::ranges::count(sentences, sentence.head, &Sentence::head) > 0;
      if (!sentence.head.empty() && !told) sentences.push_back(sentence);
    }
  }
  return sentences;
}

}  // namespace pedzone::study
