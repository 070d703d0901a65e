#include "app/recording_options.hpp"

#include "app/share_bar.hpp"
#include "sumo/files/place_reader.hpp"

namespace pedzone {

void add_recording_options(CLI::App& command, RecordingOptions& options) {
  RecordingSource& source = options.source;
  command
      .add_option("recording", source.file,
                  "SUMO's fcd-output or pedzone's --trajectories, gzipped or not")
      ->required();
  command.add_option("--fcd", source.fcd,
                     "fcd-output of the same run: vehicles, and people whom SUMO walks");
  auto* scenario = command.add_option(
      "--scenario", options.scenario,
      "SUMO configuration: network, polygons, waypoints, sizes, profiles, groups");
  command.add_option("--zone", options.zone_file, "Zone file (.zone.xml)")->needs(scenario);
  add_recording_filter(command, options);
}

void add_recording_filter(CLI::App& command, RecordingOptions& options) {
  RecordingSource& source = options.source;
  command
      .add_option("--vtypes", options.types,
                  "More route or additional files that tell sizes, profiles and groups")
      ->allow_extra_args(false);
  command.add_option("--begin", source.begin, "Show from this time on [s]")
      ->check(CLI::Range(-1e9, 1e9));
  command.add_option("--end", source.end, "Show until this time [s]")->check(CLI::Range(-1e9, 1e9));
  command.add_option("--persons", source.persons, "Show these persons only (ids)");
}

std::unique_ptr<Place> read_place(const RecordingOptions& options) {
  if (options.scenario.empty()) return nullptr;
  return std::make_unique<Place>(
      read_place(read_any_scenario(options.scenario, {}), options.zone_file));
}

Recording read_recording(const RecordingOptions& options) {
  RecordingCast cast;
  if (!options.scenario.empty()) {
    const Scenario scenario = read_any_scenario(options.scenario, {});
    for (const std::string& file : scenario.additional_files) cast.read(file);
    for (const std::string& file : scenario.route_files) cast.read(file);
  }
  for (const std::string& file : options.types) cast.read(file);
  ShareBar bar("reading");
  Recording recording =
      read_recording(options.source, cast, [&bar](double share) { bar.update(share); });
  bar.finish();
  return recording;
}

}  // namespace pedzone
