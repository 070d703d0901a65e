#include "app/geojson.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>

#include "app/command_line/common_options.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/recording_options.hpp"
#include "results/conflict_table.hpp"
#include "results/geo_layers.hpp"
#include "sumo/files/geo_reader.hpp"

namespace pedzone {
namespace {

struct GeoJsonOptions {
  RecordingOptions recording;  ///< its file: empty where none is given
  std::string conflicts;       ///< table of conflicts; empty: none
  std::string out;             ///< folder
};

std::vector<Conflict> read_conflicts(const std::string& file) {
  std::vector<Conflict> conflicts;
  conflict_table().visit(
      file, [&](const Conflict& conflict, const CsvRow&) { conflicts.push_back(conflict); });
  return conflicts;
}

/// The files of one folder: all of them are complete, or none is there.
class Layers {
 public:
  Layers(const GeoFrame& frame, std::filesystem::path folder)
      : frame_(frame), folder_(std::move(folder)) {}

  void add(const char* name, const std::function<void(GeoJsonFile&)>& write) {
    const std::string path = (folder_ / (std::string(name) + ".geojson")).string();
    write(*files_.emplace_back(std::make_unique<GeoJsonFile>(path, "--out", frame_)));
    names_.push_back(path);
  }

  void finish() {
    for (const auto& file : files_) file->finish();
    for (const std::string& name : names_) fmt::print("{}\n", name);
  }

 private:
  const GeoFrame& frame_;
  std::filesystem::path folder_;
  std::vector<std::unique_ptr<GeoJsonFile>> files_;
  std::vector<std::string> names_;
};

void write_layers(const GeoJsonOptions& options) {
  const std::unique_ptr<Place> place = read_place(options.recording);
  const GeoFrame frame(read_geo_reference(place->network.file));
  Layers layers(frame, options.out);
  layers.add("zones", [&](GeoJsonFile& file) { write_zones(*place, file); });
  layers.add("walls", [&](GeoJsonFile& file) { write_walls(*place, file); });
  if (!place->paths.empty()) {
    layers.add("waypoints", [&](GeoJsonFile& file) { write_waypoints(*place, file); });
  }
  if (!options.recording.source.file.empty()) {
    const Recording recording = read_recording(options.recording);
    layers.add("paths", [&](GeoJsonFile& file) { write_paths(recording, file); });
    layers.add("density", [&](GeoJsonFile& file) { write_density(recording, file); });
  }
  if (!options.conflicts.empty()) {
    const std::vector<Conflict> conflicts = read_conflicts(options.conflicts);
    layers.add("conflicts", [&](GeoJsonFile& file) { write_conflicts(conflicts, file); });
  }
  layers.finish();
}

constexpr const char* kFooter =
    "Examples:\n"
    "  pedzone geojson town.sumocfg --out gis\n"
    "  pedzone run town.sumocfg --trajectories run.csv --conflict-csv conflicts.csv\n"
    "  pedzone geojson town.sumocfg --recording run.csv --conflicts conflicts.csv --out gis\n\n"
    "Each layer is a file. Drag them into QGIS:\n"
    "  zones      where people can be\n"
    "  walls      the borders of the zones\n"
    "  waypoints  of the zone file's <path> elements, if it has any\n"
    "  paths      a line for each person's way (--recording)\n"
    "  density    people per m², mean over the recording, in cells of 2 m (--recording)\n"
    "  conflicts  the place of each at its most serious moment, with its measures (--conflicts)\n"
    "The network must have a projection, as networks from OpenStreetMap have.\n"
    "Exit codes: 0 done, 2 input at fault.";

}  // namespace

void add_geojson(CLI::App& app, int& code) {
  CLI::App* command = app.add_subcommand(
      "geojson", "Write zones, walls, paths, density and conflicts for QGIS (GeoJSON)");
  command->footer(kFooter);
  const auto options = std::make_shared<GeoJsonOptions>();
  RecordingOptions& recording = options->recording;
  add_scenario(*command, recording.scenario, recording.zone_file);
  command
      ->add_option("--recording", recording.source.file,
                   "SUMO's fcd-output or pedzone's --trajectories (table), gzipped or not")
      ->type_name(kFile);
  add_recording_filter(*command, recording);
  command
      ->add_option("--conflicts", options->conflicts,
                   "Table that `pedzone run` or `pedzone conflicts` wrote with --conflict-csv")
      ->type_name(kFile);
  command->add_option("--out", options->out, "Folder to write into")
      ->type_name(kFolder)
      ->required();
  command->callback([options, &code] { code = guarded([&] { write_layers(*options); }); });
}

}  // namespace pedzone
