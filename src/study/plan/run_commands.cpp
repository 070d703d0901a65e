// What is done for a run: SUMO's or pedzone's command line, and the files that it needs.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/shell_word.hpp"
#include "core/text.hpp"
#include "core/xml.hpp"
#include "study/plan/additional_copy.hpp"
#include "study/plan/free_speed_demand.hpp"
#include "study/plan/plan.hpp"
#include "study/plan/setting.hpp"
#include "study/plan/sumo_options.hpp"
#include "sumo/files/file_list.hpp"
#include "sumo/files/people_file.hpp"
#include "sumo/files/scenario.hpp"
#include "world/model_names.hpp"
#include "zone/any_zones.hpp"
#include "zone/zone_file.hpp"

namespace pedzone::study {
namespace {

namespace fs = std::filesystem;

/// Puts the commands of one run together.
class Commands {
 public:
  Commands(const Plan& plan, const PlannedRun& run, const std::string& pedzone,
           const std::string& folder)
      : study_(plan.study),
        run_(run),
        pedzone_(pedzone),
        folder_(folder),
        scenario_(study_.scenarios[plan.conditions[run.condition].scenario]),
        config_(study_.resolve(scenario_.file)),
        zone_text_(zone_text(plan, run)),
        settings_(known_settings(plan, run)),
        end_(study_.end) {
    read_ = scenario_of(study_, plan.conditions[run.condition]);
    options_ = SumoOptions(read_.sumo_options);
    additional_files_ = read_.additional_files;
    if (!zone_text_.empty()) commands_.files.push_back({kZoneFile, zone_text_});
  }

  RunCommands take() {
    commands_.inputs = inputs();  // before options name files that are made for the run
    redirect_outputs();
    copy_additional_files();
    measure();
    if (run_.kind == RunKind::kFreeSpeed) set_people_apart();
    name_additional_files();
    if (makes_people()) make_people();
    if (is_sumo_model(run_.model)) {
      if (makes_people()) add_people();
      commands_.commands.push_back(sumo());
    } else {
      commands_.commands.push_back(pedzone());
    }
    commands_.sumo_options = options_.words();
    return std::move(commands_);
  }

  /// All files that are read, as long as the options are the study's.
  std::vector<std::string> inputs() const {
    std::vector<std::string> files{config_, read_.net_file};
    for (const auto* more : {&read_.route_files, &read_.additional_files}) {
      files.insert(files.end(), more->begin(), more->end());
    }
    for (const std::string& additional : read_.additional_files) {
      for (const std::string& file : files_named_in(additional)) files.push_back(file);
    }
    for (std::size_t i = 0; i < options_.words().size(); i += 2) {
      if (!names_input_files(options_.words()[i].substr(2))) continue;
      for (const auto& file : split_file_list(options_.words()[i + 1])) files.push_back(file);
    }
    if (has_client(scenario_, run_.kind)) {
      for (const std::string& word : split_words(scenario_.client)) {
        const std::string file = study_.resolve(word);
        if (fs::is_regular_file(file)) files.push_back(file);
      }
    }
    if (!scenario_.zone_file.empty()) {
      const std::string zone_file = study_.resolve(scenario_.zone_file);
      files.push_back(zone_file);
      for (const VehiclePathSpec& path : read_zone_file(zone_file).vehicle_paths) {
        files.push_back(path.file);
      }
    }
    if (names_plugin(run_.model)) files.push_back(study_.resolve(run_.model));
    for (std::string& file : files) file = fs::path(file).lexically_normal().string();
    std::ranges::sort(files);
    files.erase(std::unique(files.begin(), files.end()), files.end());
    return files;
  }

 private:
  std::string in_folder(const std::string& name) const { return folder_ + "/" + name; }
  bool makes_people() const { return zone_text_.find("<pedestrians") != std::string::npos; }

  /// Runs go on side by side: what the configuration has SUMO write goes to the run's folder, and
  /// what would change the files that are measured is as SUMO has it by default.
  void redirect_outputs() {
    const auto take_over = [&](const std::string& name, const std::string& value) {
      if (names_output_file(name)) {
        options_.set(name, in_folder(fs::path(value).filename().string()));
      } else if (const auto neutral = neutral_sumo_value(name)) {
        options_.set(name, *neutral);
      }
    };
    const SumoOptions given = options_;
    std::vector<std::string> lists;
    const XmlFile config(config_);
    for (const auto& found : config.root().select_nodes(".//*[@value]")) {
      const auto name = known_sumo_option(found.node().name());
      if (!name || given.find(*name)) continue;
      if (is_measuring_list(*name)) {
        lists.push_back(*name);
      } else {
        take_over(*name, found.node().attribute("value").value());
      }
    }
    for (std::size_t i = 0; i < given.words().size(); i += 2) {
      take_over(given.words()[i].substr(2), given.words()[i + 1]);
    }
    for (const std::string& list : lists) list_everything(list);
  }

  /// SUMO takes an empty list for one that names nothing, and none can be taken back on the command
  /// line: everything is named instead.
  void list_everything(const std::string& list) {
    if (const auto chance = chance_instead_of(list)) return options_.set(*chance, "1");
    std::string edges;
    for (const Edge& edge : read_scenario_network(read_).edges) edges += edge.id + "\n";
    commands_.files.push_back({kAllEdges, std::move(edges)});
    options_.set(list, in_folder(kAllEdges));
  }

