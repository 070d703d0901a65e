#include "study/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "study/plan/checksum.hpp"
#include "study/plan/setting.hpp"
#include "sumo/files/scenario.hpp"

namespace pedzone::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDefinitionFormat = 1;   // raised when the same definition comes to mean another run
constexpr std::size_t kNamePart = 24;  // [characters] of an id, for people to read
constexpr std::size_t kHashPart = 16;  // [hexadecimal digits] tell runs apart

std::vector<Condition> conditions_of(const Study& study) {
  std::vector<Condition> conditions;
  for (std::size_t scenario = 0; scenario < study.scenarios.size(); ++scenario) {
    for (const auto& levels : study.combinations) {
      Condition condition{scenario, levels, study.scenarios[scenario].id};
      for (std::size_t i = 0; i < levels.size(); ++i) {
        const Factor& factor = study.factors[i];
        condition.name += ", " + factor.id + "=" + factor.levels[levels[i]].name;
      }
      conditions.push_back(std::move(condition));
    }
  }
  return conditions;
}

/// All that decides what comes out of a run, but for the content of files.
Json definition_of(const Study& study, const Condition& condition, RunKind kind,
                   const std::string& model, std::uint64_t seed) {
  const StudyScenario& scenario = study.scenarios[condition.scenario];
  const SumoOptions options = options_of(study, condition);
  std::map<std::string, std::map<std::string, std::string>> set;  // order of factors: no matter
  for (const Setting& setting : settings_of(study, condition)) {
    if (setting.kind == SettingKind::kSumo || !knows_setting(model, setting)) continue;
    if (setting.kind == SettingKind::kClient && !has_client(scenario, kind)) continue;
    set[attribute_of(setting.kind)][setting.key] = setting.value;
  }
  std::map<std::string, std::string> sorted;
  for (std::size_t i = 0; i < options.words().size(); i += 2) {
    sorted[options.words()[i].substr(2)] = options.words()[i + 1];
  }
  Json definition;
  definition["format"] = kDefinitionFormat;
  definition["kind"] = kind == RunKind::kStudy ? "study" : "freeSpeed";
  definition["scenario"] = scenario.file;
  if (!scenario.zone_file.empty()) definition["zoneFile"] = scenario.zone_file;
  definition["sumo"] = sorted;
  if (has_client(scenario, kind)) definition["command"] = scenario.client;
  for (const auto& [what, values] : set) definition[what] = values;
  definition["model"] = model;
  definition["seed"] = seed;
  if (study.end && kind == RunKind::kStudy) definition["end"] = *study.end;
  return definition;
}

/// A part of a file name that is safe everywhere.
std::string name_part(const std::string& text) {
  const std::string stem = std::filesystem::path(text).stem().string();
  std::string part;
  for (const char c : stem.substr(0, kNamePart)) {
    const bool safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    part += safe || (!part.empty() && (c == '-' || c == '.')) ? c : '_';
  }
  return part;
}

std::string id_of(const Json& definition) {
  const bool free = definition["kind"] == "freeSpeed";
  return fmt::format(
      "{}{}.{}.{}.{}", free ? "free." : "", name_part(definition["scenario"].get<std::string>()),
      name_part(definition["model"].get<std::string>()), definition["seed"].get<std::uint64_t>(),
      sha256_hex(definition.dump()).substr(0, kHashPart));
}

/// The runs of a plan as they are found to be needed, each once.
class RunList {
 public:
  explicit RunList(Plan& plan) : plan_(plan) {}

  /// Index of the run.
  std::size_t add(RunKind kind, std::size_t condition, const std::string& model,
                  std::uint64_t seed) {
    PlannedRun run{"", kind, condition, model, seed, {}};
    run.definition = definition_of(plan_.study, plan_.conditions[condition], kind, model, seed);
    run.id = id_of(run.definition);
    const auto [known, is_new] = index_.try_emplace(run.id, plan_.runs.size());
    if (is_new) {
      plan_.runs.push_back(std::move(run));
    } else if (plan_.runs[known->second].definition != run.definition) {
      throw std::logic_error("two runs of a study have the id " + run.id);
    }
    return known->second;
  }

