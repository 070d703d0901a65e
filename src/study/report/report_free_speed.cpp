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

Sentence agreement(std::span<const FreeSpeed> speeds, const Plan& plan) {
  return {'W' + walk_text(speeds, plan),
          fmt::format(" ({}): they agree within 2 %, so that what differs below comes from the "
                      "interaction.",
                      persons_text(speeds))};
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
