#include "app/recording_options.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/share_bar.hpp"
#include "core/error.hpp"
#include "sumo/files/place_reader.hpp"
#include "sumo/files/type_files.hpp"

namespace pedzone {

std::string name_of_file(const std::string& file) {
  std::filesystem::path path = std::filesystem::path(file).filename();
  if (path.extension() == ".gz") path = path.stem();
  path = path.stem();
  if (path.extension() == ".fcd") path = path.stem();
  return path.string();
}

void add_recording_options(CLI::App& command, RecordingOptions& options) {
  RecordingSource& source = options.source;
  command
      .add_option("recording", source.file,
                  "SUMO's fcd-output or pedzone's --trajectories, gzipped or not")
      ->required();
  command
      .add_option("--fcd", source.fcd,
                  "fcd-output of the same run: vehicles, and people whom SUMO walks")
      ->type_name(kFile);
  auto* scenario =
      command
          .add_option("--scenario", options.scenario,
                      "SUMO configuration: network, polygons, waypoints, sizes, profiles, groups")
          ->type_name(kFile);
  command.add_option("--zone", options.zone_file, "Zone file (.zone.xml)")
      ->type_name(kFile)
      ->needs(scenario);
  add_recording_filter(command, options);
}

void add_recording_filter(CLI::App& command, RecordingOptions& options) {
  RecordingSource& source = options.source;
  command
      .add_option("--vtypes", options.types,
                  "More route or additional files that tell sizes, profiles and groups")
      ->type_name(kFile)
      ->allow_extra_args(false);
  const auto add_time = [&](const char* name, auto& time, const char* what) {
    command.add_option(name, time, what)
        ->check(number_in(-kLongestTime, kLongestTime))
        ->type_name(kSeconds);
  };
  add_time("--begin", source.begin, "Show from this time on");
  add_time("--end", source.end, "Show until this time");
  command.add_option("--persons", source.persons, "Show these persons only (ids)")->type_name("ID");
}

std::unique_ptr<Place> read_place(const RecordingOptions& options) {
  if (options.scenario.empty()) return nullptr;
  return std::make_unique<Place>(
      read_place(read_any_scenario(options.scenario, options.sumo_options), options.zone_file));
}

void warn_of_guessed_sizes(const BodySizes& sizes) {
  const std::string guessed = sizes.guessed();
  if (guessed.empty()) return;
  print_warning(fmt::format(
      "people of the vTypeDistribution '{}' are taken to have the size of its first member, since "
      "fcd-output does not name their types: tripinfo-output of the run does (--vtypes FILE).",
      guessed));
}

Recording read_recording(const RecordingOptions& options) {
  if (options.source.begin > options.source.end) {
    throw InputError("is later than --end",
                     {.element = "option --begin",
                      .value = fmt::format("{:g}", options.source.begin),
                      .allowed = fmt::format("at most {:g}", options.source.end)});
  }
  const auto cast =
      read_type_files<RecordingCast>(options.scenario, options.sumo_options, options.types);
  warn_of_guessed_sizes(cast.sizes);
  ShareBar bar("reading");
  Recording recording =
      read_recording(options.source, cast, [&bar](double share) { bar.update(share); });
  bar.finish();
  return recording;
}

}  // namespace pedzone
