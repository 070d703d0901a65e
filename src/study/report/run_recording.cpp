#include "study/report/run_recording.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "sumo/place_reader.hpp"

namespace pedzone {
namespace {

namespace fs = std::filesystem;

Scenario scenario_of(const Plan& plan, const PlannedRun& run) {
  const StudyScenario& scenario = plan.study.scenarios[plan.conditions[run.condition].scenario];
  return read_any_scenario(plan.study.resolve(scenario.file), scenario.sumo_options);
}

}  // namespace

const Place& RunPlaces::of(const PlannedRun& run, const std::string& folder) {
  const std::string zone_file = (fs::path(folder) / "zone.zone.xml").string();
  std::ifstream input(zone_file);
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  const std::string key = std::to_string(plan_.conditions[run.condition].scenario) + '\n' + text;
  const auto known = places_.find(key);
  if (known != places_.end()) return known->second;
  return places_
      .emplace(key, read_place(scenario_of(plan_, run), fs::exists(zone_file) ? zone_file : ""))
      .first->second;
}

RecordingCast run_cast(const Plan& plan, const PlannedRun& run, const std::string& folder) {
  const Scenario scenario = scenario_of(plan, run);
  RecordingCast cast;
  for (const std::string& file : scenario.additional_files) cast.read(file);
  for (const std::string& file : scenario.route_files) cast.read(file);
  const fs::path people = fs::path(folder) / "people.rou.xml";
  if (fs::exists(people)) cast.read(people.string());
  return cast;
}

}  // namespace pedzone
