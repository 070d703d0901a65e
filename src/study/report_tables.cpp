#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/measure_list.hpp"
#include "study/report_numbers.hpp"
#include "study/report_parts.hpp"

namespace pedzone::report {
namespace {

constexpr std::size_t kMostRows = 2000;  // of the table of everything; more are in summary.csv
constexpr std::size_t kMostColumns = 4;  // of the overview: more become its rows
constexpr double kMostPercent = 100.0;   // of an axis: what is farther out gets an arrow head
constexpr double kAxes[] = {5, 10, 20, 50, kMostPercent};  // [%]

const char* tone_class(Sentence::Tone tone) {
  switch (tone) {
    case Sentence::Tone::kBetter:
      return "better";
    case Sentence::Tone::kWorse:
      return "worse";
    case Sentence::Tone::kWarning:
      return "warning";
    case Sentence::Tone::kPlain:
      break;
  }
  return "plain";
}

std::string finding_text(const Comparison& one) {
  switch (one.finding) {
    case Finding::kDifferent: {
      const Sentence::Tone tone = tone_of(one);
      std::string text = one.difference.mean < 0.0 ? "lower" : "higher";
      if (tone == Sentence::Tone::kBetter) text += ": better";
      if (tone == Sentence::Tone::kWorse) text += ": worse";
      return text;
    }
    case Finding::kNotShown:
      return "no difference shown";
    case Finding::kInconclusive:
      return "cannot say";
    case Finding::kSame:
      return "equal";
    case Finding::kTooFew:
      break;
  }
  return "too few pairs";
}

std::string finding_class(const Comparison& one) {
  switch (one.finding) {
    case Finding::kDifferent:
      return std::string("different ") + tone_class(tone_of(one));
    case Finding::kNotShown:
      return "not-shown";
    case Finding::kInconclusive:
      return "inconclusive";
    case Finding::kSame:
      return "same";
    case Finding::kTooFew:
      break;
  }
  return "too-few";
}

std::string p_text(const std::optional<double>& p) {
  constexpr double kLeast = 0.001;
  if (!p) return digits_text({});
  return *p < kLeast ? "< 0.001" : fmt::format("{:.3f}", *p);
}

std::string interval_text(const std::optional<Interval>& interval, int decimals) {
  if (!interval) return digits_text({});
  return fmt::format("[{}, {}]", signed_text(interval->low, decimals),
                     signed_text(interval->high, decimals));
}

// The overview

/// What a cell of the overview says: the change in percent, or that there is none.
std::string overview_text(const Comparison& one) {
  switch (one.finding) {
    case Finding::kDifferent: {
      const auto percent = percent_of(one);
      return percent ? signed_percent(*percent)
                     : signed_text(one.difference.mean, decimals_of(one));
    }
    case Finding::kNotShown:
      return "\u2248";
    case Finding::kInconclusive:
      return "?";
    case Finding::kSame:
      return "=";
    case Finding::kTooFew:
      break;
  }
  return "\u2013";
}

Json overview_cell(const Comparison* one) {
  if (one == nullptr) return {{"text", "\u2013"}, {"class", "too-few"}, {"say", "too few pairs"}};
  return {
      {"text", overview_text(*one)}, {"class", finding_class(*one)}, {"say", finding_text(*one)}};
}

std::vector<const Measure*> primary_measures() {
  std::vector<const Measure*> measures;
  for (const Measure& one : measure_list()) {
    if (one.primary) measures.push_back(&one);
  }
  return measures;
}

struct Column {
  std::string name;
  std::vector<Comparison> comparisons;
};

Json overview(const Input& input) {
  std::vector<Column> columns;
  const std::vector<std::string> models = others(input.plan);
  for (std::size_t i = 0; i < input.plan.conditions.size(); ++i) {
    for (const std::string& model : models) {
      const std::string& condition = input.plan.conditions[i].name;
      columns.push_back({input.plan.conditions.size() == 1 ? model
                         : models.size() == 1              ? condition
                                                           : condition + ": " + model,
                         comparisons_of(input, i, model)});
    }
  }
  const std::vector<const Measure*> measures = primary_measures();
  const auto cell = [&](const Measure& measure, const Column& column) {
    const auto found = std::ranges::find(column.comparisons, measure.key, &Comparison::measure);
    return overview_cell(found == column.comparisons.end() ? nullptr : &*found);
  };
  Json head = Json::array(), rows = Json::array();
  if (columns.size() <= kMostColumns) {
    for (const Column& column : columns) head.push_back(column.name);
    for (const Measure* measure : measures) {
      Json cells = Json::array();
      for (const Column& column : columns) cells.push_back(cell(*measure, column));
      rows.push_back({{"name", measure_label(*measure)}, {"cells", cells}});
    }
  } else {
    for (const Measure* measure : measures) head.push_back(measure_label(*measure));
    for (const Column& column : columns) {
      Json cells = Json::array();
      for (const Measure* measure : measures) cells.push_back(cell(*measure, column));
      rows.push_back({{"name", column.name}, {"cells", cells}});
    }
  }
  return {{"head", head}, {"rows", rows}, {"wide", columns.size() > kMostColumns}};
}

// Differences with their intervals drawn

/// An interval over an axis from -limit to +limit [%]. Holds no text from outside.
std::string forest_svg(const Comparison& one, double limit) {
  constexpr double kWidth = 220.0, kHeight = 26.0, kRoom = 12.0;
  const auto x = [&](double percent) {
    const double part = std::clamp(percent / limit, -1.0, 1.0);
    return kWidth / 2.0 + part * (kWidth / 2.0 - kRoom);
  };
  std::string svg =
      fmt::format(R"(<svg class="forest {}" viewBox="0 0 {:.0f} {:.0f}" aria-hidden="true">)",
                  finding_class(one), kWidth, kHeight);
  for (const double part : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    svg += fmt::format(R"(<path class="{}" d="M{:.1f} 0V{:.0f}"/>)", part == 0.0 ? "zero" : "grid",
                       x(part * limit), kHeight);
  }
  const auto percent = percent_of(one);
  if (percent && one.difference.student) {
    const double scale = kMostPercent / std::abs(*one.reference.mean);
    const double low = scale * one.difference.student->low;
    const double high = scale * one.difference.student->high, y = kHeight / 2.0;
    svg += fmt::format(R"(<path class="interval" d="M{:.1f} {:.0f}H{:.1f}"/>)", x(low), y, x(high));
    const auto arrow = [&](double at, double way) {
      return fmt::format(R"(<path class="arrow" d="M{:.1f} {:.0f}l{:.0f} -5v10z"/>)",
                         at + 6.0 * way, y, -6.0 * way);
    };
    if (low < -limit) svg += arrow(x(-limit), -1.0);
    if (high > limit) svg += arrow(x(limit), 1.0);
    if (std::abs(*percent) <= limit) {
      svg +=
          fmt::format(R"(<circle class="mean" cx="{:.1f}" cy="{:.0f}" r="4.5"/>)", x(*percent), y);
    }
  }
  return svg + "</svg>";
}

/// The shortest axis that holds all intervals, as far as an axis goes.
double axis_limit(const std::vector<Comparison>& comparisons) {
  double most = 0.0;
  for (const Comparison& one : comparisons) {
    if (!percent_of(one) || !one.difference.student) continue;
    const double scale = kMostPercent / std::abs(*one.reference.mean);
    most = std::max({most, std::abs(scale * one.difference.student->low),
                     std::abs(scale * one.difference.student->high)});
  }
  const auto* found = std::ranges::find_if(kAxes, [&](double axis) { return axis >= most; });
  return found == std::end(kAxes) ? kMostPercent : *found;
}

std::string mean_text(const SampleSummary& sample, int decimals) {
  return sample.mean ? number_text(*sample.mean, decimals) : digits_text({});
}

Json difference_row(const Comparison& one, double limit) {
  const Measure& measure = *find_measure(one.measure);
  const int decimals = decimals_of(one);
  const auto percent = percent_of(one);
  const bool compared = one.difference.n > 0;
  return {{"name", measure_label(measure)},
          {"unit", std::string(measure.unit)},
          {"reference", mean_text(one.reference, decimals)},
          {"sample", mean_text(one.sample, decimals)},
          {"difference", compared ? signed_text(one.difference.mean, decimals) : digits_text({})},
          {"interval", interval_text(one.difference.student, decimals)},
          {"percent", percent ? signed_percent(*percent) : digits_text({})},
          {"forest_html", forest_svg(one, limit)},
          {"effect", digits_text(one.difference.effect)},
          {"p", p_text(one.p_holm)},
          {"finding", finding_text(one)},
          {"class", finding_class(one)}};
}

Json differences(const Input& input) {
  Json tables = Json::array();
  for (std::size_t i = 0; i < input.plan.conditions.size(); ++i) {
    for (const std::string& model : others(input.plan)) {
      std::vector<Comparison> all = comparisons_of(input, i, model);
      std::erase_if(all, [](const Comparison& one) {
        const Measure* measure = find_measure(one.measure);
        return measure == nullptr || !measure->primary;
      });
      const double limit = axis_limit(all);
      Json rows = Json::array();
      std::size_t pairs = 0;
      for (const Comparison& one : all) {
        rows.push_back(difference_row(one, limit));
        pairs = std::max(pairs, one.difference.n);
      }
      tables.push_back({{"condition", input.plan.conditions[i].name},
                        {"model", model},
                        {"reference", input.plan.study.reference},
                        {"pairs", count_text(pairs, "pair of runs", "pairs of runs")},
                        {"limit", fmt::format("{:.0f} %", limit)},
                        {"rows", rows}});
    }
  }
  return tables;
}

// Everything

Json full_row(const Input& input, const Comparison& one, const Measure& measure) {
  const int decimals = decimals_of(one);
  const auto sample = [](const SampleSummary& of) {
    return fmt::format("{} / {} / {}", digits_text(of.mean), digits_text(of.median),
                       digits_text(of.sd));
  };
  return {{"condition", input.plan.conditions[one.condition].name},
          {"model", one.model},
          {"name", measure_label(measure)},
          {"unit", std::string(measure.unit)},
          {"reference", sample(one.reference)},
          {"sample", sample(one.sample)},
          {"pairs", one.difference.n},
          {"difference",
           one.difference.n > 0 ? signed_text(one.difference.mean, decimals) : digits_text({})},
          {"student", interval_text(one.difference.student, decimals)},
          {"bootstrap", interval_text(one.difference.bootstrap, decimals)},
          {"effect", digits_text(one.difference.effect)},
          {"p", p_text(one.difference.p)},
          {"holm", p_text(one.p_holm)},
          {"seeds", one.seeds_needed > 0 ? std::to_string(one.seeds_needed) : digits_text({})},
          {"finding", finding_text(one)},
          {"class", finding_class(one)}};
}

Json everything(const Input& input) {
  const bool all = input.comparisons.size() <= kMostRows;
  Json rows = Json::array();
  for (const Comparison& one : input.comparisons) {
    const Measure* measure = find_measure(one.measure);
    if (measure == nullptr || rows.size() >= kMostRows || !(all || measure->primary)) continue;
    rows.push_back(full_row(input, one, *measure));
  }
  return {{"rows", rows},
          {"cut", rows.size() < input.comparisons.size()},
          {"total", input.comparisons.size()},
          {"shown", rows.size()}};
}

Json glossary() {
  Json groups = Json::array();
  for (const Measure& one : measure_list()) {
    if (groups.empty() || groups.back()["group"] != one.group) {
      groups.push_back({{"group", std::string(one.group)}, {"measures", Json::array()}});
    }
    groups.back()["measures"].push_back({{"name", std::string(one.name)},
                                         {"unit", std::string(one.unit)},
                                         {"primary", one.primary},
                                         {"meaning", std::string(one.meaning)}});
  }
  return groups;
}

Json sentence_json(const Sentence& sentence) {
  return {{"head", sentence.head}, {"rest", sentence.rest}, {"class", tone_class(sentence.tone)}};
}

/// Sentences on one condition.
Json condition_verdict(const Input& input, std::size_t condition, const std::string& model) {
  const Verdict verdict = verdict_of(comparisons_of(input, condition, model));
  Json found = Json::array(), others = Json::array();
  for (const Sentence& one : verdict.different) found.push_back(sentence_json(one));
  for (const Sentence* one :
       {&verdict.inconclusive, &verdict.not_shown, &verdict.same, &verdict.too_few}) {
    if (!one->head.empty()) others.push_back(sentence_json(*one));
  }
  const bool none = found.empty();
  return {{"found", found}, {"others", others}, {"none", none}};
}

/// Sentences over all conditions.
Json overall_verdict(const Input& input, const std::string& model) {
  std::vector<Comparison> all;
  for (const Comparison& one : input.comparisons) {
    if (one.model == model) all.push_back(one);
  }
  Json found = Json::array();
  for (const Measure* measure : primary_measures()) {
    const Sentence sentence = overall_sentence(all, measure->key);
    if (!sentence.head.empty()) found.push_back(sentence_json(sentence));
  }
  const bool none = found.empty();
  return {{"found", found}, {"others", Json::array()}, {"none", none}};
}

}  // namespace

Json verdict_part(const Input& input) {
  const Plan& plan = input.plan;
  Json free = Json::array(), models = Json::array();
  for (const std::string& model : others(plan)) {
    std::vector<FreeSpeed> speeds;
    for (const FreeSpeed& one : input.speeds) {
      if (one.model == model) speeds.push_back(one);
    }
    for (const Sentence& one : free_speed_sentences(speeds, plan)) {
      free.push_back(sentence_json(one));
    }
    Json part = plan.conditions.size() == 1 ? condition_verdict(input, 0, model)
                                            : overall_verdict(input, model);
    part["model"] = model;
    part["reference"] = plan.study.reference;
    models.push_back(part);
  }
  return {{"free", free}, {"models", models}, {"overview", overview(input)}};
}

Json tables_part(const Input& input) {
  Json tables = differences(input);
  if (input.plan.conditions.size() > 1) {
    std::size_t index = 0;
    for (std::size_t i = 0; i < input.plan.conditions.size(); ++i) {
      for (const std::string& model : others(input.plan)) {
        tables[index++]["verdict"] = condition_verdict(input, i, model);
      }
    }
  }
  return {{"differences", tables}, {"everything", everything(input)}, {"glossary", glossary()}};
}

}  // namespace pedzone::report
