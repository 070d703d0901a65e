#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "study/report/report_numbers.hpp"
#include "study/report/report_verdict.hpp"

namespace pedzone::study {
namespace {

/// "0.4 % slower than striping", of deviations of one sign or not.
std::string deviation_text(double least, double most, const std::string& reference) {
  constexpr double kShown = 0.05;  // [%] what is rounded to 0.1
  if (std::max(std::abs(least), std::abs(most)) < kShown) return "as fast as " + reference;
  const auto word = [](double value) { return value < 0.0 ? "slower" : "faster"; };
  const std::string low = percent_text(least), high = percent_text(most);
  if (low == high && (least < 0.0) == (most < 0.0)) {
    return fmt::format("{} {} than {}", low, word(most), reference);
  }
  if ((least < 0.0) == (most < 0.0)) {
    const bool down = most < 0.0;
    return fmt::format("{} to {} {} than {}", down ? high : low, down ? low : high, word(most),
                       reference);
  }
  return fmt::format("between {} slower and {} faster than {}", low, high, reference);
}

double deviation(const FreeSpeed& speed) {
  constexpr double kPercent = 100.0;
  return kPercent * (speed.ratio - 1.0);
}

/// How a model walks with interaction switched off.
std::string walk_text(std::span<const FreeSpeed> speeds, const Plan& plan) {
  const auto [least, most] = std::ranges::minmax(speeds, {}, &FreeSpeed::ratio);
  return fmt::format("ith interaction switched off, {} walks {}", speeds.front().model,
                     deviation_text(deviation(least), deviation(most), plan.study.reference));
}

/// "12 persons in each of 3 conditions".
std::string persons_text(std::span<const FreeSpeed> speeds) {
  const auto [fewest, most] = std::ranges::minmax(speeds, {}, &FreeSpeed::persons);
  std::string text = count_text(most.persons, "person", "persons");
  if (fewest.persons != most.persons) text = fmt::format("{} to ", fewest.persons) + text;
  if (speeds.size() > 1) text += fmt::format(" in each of {} conditions", speeds.size());
  return text;
}

/// Where it is: nothing where the study has but one condition.
std::string where_text(std::span<const FreeSpeed> speeds, const Plan& plan) {
  constexpr std::size_t kNamed = 3;
  if (plan.conditions.size() == 1) return "";
  if (speeds.size() > kNamed) return fmt::format(" in {} conditions", speeds.size());
  std::vector<std::string> names;
  for (const FreeSpeed& speed : speeds) names.push_back(plan.conditions[speed.condition].name);
  return fmt::format(" in \u201c{}\u201d", fmt::join(names, "\u201d, \u201c"));
}

Sentence unmeasured(std::span<const FreeSpeed> speeds, const Plan& plan) {
  return {fmt::format("Warning: the free speed of {} was not measured{}", speeds.front().model,
                      where_text(speeds, plan)),
          ". Whether the differences there come from the interaction is not known.",
          Sentence::Tone::kWarning};
}

Sentence disagreement(std::span<const FreeSpeed> speeds, const Plan& plan) {
  return {"Warning: w" + walk_text(speeds, plan) + where_text(speeds, plan),
          fmt::format(" ({}). That is more than the 2 % of a fair comparison: any difference of "
                      "times and speeds there may be just that.",
                      persons_text(speeds)),
          Sentence::Tone::kWarning};
}

/// "8.1 % shorter", of the conditions' mean ratios less 1; nothing where all are within 2 %.
std::string part_text(std::span<const FreeSpeed> speeds, SampleSummary FreeSpeed::*part,
                      const char* less, const char* more) {
  constexpr double kPercent = 100.0, kFair = 2.0;
  double least = 0.0, most = 0.0;
  bool known = false;
  for (const FreeSpeed& speed : speeds) {
    if (!(speed.*part).mean) continue;
    const double percent = kPercent * *(speed.*part).mean;
    least = known ? std::min(least, percent) : percent;
    most = known ? std::max(most, percent) : percent;
    known = true;
  }
  if (!known || std::max(std::abs(least), std::abs(most)) <= kFair) return "";
  const auto word = [&](double value) { return value < 0.0 ? less : more; };
  const std::string low = percent_text(least), high = percent_text(most);
  if (low == high) return fmt::format("{} {}", low, word(most));
  return fmt::format("{} {} to {} {}", low, word(least), high, word(most));
}

/// Their speeds are the same; ways and times need not be.
Sentence agreement(std::span<const FreeSpeed> speeds, const Plan& plan) {
  const std::string way = part_text(speeds, &FreeSpeed::way, "shorter", "longer");
  const std::string time = part_text(speeds, &FreeSpeed::time, "less", "more");
  Sentence sentence{'W' + walk_text(speeds, plan),
                    fmt::format(" ({}): speeds agree within 2 %", persons_text(speeds))};
  if (way.empty() && time.empty()) {
    sentence.rest += ", and so do ways and times: what differs below comes from the interaction.";
    return sentence;
  }
  std::vector<std::string> parts;
  if (!way.empty()) parts.push_back("their ways are " + way);
  if (!time.empty()) parts.push_back("they take " + time + " time");
  sentence.rest += fmt::format(
      ". But {} even without others: a part of what differs below is geometry, not interaction.",
      joined(parts));
  return sentence;
}

/// "Of the 50 % by which people's trips are shorter, 7.2 % are there without others, too; ...".
std::string parts_text(const Interaction& parts, const char* what) {
  constexpr double kPercent = 100.0;
  const double sign = parts.all < 0.0 ? -kPercent : kPercent;  // of what goes the same way
  const double half = parts.interval ? (parts.interval->high - parts.interval->low) / 2.0 : 0.01;
  const int decimals = decimals_for(kPercent * half);
  const auto percent = [&](double share) { return number_text(sign * share, decimals); };
  std::string text = fmt::format(
      "Of the {} % by which {}, {} percentage points are there without others, too; interaction "
      "makes {}",
      percent(parts.all), what, percent(parts.geometry), percent(parts.interaction));
  if (parts.interval) {
    const auto [low, high] = std::minmax({sign * parts.interval->low, sign * parts.interval->high});
    text += fmt::format(" [{}, {}]", number_text(low, decimals), number_text(high, decimals));
  }
  return text;
}

/// Of one model.
void add_sentences(std::span<const FreeSpeed> speeds, const Plan& plan,
                   std::vector<Sentence>& sentences) {
  std::vector<FreeSpeed> agree, disagree, unknown;
  for (const FreeSpeed& speed : speeds) {
    (speed.persons == 0 ? unknown : speed.agrees ? agree : disagree).push_back(speed);
  }
  if (!disagree.empty()) sentences.push_back(disagreement(disagree, plan));
  if (!unknown.empty()) sentences.push_back(unmeasured(unknown, plan));
  if (!agree.empty()) sentences.push_back(agreement(agree, plan));
}

}  // namespace

Sentence interaction_sentence(std::span<const Comparison> comparisons, const FreeSpeed& free) {
  const auto time = std::ranges::find(comparisons, "person.travelTime", &Comparison::measure);
  // What a difference is at least cannot be split.
  if (time == comparisons.end() || !is_told(*time) || time->bound == Bound::kAtLeast) return {};
  const auto found = interaction_of(*time, free.time);
  if (!found) return {};
  const char* const what =
      found->all < 0.0 ? "people's trips are shorter" : "people's trips are longer";
  return {"Geometry and interaction.", fmt::format(" {}.", parts_text(*found, what))};
}

std::vector<Sentence> free_speed_sentences(std::span<const FreeSpeed> speeds, const Plan& plan) {
  std::vector<Sentence> sentences;
  for (const std::string& model : plan.study.models) {
    std::vector<FreeSpeed> of_model;
    std::ranges::copy_if(speeds, std::back_inserter(of_model),
                         [&](const FreeSpeed& speed) { return speed.model == model; });
    add_sentences(of_model, plan, sentences);
  }
  return sentences;
}

}  // namespace pedzone::study
