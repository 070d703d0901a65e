#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "study/report/report_numbers.hpp"
#include "study/report/report_parts.hpp"
#include "zone/zone_file.hpp"

namespace pedzone::study::report {
namespace {

constexpr std::size_t kMostFailures = 40;  // shown; the others are in runs.csv
constexpr std::size_t kMostLog = 4000;     // [bytes] of the end of one log
constexpr std::size_t kMostExamples = 5;   // of pairs that are not equal

/// "1 to 20, 61".
std::string seeds_text(const std::vector<std::uint64_t>& seeds) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < seeds.size();) {
    std::size_t last = i;
    while (last + 1 < seeds.size() && seeds[last + 1] == seeds[last] + 1) ++last;
    parts.push_back(last == i ? std::to_string(seeds[i])
                              : fmt::format("{} to {}", seeds[i], seeds[last]));
    i = last + 1;
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string setting_text(const Setting& setting) {
  const char* kind = setting.kind == SettingKind::kSumo        ? "SUMO's "
                     : setting.kind == SettingKind::kPanel     ? "panel's "
                     : setting.kind == SettingKind::kParameter ? "parameter "
                     : setting.kind == SettingKind::kClient    ? "client's "
                                                               : "zone's ";
  std::string text = fmt::format("{}{} = {}", kind, setting.key, setting.value);
  if (!setting.scenario.empty()) text += fmt::format(" ({})", setting.scenario);
  return text;
}

Json factors(const Study& study) {
  Json all = Json::array();
  for (const Factor& factor : study.factors) {
    Json levels = Json::array();
    for (const Level& level : factor.levels) {
      std::vector<std::string> settings;
      for (const Setting& one : level.settings) settings.push_back(setting_text(one));
      levels.push_back(
          {{"name", level.name},
           {"settings", settings.empty() ? "the scenario as it is"
                                         : fmt::format("{}", fmt::join(settings, ", "))}});
    }
    all.push_back({{"id", factor.id}, {"levels", levels}});
  }
  return all;
}

Json models(const Study& study) {
  Json all = Json::array();
  for (const std::string& model : study.models) {
    std::string what = model == kStriping ? "SUMO's own default: people walk in stripes of lanes"
                       : model == kNonInteracting ? "SUMO's own: people do not mind each other"
                       : model.find('/') != std::string::npos ? "a plug-in, in pedzone"
                                                              : "pedzone's, in the zones";
    if (model == study.reference) what += "; the others are compared with it";
    all.push_back({{"name", model}, {"what", what}});
  }
  return all;
}

/// Settings that SUMO's own models do not know.
std::vector<std::string> unknown_to_sumo(const Study& study) {
  std::set<std::string> keys;
  for (const Factor& factor : study.factors) {
    for (const Level& level : factor.levels) {
      for (const Setting& one : level.settings) {
        const bool weather = one.kind == SettingKind::kZone && one.key == "weather";
        if (one.kind == SettingKind::kParameter || weather) keys.insert(one.key);
      }
    }
  }
  return {keys.begin(), keys.end()};
}

/// Whether a zone file has vehicles follow paths of their own.
bool steers_vehicles(const Study& study) {
  return std::ranges::any_of(study.scenarios, [&](const StudyScenario& scenario) {
    return !scenario.zone_file.empty() &&
           !read_zone_file(study.resolve(scenario.zone_file)).vehicle_paths.empty();
  });
}

/// Whether the models of a pair had the same people and vehicles to move.
Json fairness(const Input& input) {
  const Plan& plan = input.plan;
  std::vector<std::string> unequal;
  for (const UnequalDemand& one : unequal_demands(plan, input.records)) {
    unequal.push_back(fmt::format("{} of {} in {} (seeds {})", one.what, one.model,
                                  plan.conditions[one.condition].name, seeds_text(one.seeds)));
  }
  if (unequal.empty()) {
    return {{"text",
             "Within each pair both models had the same people and the same vehicles to "
             "move, with the same intended departures and types."},
            {"warning", false}};
  }
  const std::size_t more = unequal.size() - std::min(unequal.size(), kMostExamples);
  unequal.resize(unequal.size() - more);
  std::string text = "The models did not have the same to move: " + joined(unequal);
  if (more > 0) text += fmt::format(", and {}", count_text(more, "case more", "cases more"));
  return {{"text", text + "."}, {"warning", true}};
}

Json unequal(const Study& study) {
  Json all = Json::array();
  all.push_back(
      "When a vehicle really enters: it waits where its place is taken, and where people "
      "are differs by model.");
  all.push_back(
      "Chance beside the demand: each model draws its own numbers, so that one seed is "
      "the same task, not the same course of events.");
  all.push_back(
      "Bodies: pedzone's people are discs and keep from overlapping; SUMO's stand in "
      "stripes of a lane, and its vehicles mind them on lanes and crossings only.");
  all.push_back(
      "Outside the zones SUMO walks everybody, by striping where the model is one of pedzone's; so "
      "it does at junctions between a zone and other streets. Conflicts there do not count.");
  if (std::ranges::none_of(study.models, is_sumo_model)) return all;
  if (steers_vehicles(study)) {
    all.push_back(
        "Vehicles that follow a path of the zone file (<vehiclePath>): with SUMO's own models "
        "they keep to their lanes and speeds.");
  }
  const std::vector<std::string> keys = unknown_to_sumo(study);
  if (!keys.empty()) {
    all.push_back(
        fmt::format("SUMO's own models do not know {}: one run of theirs stands for all "
                    "levels of it.",
                    joined(keys)));
  }
  return all;
}

}  // namespace

Json setup_part(const Input& input) {
  const Study& study = input.plan.study;
  Json scenarios = Json::array();
  for (const StudyScenario& one : study.scenarios) {
    std::string options = fmt::format("{}", fmt::join(one.sumo_options, " "));
    if (!one.client.empty()) options += (options.empty() ? "client: " : "; client: ") + one.client;
    scenarios.push_back(
        {{"id", one.id}, {"file", one.file}, {"zone", one.zone_file}, {"options", options}});
  }
  std::size_t done = 0, failed = 0;
  for (const auto& record : input.records) {
    if (record && record->status == RunStatus::kDone) ++done;
    if (record && record->status == RunStatus::kFailed) ++failed;
  }
  const std::size_t missing = input.plan.runs.size() - done - failed;
  std::string runs = fmt::format("{} of {} done", done, input.plan.runs.size());
  if (failed > 0) runs += fmt::format(", {} failed", failed);
  if (missing > 0) runs += fmt::format(", {} not there yet", missing);
  const auto several = [](std::size_t count) { return count > 1; };
  return {{"scenarios", scenarios},
          {"models", models(study)},
          {"factors", factors(study)},
          {"varies", !study.factors.empty()},
          {"conditions", input.plan.conditions.size()},
          {"several", several(input.plan.conditions.size())},
          {"seeds", fmt::format("{} ({})", study.seeds.size(), seeds_text(study.seeds))},
          {"end", study.end ? fmt::format("{:g} s", *study.end) : std::string("the scenario's")},
          {"runs", runs},
          {"incomplete", failed + missing > 0},
          {"fairness", fairness(input)},
          {"unequal", unequal(study)}};
}

Json failures_part(const Input& input) {
  Json all = Json::array();
  std::size_t failed = 0;
  for (std::size_t i = 0; i < input.plan.runs.size(); ++i) {
    const auto& record = input.records[i];
    if (!record || record->status != RunStatus::kFailed || ++failed > kMostFailures) continue;
    const PlannedRun& run = input.plan.runs[i];
    const std::size_t line = record->failure.find('\n');
    std::string log = line == std::string::npos ? "" : record->failure.substr(line + 1);
    if (log.size() > kMostLog) log = "...\n" + log.substr(log.size() - kMostLog);
    all.push_back({{"id", run.id},
                   {"condition", input.plan.conditions[run.condition].name},
                   {"model", run.model},
                   {"seed", run.seed},
                   {"free", run.kind == RunKind::kFreeSpeed},
                   {"why", record->failure.substr(0, line)},
                   {"log", log}});
  }
  return {{"any", failed > 0},
          {"count", count_text(failed, "run", "runs")},
          {"runs", all},
          {"more", failed > kMostFailures ? failed - kMostFailures : 0},
          {"cut", failed > kMostFailures}};
}

}  // namespace pedzone::study::report
