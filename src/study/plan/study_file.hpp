// The study file (XML, schema in src/study/plan/study.xsd): which scenarios, models, seeds, and
// what varies.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pedzone::study {

/// SUMO's own pedestrian models that a study may name beside pedzone's.
inline constexpr const char* kStriping = "striping";
inline constexpr const char* kNonInteracting = "nonInteracting";
/// Whether the model is SUMO's own: plain SUMO walks everybody.
bool is_sumo_model(const std::string& model);

struct StudyScenario {
  std::string id;                         ///< default: the configuration's name without ending
  std::string file;                       ///< .sumocfg as written; see Study::resolve()
  std::string zone_file;                  ///< as written; empty: zones are found by themselves
  std::vector<std::string> sumo_options;  ///< from attribute `options`: --name, value, --name, ...
  std::string client;  ///< a shell's command that starts a client of SUMO's; empty: none
};

/// What a setting changes.
enum class SettingKind {
  kSumo,       ///< an option of SUMO, e.g. scale
  kPanel,      ///< an attribute of <pedestrians>: people more than the scenario has
  kParameter,  ///< a parameter of every zone, e.g. sight; SUMO's own models do not know it
  kZone,       ///< an attribute of every <zone>, e.g. openSpace, weather
  kClient,     ///< an option of the client's, e.g. --sensor-range
};

struct Setting {
  SettingKind kind;
  std::string key, value;
  std::string scenario;  ///< id; empty: in all scenarios
  int line = 0;          ///< of the study file, for messages
};

struct Level {
  std::string name;               ///< unique in its factor
  std::vector<Setting> settings;  ///< none: the scenario as it is
};

struct Factor {
  std::string id;
  std::vector<Level> levels;  ///< never empty
};

struct Study {
  std::string file;                      ///< as the user named it
  std::string folder;                    ///< relative paths of the study are relative to it
  std::string id;                        ///< default: the file's name without its endings
  std::string title, question;           ///< may be empty
  std::vector<StudyScenario> scenarios;  ///< never empty
  std::vector<std::string> models;       ///< never empty, with the reference
  std::string reference;                 ///< the others are compared with it
  std::vector<std::uint64_t> seeds;      ///< never empty, ascending, unique
  std::vector<Factor> factors;
  /// Combinations to run, a level's index for each factor; all of them where the file lists none.
  std::vector<std::vector<std::size_t>> combinations;
  std::optional<double> end;  ///< [s] > 0 of every run; unset: the scenario's
  double time_limit = 3600;   ///< [s] > 0 wall clock of one run

  /// A path of the study file as an absolute one.
  std::string resolve(const std::string& path) const;
};

/// Reads a study file. `folder`: where its relative paths begin; empty: where it lies. `id`: of the
/// study where the file gives none; empty: the file's name.
/// Throws InputError naming file, line, element, value and what is allowed: unknown models, factors
/// and options, empty lists, ids that occur twice, scenarios that are not there.
Study read_study(const std::string& file, const std::string& folder = "",
                 const std::string& id = "");

}  // namespace pedzone::study
