#include "study/report/run_recording.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "sumo/files/place_reader.hpp"
#include "sumo/files/type_files.hpp"

namespace pedzone::study {
namespace {

namespace fs = std::filesystem;

Scenario scenario_of_run(const Plan& plan, const PlannedRun& run) {
  return scenario_of(plan.study, plan.conditions[run.condition]);
}

std::string text_of(const std::string& file) {
  std::ifstream input(file);
  return {std::istreambuf_iterator<char>(input), {}};
}

}  // namespace

const Place& RunPlaces::of(const PlannedRun& run, const std::string& folder) {
  const std::string zone_file = (fs::path(folder) / kZoneFile).string();
  const Scenario scenario = scenario_of_run(plan_, run);
  const std::string key =
      fmt::format("{}\n{}\n{}", scenario.net_file, fmt::join(scenario.additional_files, ","),
                  text_of(zone_file));
  const auto known = places_.find(key);
  if (known != places_.end()) return known->second;
  return places_.emplace(key, read_place(scenario, fs::exists(zone_file) ? zone_file : ""))
      .first->second;
}

RecordingCast run_cast(const Plan& plan, const PlannedRun& run, const std::string& folder) {
  const fs::path people = fs::path(folder) / kPeopleFile;
  std::vector<std::string> more;
  if (fs::exists(people)) more.push_back(people.string());
  return read_type_files<RecordingCast>(scenario_of_run(plan, run), more);
}

}  // namespace pedzone::study
