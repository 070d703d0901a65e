#include "app/run_animation.hpp"

#include <filesystem>

#include "app/command_line/terminal.hpp"
#include "app/recording_options.hpp"
#include "sumo/files/fcd_output.hpp"
#include "sumo/files/people_file.hpp"
#include "view/animation.hpp"

namespace pedzone {
namespace {

constexpr const char* kRecorded = "fcd.xml.gz";

/// The file that SUMO has written, with an output-prefix of the user's before its name.
std::string with_prefix(const std::string& file, const std::string& folder) {
  namespace fs = std::filesystem;
  if (fs::exists(file)) return file;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().ends_with(kRecorded)) return entry.path().string();
  }
  return file;
}

std::string trajectories_in(const std::string& folder) { return folder + "/walked.csv.gz"; }

/// People that pedzone made itself are in no file of the scenario.
std::string write_people(const RunOptions& options, const Simulation& simulation) {
  const ZoneFile zone_file = read_zone_file(options.zone_file, options.panel);
  if (zone_file.panels.empty()) return {};
  const Scenario scenario = read_scenario(options.config, options.sumo_options);
  const std::string file = options.scratch + "/people.rou.xml";
  write_complete_file(file,
                      people_file({scenario, simulation.network(), simulation.zones(),
                                   zone_file.profiles, zone_file.panels, options.seed}),
                      "--animate");
  return file;
}

}  // namespace

std::string record_everybody(Scenario& scenario, const std::string& folder) {
  if (const auto said = fcd_output_of(scenario)) return *said;
  std::string file = folder + "/" + kRecorded;
  write_everybody(scenario, file);
  return file;
}

RunAnimation::RunAnimation(const RunOptions& options)
    : options_(options),
      page_(options.animation, "--animate"),
      trajectories_(trajectories_in(options.scratch), "--animate") {}

void RunAnimation::write(const Simulation& simulation) {
  trajectories_.finish();
  RecordingOptions source;
  source.source.file = trajectories_in(options_.scratch);
  source.source.fcd = with_prefix(options_.recorded, options_.scratch);
  source.source.needs_person = false;
  source.scenario = options_.config;
  source.sumo_options = options_.sumo_options;
  source.zone_file = options_.zone_file;
  if (std::string people = write_people(options_, simulation); !people.empty()) {
    source.types.push_back(std::move(people));
  }
  const Recording recording = read_recording(source);
  empty_ = recording.times.empty();
  if (empty_) return;
  const std::unique_ptr<Place> place = read_place(source);
  page_.write(animation_page({{"pedzone", &recording}}, place.get(),
                             {.title = name_of_file(options_.config)}));
}

void RunAnimation::finish() {
  if (!empty_) return page_.finish();
  print_warning("nobody was there, no vehicle either: " + options_.animation + " is not written.");
}

}  // namespace pedzone
