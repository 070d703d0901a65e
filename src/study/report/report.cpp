#include "study/report/report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <ctime>
#include <filesystem>
#include <map>
#include <set>

#include "conflict/gap_acceptance.hpp"
#include "core/shell_word.hpp"
#include "pages/page_builder.hpp"
#include "study/report/report_numbers.hpp"
#include "study/report/report_parts.hpp"

namespace pedzone {

// Made from study/report by the build.
extern const std::string_view kReportPage, kReportStyles, kReportScripts;

namespace study {
namespace report {
namespace {

/// A file's name, without the folders of somebody's machine, as such a word.
std::string file_word(const std::string& path) {
  return shell_word(std::filesystem::path(path).filename().string());
}

std::map<std::string, std::set<std::string>> versions(const Input& input) {
  std::map<std::string, std::set<std::string>> all;
  for (const auto& record : input.records) {
    if (!record) continue;
    for (const auto& [name, version] : record->versions) all[name].insert(version);
  }
  return all;
}

Json version_list(const Input& input) {
  Json list = Json::array();
  for (const auto& [name, found] : versions(input)) {
    list.push_back({{"name", name == "build" ? "checksum of the program pedzone" : name},
                    {"version", fmt::format("{}", fmt::join(found, ", "))}});
  }
  return list;
}

/// "2026-11-23, with pedzone 0.1.0 and SUMO 1.15.0".
std::string made_text(const Input& input) {
  std::vector<std::string> programs;
  for (const auto& [name, found] : versions(input)) {
    if (name == "build") continue;
    // SUMO says: "Eclipse SUMO sumo Version 1.15.0".
    const std::string version = fmt::format("{}", fmt::join(found, ", "));
    programs.push_back((name == "sumo" ? "SUMO" : name) + ' ' +
                       version.substr(version.rfind(' ') + 1));
  }
  return fmt::format("{:%Y-%m-%d}, with {}", fmt::gmtime(std::time(nullptr)), joined(programs));
}

/// Sections of one condition: its maps, and the places of its charts over time.
Json conditions(const Input& input, const Json& maps, const Json& lines) {
  Json all = Json::array();
  for (std::size_t i = 0; i < pictured(input.plan); ++i) {
    const bool drawn = !maps[i].empty(), series = !lines[i].empty();
    if (!drawn && !series) continue;
    all.push_back({{"index", i},
                   {"name", input.plan.conditions[i].name},
                   {"open", all.empty()},
                   {"series", series},
                   {"maps", maps[i]}});
  }
  return all;
}

Json scene_list(const std::vector<ReportScene>& scenes) {
  Json all = Json::array();
  for (const ReportScene& one : scenes) {
    all.push_back(
        {{"index", all.size()},
         {"title", one.title},
         {"caption", one.caption},
         {"wide", one.wide},
         {"still_html", one.still.substr(std::min(one.still.find("<svg"), one.still.size()))}});
  }
  return all;
}

Json script_data(const Input& input, const Json& lines, const Json& gaps) {
  Json names = Json::array();
  for (const Condition& one : input.plan.conditions) names.push_back(one.name);
  Json data{{"models", input.plan.study.models},
            {"reference", input.plan.study.reference},
            {"conditions", names},
            {"distributions", distributions(input)},
            {"series", lines}};
  if (!gaps.empty()) data["gaps"] = {{"longest", kLongestGap}, {"groups", gaps}};
  return data;
}

Json page_data(const Input& input, const Json& lines, const Json& gaps) {
  const Study& study = input.plan.study;
  Json data;
  data["title"] = study.title.empty() ? study.id : study.title;
  data["question"] = study.question;
  data["reference"] = study.reference;
  data["verdict"] = verdict_part(input);
  data["setup"] = setup_part(input);
  data["tables"] = tables_part(input);
  const Json maps = maps_part(input);
  data["grounds"] = maps["grounds"];
  data["areas"] = maps["areas"];
  data["demand"] = demand_part(input);
  data["made"] = made_text(input);
  data["conditions"] = conditions(input, maps["conditions"], lines);
  data["gaps"] = gaps_part(input, gaps);
  data["pictured"] = pictured(input.plan);
  data["cut"] = pictured(input.plan) < input.plan.conditions.size();
  data["several"] = input.plan.conditions.size() > 1;
  data["failures"] = failures_part(input);
  data["versions"] = version_list(input);
  data["command"] = fmt::format("pedzone study run {} --out {}", file_word(study.file),
                                file_word(input.store.folder()));
  return data;
}

}  // namespace

std::size_t pictured(const Plan& plan) { return std::min(plan.conditions.size(), kMostPictured); }

std::vector<std::string> others(const Plan& plan) {
  std::vector<std::string> models = plan.study.models;
  std::erase(models, plan.study.reference);
  return models;
}

std::optional<std::size_t> first_done_run(const Input& input, std::size_t condition) {
  for (const std::string& model : input.plan.study.models) {
    for (const std::uint64_t seed : input.plan.study.seeds) {
      if (done_run(input, condition, model, seed) == nullptr) continue;
      return input.plan.run_of(RunKind::kStudy, condition, model, seed);
    }
  }
  return {};
}

const RunRecord* done_run(const Input& input, std::size_t condition, const std::string& model,
                          std::uint64_t seed) {
  const auto& record = input.records[input.plan.run_of(RunKind::kStudy, condition, model, seed)];
  return record && record->status == RunStatus::kDone ? &*record : nullptr;
}

std::vector<std::string> run_folders(const Input& input, std::size_t condition,
                                     const std::string& model) {
  std::vector<std::string> folders;
  for (const std::uint64_t seed : input.plan.study.seeds) {
    const RunRecord* run = done_run(input, condition, model, seed);
    if (run != nullptr) folders.push_back(input.store.run_folder(run->id));
  }
  return folders;
}

}  // namespace report

std::string report_page(const Store& store, const Plan& plan, const Records& records,
                        const std::vector<Comparison>& comparisons,
                        const std::vector<FreeSpeed>& speeds) {
  using namespace report;
  const Input input{store, plan, records, comparisons, speeds};
  const Json lines = series(input), crossing_gaps = gaps(input);
  const std::vector<ReportScene> scenes = report_scenes(store, plan, records);
  Json data = page_data(input, lines, crossing_gaps);
  data["scenes"] = scene_list(scenes);
  data["played"] = !scenes.empty();
  Json pages = Json::array();
  for (const ReportScene& one : scenes) pages.push_back(one.page);
  return rendered_page({kReportPage, kReportStyles, kReportScripts}, data,
                       script_data(input, lines, crossing_gaps),
                       {{"scene_pages", script_json(pages)}});
}

}  // namespace study
}  // namespace pedzone