 private:
  Plan& plan_;
  std::unordered_map<std::string, std::size_t> index_;
};

/// Throws InputError for what only a whole condition shows: panels that make no people, files of
/// options that are not there, nobody to walk, an end before the begin.
void check_conditions(const Plan& plan) {
  std::set<std::size_t> peopled;  // scenarios that have persons
  for (const Condition& condition : plan.conditions) {
    const StudyScenario& scenario = plan.study.scenarios[condition.scenario];
    const Scenario read = scenario_of(plan.study, condition);
    if (plan.study.end) {
      require_later_end(read, *plan.study.end,
                        {.file = plan.study.file,
                         .element = "<study> attribute end",
                         .value = fmt::format("{:g}", *plan.study.end)});
    }
    const std::vector<Setting> settings = settings_of(plan.study, condition);
    const bool plain = std::ranges::none_of(settings, [](const Setting& setting) {
      return setting.kind == SettingKind::kPanel || names_input_files(setting.key);
    });
    if (plain && peopled.contains(condition.scenario)) continue;
    if (!zone_file_of(plan.study, scenario, settings).panels.empty()) continue;
    if (!names_person(read)) throw no_person(read);
    peopled.insert(condition.scenario);
  }
}

}  // namespace

bool has_client(const StudyScenario& scenario, RunKind kind) {
  return kind == RunKind::kStudy && !scenario.client.empty();
}

SumoOptions options_of(const Study& study, const Condition& condition) {
  SumoOptions options(study.scenarios[condition.scenario].sumo_options);
  for (const Setting& setting : settings_of(study, condition)) {
    if (setting.kind == SettingKind::kSumo) options.set(setting.key, setting.value);
  }
  return options;
}

Scenario scenario_of(const Study& study, const Condition& condition) {
  return read_any_scenario(study.resolve(study.scenarios[condition.scenario].file),
                           with_absolute_files(options_of(study, condition), study).words());
}

std::vector<Setting> settings_of(const Study& study, const Condition& condition) {
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < condition.levels.size(); ++i) {
    for (const Setting& setting : study.factors[i].levels[condition.levels[i]].settings) {
      const bool here =
          setting.scenario.empty() || setting.scenario == study.scenarios[condition.scenario].id;
      if (here) settings.push_back(setting);
    }
  }
  return settings;
}

bool knows_setting(const std::string& model, const Setting& setting) {
  if (!is_sumo_model(model)) return true;
  const bool weather = setting.kind == SettingKind::kZone && setting.key == "weather";
  return setting.kind != SettingKind::kParameter && setting.kind != SettingKind::kClient &&
         !weather;
}

std::vector<Setting> known_settings(const Plan& plan, const PlannedRun& run) {
  std::vector<Setting> settings = settings_of(plan.study, plan.conditions[run.condition]);
  std::erase_if(settings, [&](const Setting& each) { return !knows_setting(run.model, each); });
  return settings;
}

Plan make_plan(Study study) {
  Plan plan;
  plan.study = std::move(study);
  plan.conditions = conditions_of(plan.study);
  check_conditions(plan);
  RunList runs(plan);
  const auto add_all = [&](RunKind kind, std::uint64_t seed) {
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
      for (const std::string& model : plan.study.models) {
        plan.run_index.push_back(runs.add(kind, condition, model, seed));
      }
    }
  };
  add_all(RunKind::kFreeSpeed, plan.study.seeds.front());
  for (const std::uint64_t seed : plan.study.seeds) add_all(RunKind::kStudy, seed);
  return plan;
}

std::size_t Plan::run_of(RunKind kind, std::size_t condition, const std::string& model,
                         std::uint64_t seed) const {
  const auto place = [](const auto& list, const auto& item) {
    const auto found = std::ranges::find(list, item);
    if (found == list.end()) throw std::out_of_range("not in the study");
    return static_cast<std::size_t>(found - list.begin());
  };
  if (condition >= conditions.size()) throw std::out_of_range("not in the study");
  const std::size_t round = kind == RunKind::kFreeSpeed ? 0 : 1 + place(study.seeds, seed);
  const std::size_t row = round * conditions.size() + condition;
  return run_index.at(row * study.models.size() + place(study.models, model));
}

}  // namespace pedzone::study
