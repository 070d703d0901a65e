// A study as the runs that it needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "study/plan/study_file.hpp"
#include "study/plan/sumo_options.hpp"
#include "sumo/files/scenario.hpp"

namespace pedzone::study {

enum class RunKind {
  kStudy,      ///< the scenario as the study says
  kFreeSpeed,  ///< a few of its people, one after the other, without vehicles (fair pairs)
};

/// A scenario with one level of each factor.
struct Condition {
  std::size_t scenario = 0;         ///< index into Study::scenarios
  std::vector<std::size_t> levels;  ///< index for each factor
  std::string name;                 ///< for people: "plaza, demand=high"
};

struct PlannedRun {
  std::string id;  ///< [A-Za-z0-9._-]+, at most 100 characters: the name of its directory. The same
                   ///< for the same definition, in whatever study or order.
  RunKind kind = RunKind::kStudy;
  std::size_t condition = 0;  ///< the first of the conditions that need it
  std::string model;
  std::uint64_t seed = 0;
  /// All that decides what comes out, but for the content of files: scenario, zone file, options,
  /// settings that this model knows, model, seed, end. Paths as written in the study file.
  nlohmann::ordered_json definition;
};

struct Plan {
  Study study;
  std::vector<Condition> conditions;
  std::vector<PlannedRun>
      runs;  ///< each once; free-speed runs first, then by seed, condition, model

  std::vector<std::size_t> run_index;  ///< what run_of() looks up

  /// Index of the run for this; conditions that differ only in what a model of SUMO does not know
  /// share theirs.
  /// The seed of a free-speed run does not matter. Throws std::out_of_range for unknown ones.
  std::size_t run_of(RunKind kind, std::size_t condition, const std::string& model,
                     std::uint64_t seed) const;
};

/// The condition's settings for its scenario, in the order of the factors.
std::vector<Setting> settings_of(const Study& study, const Condition& condition);
/// The options for SUMO, those of the scenario with those settings.
SumoOptions options_of(const Study& study, const Condition& condition);
/// The condition's scenario, with those options and their files. Throws InputError.
Scenario scenario_of(const Study& study, const Condition& condition);
/// Whether a client is started in such runs: who walks alone meets nobody.
bool has_client(const StudyScenario& scenario, RunKind kind);
/// Whether the setting changes anything for the model: SUMO's own know neither parameters nor
/// weather.
bool knows_setting(const std::string& model, const Setting& setting);

/// Free-speed runs are made with the first seed, for each condition and model.
Plan make_plan(Study study);

/// The settings that matter for a run.
std::vector<Setting> known_settings(const Plan& plan, const PlannedRun& run);

/// In a run's folder, where there are such.
inline constexpr const char* kZoneFile = "zone.zone.xml";
inline constexpr const char* kAllEdges = "all-edges.txt";     ///< where SUMO is to write some only
inline constexpr const char* kPeopleFile = "people.rou.xml";  ///< of the panel, or set apart

/// What is done for a run, in a folder of its own.
struct RunCommands {
  struct File {
    std::string name;  ///< in the run's folder
    std::string text;
    bool operator==(const File&) const = default;
  };
  std::vector<File> files;                         ///< to be written before
  std::vector<std::vector<std::string>> commands;  ///< program and arguments; in turn
  std::vector<std::string> sumo_options;           ///< as SUMO gets them, paths absolute
  std::vector<std::string> inputs;                 ///< run_inputs()
};

/// The files whose content decides what comes out of a run; absolute, ascending. Much cheaper than
/// run_commands(). Throws InputError.
std::vector<std::string> run_inputs(const Plan& plan, const PlannedRun& run);

/// The commands of a run whose outputs go to the absolute path `folder`: fcd.xml.gz, tripinfo.xml,
/// statistics.xml, with pedzone also summary.json, and trajectories.csv of free-speed runs. They
/// are to be started in Study::folder. `pedzone`: absolute path of the program. Throws InputError.
RunCommands run_commands(const Plan& plan, const PlannedRun& run, const std::string& pedzone,
                         const std::string& folder);

/// The zone file of a condition: the scenario's with the condition's settings, as text; empty where
/// there is neither. Throws InputError.
std::string zone_text(const Plan& plan, std::size_t condition);

/// The same for a run: without what its model does not know, and in a free-speed run without
/// people to be made and vehicles on a path.
std::string zone_text(const Plan& plan, const PlannedRun& run);

}  // namespace pedzone::study