  /// The same for what additional files have SUMO write. Nobody but the chosen moves in a
  /// free-speed run.
  void copy_additional_files() {
    for (std::size_t i = 0; i < additional_files_.size(); ++i) {
      const std::string prefix = fmt::format("additional-{}.", i + 1);
      std::optional<std::string> copy =
          additional_copy(additional_files_[i], in_folder(prefix), run_.kind == RunKind::kStudy);
      if (!copy) continue;
      commands_.files.push_back({prefix + "xml", std::move(*copy)});
      additional_files_[i] = in_folder(prefix + "xml");
    }
  }

  /// Named on the command line, additional files take the place of the configuration's.
  void name_additional_files() {
    if (additional_files_ == read_.additional_files) return;
    options_.set("additional-files", fmt::format("{}", fmt::join(additional_files_, ",")));
  }

  void measure() {
    options_.set("fcd-output", in_folder("fcd.xml.gz"));
    options_.set("tripinfo-output", in_folder("tripinfo.xml"));
    options_.set("statistic-output", in_folder("statistics.xml"));
    options_.set("tripinfo-output.write-unfinished", "true");
    options_.set("tripinfo-output.write-undeparted", "true");
    options_.set("precision", "4");
  }

  /// The demand of a free-speed run instead of the scenario's.
  void set_people_apart() {
    const ZoneFile file = zone_file_of(study_, scenario_, settings_);
    const Network network = read_scenario_network(read_);
    const std::vector<Zone> zones = build_any_zones(network, file.zones);
    std::unordered_set<int> edges;
    for (const Zone& zone : zones) edges.insert(zone.edges.begin(), zone.edges.end());
    // Without a zone SUMO walks everybody everywhere.
    const std::size_t everywhere = zones.empty() ? network.edges.size() : 0;
    for (std::size_t i = 0; i < everywhere; ++i) edges.insert(static_cast<int>(i));
    std::string panel;
    if (!file.panels.empty()) {
      panel = people_file({read_, network, zones, file.profiles, file.panels, run_.seed});
    }
    FreeSpeedDemand demand =
        free_speed_demand({read_, network, edges, panel, read_numbers(read_).begin});
    end_ = demand.end;
    commands_.files.push_back({kPeopleFile, std::move(demand.routes)});
    options_.set("route-files", in_folder(kPeopleFile));
    options_.set("scale", "1");
  }

  /// The panel's people as a file: SUMO's own models are given them so, and the measures learn who
  /// they are.
  void make_people() {
    std::vector<std::string> command{pedzone_,
                                     "demand",
                                     config_,
                                     "--zone",
                                     in_folder(kZoneFile),
                                     "--seed",
                                     std::to_string(run_.seed),
                                     "--out",
                                     in_folder(kPeopleFile)};
    append_options(command);
    commands_.commands.push_back(std::move(command));
  }

  void add_people() {
    additional_files_.push_back(in_folder(kPeopleFile));
    name_additional_files();
  }

  std::vector<std::string> sumo() {
    options_.set("pedestrian.model", run_.model);
    options_.set("seed", std::to_string(run_.seed));
    if (end_) options_.set("end", fmt::format("{}", *end_));
    std::vector<std::string> command{"sumo", "-c", config_, "--no-step-log", "true"};
    command.insert(command.end(), options_.words().begin(), options_.words().end());
    return command;
  }

  std::vector<std::string> pedzone() {
    std::vector<std::string> command{pedzone_, "run", config_};
    if (!zone_text_.empty()) command.insert(command.end(), {"--zone", in_folder(kZoneFile)});
    command.insert(command.end(),
                   {"--model", run_.model, "--seed", std::to_string(run_.seed), "--threads", "1"});
    if (end_) command.insert(command.end(), {"--end", fmt::format("{}", *end_)});
    command.insert(command.end(), {"--summary", in_folder("summary.json")});
    // Only who walks alone is measured by it, and it is ten times as large as all else.
    if (run_.kind == RunKind::kFreeSpeed) {
      command.insert(command.end(), {"--trajectories", in_folder("trajectories.csv")});
    }
    if (has_client(scenario_, run_.kind)) command.insert(command.end(), {"--client", client()});
    append_options(command);
    return command;
  }

  /// Its command with the options that the settings say, as {folder} the run's.
  std::string client() const {
    std::string command = scenario_.client;
    for (const Setting& setting : settings_) {
      if (setting.kind != SettingKind::kClient) continue;
      command += fmt::format(" {} {}", setting.key, shell_word(setting.value));
    }
    const std::string place = "{folder}";
    for (std::size_t at = 0; (at = command.find(place, at)) != std::string::npos;) {
      command.replace(at, place.size(), shell_word(folder_));
    }
    return command;
  }

  void append_options(std::vector<std::string>& command) const {
    command.push_back("--");
    command.insert(command.end(), options_.words().begin(), options_.words().end());
  }

  const Study& study_;
  const PlannedRun& run_;
  const std::string pedzone_, folder_;
  const StudyScenario& scenario_;
  const std::string config_, zone_text_;
  const std::vector<Setting> settings_;
  std::optional<double> end_;  ///< [s]
  SumoOptions options_;
  Scenario read_;
  std::vector<std::string> additional_files_;  ///< as the run reads them
  RunCommands commands_;
};

}  // namespace

std::vector<std::string> run_inputs(const Plan& plan, const PlannedRun& run) {
  return Commands(plan, run, "", "").inputs();
}

RunCommands run_commands(const Plan& plan, const PlannedRun& run, const std::string& pedzone,
                         const std::string& folder) {
  return Commands(plan, run, pedzone, folder).take();
}

}  // namespace pedzone::study
