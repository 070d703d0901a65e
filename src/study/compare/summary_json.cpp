// All that a study says, for programs.
#include <set>

#include "study/compare/measured.hpp"
#include "study/compare/results.hpp"
#include "study/measure/measure_list.hpp"

namespace pedzone::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kIndent = 1;

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json interval(const std::optional<Interval>& value) {
  return value ? Json::array({value->low, value->high}) : Json(nullptr);
}

/// A condition's scenario and levels, by factor.
Json condition_json(const Plan& plan, std::size_t index) {
  const Condition& condition = plan.conditions[index];
  Json levels = Json::object();
  for (std::size_t factor = 0; factor < plan.study.factors.size(); ++factor) {
    const Factor& of = plan.study.factors[factor];
    levels[of.id] = of.levels[condition.levels[factor]].name;
  }
  return {{"scenario", plan.study.scenarios[condition.scenario].id}, {"levels", levels}};
}

Json study_json(const Study& study) {
  Json scenarios = Json::array(), factors = Json::array();
  for (const StudyScenario& scenario : study.scenarios) {
    scenarios.push_back({{"id", scenario.id},
                         {"file", scenario.file},
                         {"zone", scenario.zone_file},
                         {"options", scenario.sumo_options}});
    if (!scenario.client.empty()) scenarios.back()["client"] = scenario.client;
  }
  for (const Factor& factor : study.factors) {
    Json levels = Json::array();
    for (const Level& level : factor.levels) levels.push_back(level.name);
    factors.push_back({{"id", factor.id}, {"levels", levels}});
  }
  return {{"id", study.id},         {"title", study.title},         {"question", study.question},
          {"models", study.models}, {"reference", study.reference}, {"seeds", study.seeds},
          {"scenarios", scenarios}, {"factors", factors},           {"end", number(study.end)}};
}

Json measures_json() {
  Json measures = Json::array();
  for (const Measure& measure : measure_list()) {
    measures.push_back({{"key", measure.key},
                        {"name", measure.name},
                        {"unit", measure.unit},
                        {"meaning", measure.meaning},
                        {"group", measure.group},
                        {"primary", measure.primary}});
  }
  return measures;
}

Json speeds_json(const Plan& plan, const std::vector<FreeSpeed>& speeds) {
  Json all = Json::array();
  for (const FreeSpeed& speed : speeds) {
    Json entry = condition_json(plan, speed.condition);
    const bool known = speed.persons > 0;
    entry["model"] = speed.model;
    entry["persons"] = speed.persons;
    entry["ratio"] = known ? Json(speed.ratio) : Json(nullptr);
    entry["lowest"] = known ? Json(speed.lowest) : Json(nullptr);
    entry["highest"] = known ? Json(speed.highest) : Json(nullptr);
    entry["agrees"] = speed.agrees;
    entry["wayRatio"] = speed.way.mean ? Json(1.0 + *speed.way.mean) : Json(nullptr);
    entry["timeRatio"] = speed.time.mean ? Json(1.0 + *speed.time.mean) : Json(nullptr);
    all.push_back(std::move(entry));
  }
  return all;
}

Json unequal_json(const Plan& plan, const Records& records) {
  Json all = Json::array();
  for (const UnequalDemand& unequal : unequal_demands(plan, records)) {
    Json entry = condition_json(plan, unequal.condition);
    entry["model"] = unequal.model;
    entry["what"] = unequal.what;
    entry["seeds"] = unequal.seeds;
    all.push_back(std::move(entry));
  }
  return all;
}

/// How many runs there are, and which are not done.
Json runs_json(const Plan& plan, const Records& records) {
  std::size_t done = 0;
  Json open = Json::array();
  for (std::size_t run = 0; run < plan.runs.size(); ++run) {
    const PlannedRun& planned = plan.runs[run];
    if (is_done(records[run])) {
      ++done;
      continue;
    }
    Json entry = condition_json(plan, planned.condition);
    entry["run"] = planned.id;
    entry["kind"] = planned.kind == RunKind::kFreeSpeed ? "freeSpeed" : "study";
    entry["model"] = planned.model;
    entry["seed"] = planned.seed;
    entry["status"] = table_status(records[run]);
    const std::string failure = records[run] ? records[run]->failure : "";
    entry["failure"] = failure.substr(0, failure.find('\n'));  // the log's end follows
    open.push_back(std::move(entry));
  }
  return {{"planned", plan.runs.size()}, {"done", done}, {"notDone", open}};
}

/// Of the programs that made the runs; more than one where they were mixed.
Json versions_json(const Records& records) {
  std::set<std::map<std::string, std::string>> versions;
  for (const auto& record : records) {
    if (record) versions.insert(record->versions);
  }
  return versions;
}

Json summary_of(const SampleSummary& summary) {
  return {{"mean", number(summary.mean)},
          {"median", number(summary.median)},
          {"sd", number(summary.sd)},
          {"min", number(summary.min)},
          {"quartile1", number(summary.quartile1)},
          {"quartile3", number(summary.quartile3)},
          {"max", number(summary.max)}};
}

Json difference_json(const PairedDifference& difference) {
  return {{"mean", difference.n > 0 ? Json(difference.mean) : Json(nullptr)},
          {"sd", difference.n > 1 ? Json(difference.sd) : Json(nullptr)},
          {"allEqual", difference.all_equal},
          {"student", interval(difference.student)},
          {"bootstrap", interval(difference.bootstrap)},
          {"p", number(difference.p)},
          {"effect", number(difference.effect)}};
}

Json comparisons_json(const Plan& plan, const std::vector<Comparison>& comparisons) {
  Json all = Json::array();
  for (const Comparison& comparison : comparisons) {
    Json entry = condition_json(plan, comparison.condition);
    entry["model"] = comparison.model;
    entry["measure"] = comparison.measure;
    entry["pairs"] = comparison.difference.n;
    entry["missing"] = comparison.missing;
    entry["undefined"] = comparison.undefined;
    entry["referenceValues"] = summary_of(comparison.reference);
    entry["modelValues"] = summary_of(comparison.sample);
    entry["difference"] = difference_json(comparison.difference);
    entry["relative"] = number(comparison.relative);
    entry["pHolm"] = number(comparison.p_holm);
    entry["seedsNeeded"] =
        comparison.seeds_needed > 0 ? Json(comparison.seeds_needed) : Json(nullptr);
    entry["finding"] = finding_name(comparison.finding);
    entry["bound"] = bound_name(comparison.bound);
    all.push_back(std::move(entry));
  }
  return all;
}

}  // namespace

std::string summary_json(const Plan& plan, const Records& records,
                         const std::vector<Comparison>& comparisons,
                         const std::vector<FreeSpeed>& speeds) {
  const Json summary = {{"format", kStudyFormat},
                        {"study", study_json(plan.study)},
                        {"versions", versions_json(records)},
                        {"runs", runs_json(plan, records)},
                        {"freeSpeeds", speeds_json(plan, speeds)},
                        {"unequalDemand", unequal_json(plan, records)},
                        {"measures", measures_json()},
                        {"comparisons", comparisons_json(plan, comparisons)}};
  // File names need not be UTF-8; JSON must be.
  return summary.dump(kIndent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace pedzone::study
