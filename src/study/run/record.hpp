// What is kept of one run: a record, and files beside it in the run's directory.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pedzone::study {

/// Raised when a record's or a measure's meaning changes.
inline constexpr int kStudyFormat = 3;

enum class RunStatus {
  kDone,
  kFailed,  ///< twice, by itself: crashed, hung, ended with an error
  kKilled,  ///< from outside: is run again when the study is resumed
};

/// done, failed or killed: as in records and tables.
const char* status_name(RunStatus status);

/// record.json of a run's directory. Beside it lie fcd.xml.gz, tripinfo.xml, log.txt, and the
/// tables of run_measures.hpp.
struct RunRecord {
  std::string id;
  RunStatus status = RunStatus::kDone;
  std::string failure;  ///< why it failed, in a sentence; the end of its log follows
  nlohmann::ordered_json definition;
  std::map<std::string, std::string> inputs;    ///< SHA-256 by path
  std::map<std::string, std::string> versions;  ///< see versions.hpp
  std::vector<std::vector<std::string>> commands;
  std::map<std::string, double> measures;  ///< by key of measure_list(); missing where undefined
  /// Who was to travel, from SUMO's own outputs: SHA-256 of the sorted list of persons (and of
  /// vehicles) with intended departure and type. Equal in runs that are a fair pair.
  std::map<std::string, std::string> demand;
  int attempts = 1;
  double wall_s = 0.0;  ///< [s]; never in a table that is compared
};

/// Records of a plan's runs, by index of Plan::runs; unset where there is none yet.
using Records = std::vector<std::optional<RunRecord>>;

std::string record_text(const RunRecord& record);  ///< JSON
/// Throws InputError where it is none, or of another format.
RunRecord read_record(const std::string& file);

}  // namespace pedzone::study
