#include "study/report/report_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "study/report/report_numbers.hpp"

namespace pedzone::study {
namespace {

constexpr std::size_t kManySeeds = 1000;  // nobody runs so many: their number says nothing

/// How a difference of a measure is said; {} is the amount.
struct Phrase {
  std::string_view key, less, more, unit;
};
constexpr Phrase kPhrases[] = {
    {"person.travelTime", "People's trips are {} shorter", "People's trips are {} longer", "s"},
    {"person.delay", "People's delay in the zone is {} shorter",
     "People's delay in the zone is {} longer", "s"},
    {"person.waiting", "People wait {} less in the zone", "People wait {} longer in the zone", "s"},
    {"person.speed", "People walk {} slower in the zone", "People walk {} faster in the zone",
     "m/s"},
    {"person.detour", "People's ways over the shortest ones are {} lower",
     "People's ways over the shortest ones are {} higher", ""},
    {"space.density", "The density around people is {} lower",
     "The density around people is {} higher", "persons/m²"},
    {"vehicle.travelTime", "Vehicles' trips are {} shorter", "Vehicles' trips are {} longer", "s"},
    {"vehicle.delay", "Vehicles' delay is {} shorter", "Vehicles' delay is {} longer", "s"},
    {"vehicle.stops", "Vehicles stop {} less often", "Vehicles stop {} more often", "times"},
    {"conflict.count", "There are {} fewer conflicts a run", "There are {} more conflicts a run",
     ""},
    {"conflict.serious", "There are {} fewer serious conflicts a run",
     "There are {} more serious conflicts a run", ""},
    {"conflict.contacts", "There are {} fewer contacts a run", "There are {} more contacts a run",
     ""},
};

std::string replaced(std::string_view phrase, const std::string& amount) {
  std::string text(phrase);
  const std::size_t at = text.find("{}");
  return text.replace(at, amount.empty() ? 3 : 2, amount);  // the space after it, too
}

/// What is said of a measure that went down or up.
std::string change(const Measure& measure, bool down, const std::string& number,
                   const std::string& interval) {
  const auto* phrase = std::ranges::find(kPhrases, measure.key, &Phrase::key);
  const bool known = phrase != std::end(kPhrases);
  std::string amount = number;
  if (!number.empty()) amount = with_unit(number, known ? phrase->unit : measure.unit) + interval;
  if (known) return replaced(down ? phrase->less : phrase->more, amount);
  std::string label = measure_label(measure);
  label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
  return label + replaced(down ? " is {} lower" : " is {} higher", amount);
}

/// The interval's ends as sizes of a change, the smaller first.
std::string sizes_text(const Comparison& comparison, int decimals) {
  const std::optional<Interval>& interval = comparison.difference.student;
  if (!interval || comparison.difference.all_equal) return "";
  const bool down = comparison.difference.mean < 0.0;
  const double low = down ? -interval->high : interval->low;
  const double high = down ? -interval->low : interval->high;
  return fmt::format(" [{}, {}]", number_text(low, decimals), number_text(high, decimals));
}

std::string range_text(const Comparison& comparison) {
  const std::optional<Interval>& interval = comparison.difference.student;
  if (!interval) return "";
  const int decimals = decimals_of(comparison);
  return fmt::format(
      "{} to {}", signed_text(interval->low, decimals),
      with_unit(signed_text(interval->high, decimals), find_measure(comparison.measure)->unit));
}

/// What a measure is followed by in a list of those that were not found different.
std::string list_note(const Comparison& comparison) {
  std::string note;
  switch (comparison.finding) {
    case Finding::kHint:
    case Finding::kNotShown:
      note = range_text(comparison);
      break;
    case Finding::kInconclusive: {
      note = range_text(comparison);
      const std::size_t pairs = comparison.difference.n;
      if (comparison.seeds_needed > pairs) {
        const std::size_t more = comparison.seeds_needed - pairs;
        note += more > kManySeeds ? fmt::format("; > {} seeds", kManySeeds)
                                  : "; +" + count_text(more, "seed", "seeds");
      }
      break;
    }
    case Finding::kSame:
      note =
          with_unit(digits_text(comparison.reference.mean), find_measure(comparison.measure)->unit);
      break;
    case Finding::kDifferent:
    case Finding::kTooFew:
      break;
  }
  return note.empty() ? note : " (" + note + ")";
}

struct ListKind {
  Finding finding;
  const char *head, *before, *after;
};
constexpr ListKind kHintKind{Finding::kHint, "Hints, no more,", " of a difference in ",
                             ": alone each would count, among so many measures it may be chance."};
constexpr ListKind kNotShownKind{Finding::kNotShown, "No difference shown", " in ", "."};
constexpr ListKind kInconclusiveKind{Finding::kInconclusive, "Cannot say",
                                     " from so few runs whether there is a difference in ", "."};
constexpr ListKind kSameKind{Finding::kSame, "Equal in every pair of runs", ": ", "."};
constexpr ListKind kTooFewKind{Finding::kTooFew, "Not compared",
                               ", as fewer than three pairs of runs have it: ", "."};

Sentence list_sentence(std::span<const Comparison> comparisons, const ListKind& kind) {
  std::vector<std::string> items;
  for (const Comparison& one : comparisons) {
    const Measure* measure = find_measure(one.measure);
    if (one.finding != kind.finding || measure == nullptr || !measure->primary) continue;
    items.push_back(measure_label(*measure) + list_note(one));
  }
  if (items.empty()) return {};
  return {kind.head, kind.before + joined(items) + kind.after};
}

/// "in 2 of 3 conditions (−14 % to −3 %)", of those that `keep`s.
template <class Keep>
std::string share_text(std::span<const Comparison* const> all, const Keep& keep) {
  std::vector<double> percents;
  std::size_t count = 0;
  for (const Comparison* one : all) {
    if (!keep(*one)) continue;
    ++count;
    if (const auto percent = percent_of(*one)) percents.push_back(*percent);
  }
  std::string text = fmt::format(" in {} of {} conditions", count, all.size());
  if (percents.size() == count) {
    const auto [low, high] = std::ranges::minmax(percents);
    const std::string least = signed_percent(low), most = signed_percent(high);
    text += least == most ? fmt::format(" ({})", most) : fmt::format(" ({} to {})", least, most);
  }
  return text;
}

}  // namespace

Sentence tally_sentence(std::span<const Comparison> comparisons) {
  std::map<Finding, std::size_t> counts;
  std::size_t all = 0;
  for (const Comparison& one : comparisons) {
    const Measure* measure = find_measure(one.measure);
    if (measure == nullptr || !measure->primary) continue;
    ++counts[one.finding];
    ++all;
  }
  if (all == 0) return {};
  constexpr std::pair<Finding, const char*> kWords[] = {
      {Finding::kDifferent, "a difference"},
      {Finding::kHint, "a hint of one, which may be chance"},
      {Finding::kNotShown, "no difference to speak of"},
      {Finding::kSame, "equal values in every pair"},
      {Finding::kInconclusive, "not to be told from so few seeds"},
      {Finding::kTooFew, "not to be made, as runs are missing"}};
  std::vector<std::string> parts;
  for (const auto& [finding, words] : kWords) {
    if (counts[finding] > 0) parts.push_back(fmt::format("{} {}", counts[finding], words));
  }
  return {fmt::format("Of {}", count_text(all, "comparison", "comparisons")),
          " (each measure in each condition): " + joined(parts) + "."};
}

std::string measure_label(const Measure& measure) {
  std::string name(measure.name);
  const bool acronym = name.size() > 1 && std::isupper(static_cast<unsigned char>(name[1])) != 0;
  if (!acronym) name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
  if (measure.group == "People") return "people's " + name;
  if (measure.group == "Vehicles") return "vehicles' " + name;
  return name;
}

Sentence::Tone tone_of(const Comparison& comparison) {
  const Measure* measure = find_measure(comparison.measure);
  if (comparison.finding != Finding::kDifferent || measure == nullptr ||
      measure->better == Better::kNeither) {
    return Sentence::Tone::kPlain;
  }
  const bool down = comparison.difference.mean < 0.0;
  return down == (measure->better == Better::kLower) ? Sentence::Tone::kBetter
                                                     : Sentence::Tone::kWorse;
}

Sentence difference_sentence(const Comparison& comparison) {
  const Measure* measure = find_measure(comparison.measure);
  const int decimals = decimals_of(comparison);
  const double mean = comparison.difference.mean;
  Sentence sentence;
  sentence.tone = tone_of(comparison);
  sentence.head = change(*measure, mean < 0.0, number_text(std::abs(mean), decimals),
                         sizes_text(comparison, decimals));
  std::string levels;
  if (comparison.reference.mean && comparison.sample.mean) {
    levels = fmt::format("from {} to {}", number_text(*comparison.reference.mean, decimals),
                         with_unit(number_text(*comparison.sample.mean, decimals), measure->unit));
    if (const auto percent = percent_of(comparison)) levels += ": " + signed_percent(*percent);
    levels += "; ";
  }
  sentence.rest = fmt::format(" ({}{})", levels,
                              count_text(comparison.difference.n, "pair of runs", "pairs of runs"));
  return sentence;
}

Verdict verdict_of(std::span<const Comparison> comparisons) {
  Verdict verdict;
  for (const Comparison& one : comparisons) {
    const Measure* measure = find_measure(one.measure);
    if (one.finding == Finding::kDifferent && measure != nullptr && measure->primary) {
      verdict.different.push_back(difference_sentence(one));
    }
  }
  verdict.hints = list_sentence(comparisons, kHintKind);
  verdict.not_shown = list_sentence(comparisons, kNotShownKind);
  verdict.inconclusive = list_sentence(comparisons, kInconclusiveKind);
  verdict.same = list_sentence(comparisons, kSameKind);
  verdict.too_few = list_sentence(comparisons, kTooFewKind);
  return verdict;
}

Sentence overall_sentence(std::span<const Comparison> comparisons, std::string_view key) {
  std::vector<const Comparison*> all;
  std::size_t down = 0, up = 0;
  for (const Comparison& one : comparisons) {
    if (one.measure != key) continue;
    all.push_back(&one);
    if (one.finding == Finding::kDifferent) ++(one.difference.mean < 0.0 ? down : up);
  }
  if (down + up == 0) return {};
  const bool mostly_down = down >= up;
  const auto falls = [](const Comparison& one) {
    return one.finding == Finding::kDifferent && one.difference.mean < 0.0;
  };
  const auto rises = [](const Comparison& one) {
    return one.finding == Finding::kDifferent && one.difference.mean >= 0.0;
  };
  const Measure& measure = *find_measure(key);
  Sentence sentence{change(measure, mostly_down, "", ""),
                    mostly_down ? share_text(all, falls) : share_text(all, rises)};
  if (down > 0 && up > 0) {
    sentence.rest +=
        ", the opposite" + (mostly_down ? share_text(all, rises) : share_text(all, falls));
  } else {
    const Better better = measure.better;
    sentence.tone = better == Better::kNeither                  ? Sentence::Tone::kPlain
                    : (better == Better::kLower) == mostly_down ? Sentence::Tone::kBetter
                                                                : Sentence::Tone::kWorse;
  }
  sentence.rest += '.';
  return sentence;
}

}  // namespace pedzone::study
