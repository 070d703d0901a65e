#include <algorithm>

#include "study/measure/measure_list.hpp"
#include "study/report/report_finding.hpp"
#include "study/report/report_numbers.hpp"
#include "study/report/report_parts.hpp"

namespace pedzone::study::report {
namespace {

constexpr std::size_t kMostColumns = 4;  // of the overview: more become its rows

Json overview_cell(const Comparison& one) {
  return {{"text", finding_sign(one)}, {"class", finding_class(one)}, {"say", finding_text(one)}};
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

/// Of one model in one condition: what both models have, and the change.
Json one_column(const Input& input, const std::string& model,
                const std::vector<Comparison>& comparisons) {
  Json rows = Json::array();
  for (const Measure* measure : primary_measures()) {
    const auto found = std::ranges::find(comparisons, measure->key, &Comparison::measure);
    const Comparison one = found == comparisons.end() ? Comparison{} : *found;
    const auto mean = [&](const SampleSummary& sample) -> Json {
      return {{"text", mean_text(sample, decimals_of(one))}, {"class", "mean"}, {"say", ""}};
    };
    rows.push_back({{"name", measure_label(*measure)},
                    {"unit", std::string(measure->unit)},
                    {"cells", {mean(one.reference), mean(one.sample), overview_cell(one)}}});
  }
  return {{"head", {input.plan.study.reference, model, "change"}}, {"rows", rows}, {"wide", false}};
}

Json overview(const Input& input) {
  std::vector<Column> columns;
  const std::vector<std::string> models = others(input.plan);
  for (std::size_t i = 0; i < input.plan.conditions.size(); ++i) {
    for (const std::string& model : models) {
      const std::string& condition = input.plan.conditions[i].name;
      columns.push_back({input.plan.conditions.size() == 1 ? model
                         : models.size() == 1              ? condition
                                                           : condition + ": " + model,
                         comparisons_of(input.comparisons, i, model)});
    }
  }
  if (columns.empty()) return false;
  if (columns.size() == 1) return one_column(input, models.front(), columns.front().comparisons);
  const std::vector<const Measure*> measures = primary_measures();
  const auto cell = [&](const Measure& measure, const Column& column) {
    const auto found = std::ranges::find(column.comparisons, measure.key, &Comparison::measure);
    return overview_cell(found == column.comparisons.end() ? Comparison{} : *found);
  };
  Json head = Json::array(), rows = Json::array();
  if (columns.size() <= kMostColumns) {
    for (const Column& column : columns) head.push_back(column.name);
    for (const Measure* measure : measures) {
      Json cells = Json::array();
      for (const Column& column : columns) cells.push_back(cell(*measure, column));
      rows.push_back({{"name", measure_label(*measure)}, {"unit", ""}, {"cells", cells}});
    }
  } else {
    for (const Measure* measure : measures) head.push_back(measure_label(*measure));
    for (const Column& column : columns) {
      Json cells = Json::array();
      for (const Measure* measure : measures) cells.push_back(cell(*measure, column));
      rows.push_back({{"name", column.name}, {"unit", ""}, {"cells", cells}});
    }
  }
  return {{"head", head}, {"rows", rows}, {"wide", columns.size() > kMostColumns}};
}

Json sentence_json(const Sentence& sentence) {
  return {{"head", sentence.head}, {"rest", sentence.rest}, {"class", tone_class(sentence.tone)}};
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
  return {{"summary", sentence_json(summary_sentence(all, input.plan.study.reference))},
          {"found", found},
          {"others", Json::array({sentence_json(tally_sentence(all))})}};
}

}  // namespace

Json condition_verdict(const Input& input, std::size_t condition, const std::string& model) {
  const std::vector<Comparison> comparisons = comparisons_of(input.comparisons, condition, model);
  const Verdict verdict = verdict_of(comparisons);
  Json found = Json::array(), others = Json::array();
  for (const Sentence& one : verdict.different) found.push_back(sentence_json(one));
  for (const FreeSpeed& free : input.speeds) {
    if (free.condition != condition || free.model != model) continue;
    const Sentence parts = interaction_sentence(comparisons, free);
    if (!parts.head.empty()) others.push_back(sentence_json(parts));
  }
  for (const Sentence* one : {&verdict.cut_off, &verdict.hints, &verdict.inconclusive,
                              &verdict.not_shown, &verdict.same, &verdict.too_few}) {
    if (!one->head.empty()) others.push_back(sentence_json(*one));
  }
  return {{"summary", sentence_json(summary_sentence(comparisons, input.plan.study.reference))},
          {"found", found},
          {"others", others}};
}

Json verdict_part(const Input& input) {
  const Plan& plan = input.plan;
  Json free = Json::array(), models = Json::array();
  for (const Sentence& one : warning_sentences(input.comparisons, plan)) {
    free.push_back(sentence_json(one));
  }
  for (const Sentence& one : free_speed_sentences(input.speeds, plan)) {
    free.push_back(sentence_json(one));
  }
  for (const std::string& model : others(plan)) {
    Json part = plan.conditions.size() == 1 ? condition_verdict(input, 0, model)
                                            : overall_verdict(input, model);
    part["model"] = model;
    part["reference"] = plan.study.reference;
    models.push_back(part);
  }
  return {{"free", free}, {"models", models}, {"overview", overview(input)}};
}

}  // namespace pedzone::study::report
