#include "study/report/report_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "study/report/report_numbers.hpp"

namespace pedzone::study {
namespace {

constexpr std::size_t kManySeeds = 1000;  // nobody runs so many: their number says nothing

/// How a difference of a measure is said; {} is the amount, in a unit of `scale` of the measure's:
/// nothing for a share of the reference's mean.
struct Phrase {
  std::string_view key, less, more, unit;
  std::optional<double> scale = 1.0;
};
constexpr double kPercent = 100.0;
constexpr Phrase kPhrases[] = {
    {"person.travelTime", "People's trips are {} shorter", "People's trips are {} longer", "s"},
    {"person.delay", "People's delay in the zone is {} shorter",
     "People's delay in the zone is {} longer", "s"},
    {"person.waiting", "People wait {} less in the zone", "People wait {} longer in the zone", "s"},
    {"person.speed", "People walk {} slower in the zone", "People walk {} faster in the zone",
     "m/s"},
    {"person.arrived", "The share of people who arrive by the end is {} lower",
     "The share of people who arrive by the end is {} higher", "percentage points", kPercent},
    {"person.detour", "People's ways are {} shorter", "People's ways are {} longer", "%", {}},
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

const Phrase* phrase_of(const Measure& measure) {
  const auto* phrase = std::ranges::find(kPhrases, measure.key, &Phrase::key);
  return phrase == std::end(kPhrases) ? nullptr : phrase;
}

/// What is said of a measure that went down or up.
std::string change(const Measure& measure, bool down, const std::string& number,
                   const std::string& interval) {
  const Phrase* const phrase = phrase_of(measure);
  std::string amount = number;
  if (!number.empty()) {
    amount = with_unit(number, phrase != nullptr ? phrase->unit : measure.unit) + interval;
  }
  if (phrase != nullptr) return replaced(down ? phrase->less : phrase->more, amount);
  std::string label = measure_label(measure);
  label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
  return label + replaced(down ? " is {} lower" : " is {} higher", amount);
}

/// The size of a change and its interval, in the unit of the measure's phrase.
struct Amount {
  std::string number, interval;
};

Amount amount_of(const Comparison& comparison) {
  const Phrase* const phrase = phrase_of(*find_measure(comparison.measure));
  double scale = 1.0;
  if (phrase != nullptr) {
    const double mean = std::abs(comparison.reference.mean.value_or(0.0));
    scale = phrase->scale.value_or(mean > 0.0 ? kPercent / mean : 1.0);
  }
  const PairedDifference& difference = comparison.difference;
  if (!difference.student || difference.all_equal) {
    return {number_text(scale * std::abs(difference.mean), decimals_of(comparison)), ""};
  }
  const bool down = difference.mean < 0.0;
  const double low = scale * (down ? -difference.student->high : difference.student->low);
  const double high = scale * (down ? -difference.student->low : difference.student->high);
  const int decimals = decimals_for((high - low) / 2.0);
  return {number_text(scale * std::abs(difference.mean), decimals),
          fmt::format(" [{}, {}]", number_text(low, decimals), number_text(high, decimals))};
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
    if (one.bound == Bound::kUnknown) continue;
    items.push_back(measure_label(*measure) + list_note(one));
  }
  if (items.empty()) return {};
  return {kind.head, kind.before + joined(items) + kind.after};
}

/// Times of which the end of the runs leaves nothing to be told.
Sentence cut_off_sentence(std::span<const Comparison> comparisons) {
  std::vector<std::string> items;
  for (const Comparison& one : comparisons) {
    const Measure* measure = find_measure(one.measure);
    if (one.bound != Bound::kUnknown || measure == nullptr || !measure->primary) continue;
    items.push_back(measure_label(*measure));
  }
  if (items.empty()) return {};
  return {"Not to be told, as runs were cut off:",
          " " + joined(items) + ". Fewer have arrived where times seem shorter, or few with both."};
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
      {Finding::kTooFew, "not to be made: fewer than three pairs of runs have the measure"}};
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

bool is_told(const Comparison& comparison) {
  return comparison.finding == Finding::kDifferent && comparison.bound != Bound::kUnknown;
}

Sentence::Tone tone_of(const Comparison& comparison) {
  if (!is_told(comparison)) return Sentence::Tone::kPlain;
  return comparison.difference.mean < 0.0 ? Sentence::Tone::kLower : Sentence::Tone::kHigher;
}

Sentence difference_sentence(const Comparison& comparison) {
  const Measure* measure = find_measure(comparison.measure);
  const int decimals = decimals_of(comparison);
  Amount amount = amount_of(comparison);
  if (comparison.bound == Bound::kAtLeast) amount.number = "at least " + amount.number;
  Sentence sentence;
  sentence.tone = tone_of(comparison);
  sentence.head =
      change(*measure, comparison.difference.mean < 0.0, amount.number, amount.interval);
  std::string levels;
  if (comparison.reference.mean && comparison.sample.mean) {
    levels = fmt::format("from {} to {}", number_text(*comparison.reference.mean, decimals),
                         with_unit(number_text(*comparison.sample.mean, decimals), measure->unit));
    const auto percent = percent_of(comparison);
    const Phrase* const phrase = phrase_of(*measure);
    if (percent && (phrase == nullptr || phrase->scale == 1.0)) {
      levels += ": " + signed_percent(*percent);
    }
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
    if (is_told(one) && measure != nullptr && measure->primary) {
      verdict.different.push_back(difference_sentence(one));
    }
  }
  verdict.hints = list_sentence(comparisons, kHintKind);
  verdict.not_shown = list_sentence(comparisons, kNotShownKind);
  verdict.inconclusive = list_sentence(comparisons, kInconclusiveKind);
  verdict.same = list_sentence(comparisons, kSameKind);
  verdict.too_few = list_sentence(comparisons, kTooFewKind);
  verdict.cut_off = cut_off_sentence(comparisons);
  return verdict;
}

Sentence overall_sentence(std::span<const Comparison> comparisons, std::string_view key) {
  std::vector<const Comparison*> all;
  std::size_t down = 0, up = 0, cut = 0;
  for (const Comparison& one : comparisons) {
    if (one.measure != key) continue;
    all.push_back(&one);
    if (!is_told(one)) continue;
    ++(one.difference.mean < 0.0 ? down : up);
    cut += one.bound == Bound::kAtLeast ? 1 : 0;
  }
  if (down + up == 0) return {};
  const bool mostly_down = down >= up;
  const auto falls = [](const Comparison& one) {
    return is_told(one) && one.difference.mean < 0.0;
  };
  const auto rises = [](const Comparison& one) {
    return is_told(one) && one.difference.mean >= 0.0;
  };
  Sentence sentence{change(*find_measure(key), mostly_down, "", ""),
                    mostly_down ? share_text(all, falls) : share_text(all, rises)};
  if (cut > 0) sentence.rest += fmt::format(", at least, as runs are cut off in {}", cut);
  if (down > 0 && up > 0) {
    sentence.rest +=
        ", the opposite" + (mostly_down ? share_text(all, rises) : share_text(all, falls));
  } else {
    sentence.tone = mostly_down ? Sentence::Tone::kLower : Sentence::Tone::kHigher;
  }
  sentence.rest += '.';
  return sentence;
}

}  // namespace pedzone::study
