#include "app/plot.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/box_option.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/png.hpp"
#include "app/recording_options.hpp"
#include "results/complete_file.hpp"
#include "view/path_plot.hpp"
#include "view/run_charts.hpp"
#include "view/svg_row.hpp"
#include "view/time_plot.hpp"

namespace pedzone {
namespace {

constexpr int kLeastPixels = 100, kMostPixels = 10000;

struct PlotOptions {
  RecordingOptions recording;
  std::string kind = "time", colour = "auto";
  std::string out, title;
  std::optional<double> every;      ///< [s]
  std::vector<double> at;           ///< [s] of snapshots; empty: none
  std::vector<std::string> beside;  ///< more recordings
  std::vector<double> area;         ///< [m] left, bottom, right, top
  int width = 1600;                 ///< [pixels]
};

bool is_png(const std::string& out) {
  const std::string ending = std::filesystem::path(out).extension().string();
  if (ending == ".png") return true;
  if (ending == ".svg") return false;
  throw InputError(
      "is no kind of picture",
      {.element = "option --out", .value = out, .allowed = "a name that ends with .svg or .png"});
}

std::string title_of(const PlotOptions& options) {
  if (!options.title.empty()) return options.title;
  return std::filesystem::path(options.recording.source.file).filename().string();
}

std::string draw(const PlotOptions& options, const Recording& recording, const Place* place,
                 std::optional<double> at, bool legend) {
  const std::string title = title_of(options);
  const Box area = box_of_sides(options.area, "--area");
  if (options.kind == "time")
    return time_plot(recording, place, {title, area, options.every, at, legend});
  if (options.kind == "speed") return speed_chart(recording, title);
  if (options.kind == "across") return across_chart(recording, title);
  if (options.kind == "clearance") {
    if (recording.vehicles.empty()) {
      throw InputError(
          "has no vehicle to be clear of",
          {options.recording.source.file, 0, "--kind clearance", "",
           "a recording with vehicles in the time shown, or --fcd beside trajectories"});
    }
    return clearance_chart(recording, title);
  }
  PathColour colour = PathColour::kAuto;
  if (options.colour == "person") colour = PathColour::kPerson;
  if (options.colour == "group") colour = PathColour::kGroup;
  if (options.colour == "none") colour = PathColour::kNone;
  return path_plot(recording, place, {title, area, colour});
}

void check_kind(const PlotOptions& options) {
  if (options.at.empty() || options.kind == "time") return;
  throw InputError(
      "has no snapshots",
      {.element = "option --kind", .value = options.kind, .allowed = "time, with --at"});
}

/// A picture to be drawn.
struct Wanted {
  std::size_t recording;
  std::optional<double> at;  ///< [s] of a snapshot
  std::string name;
};

/// Each recording's pictures: one, or its snapshots.
std::vector<Wanted> wanted_pictures(const PlotOptions& options,
                                    const std::vector<std::string>& files) {
  std::vector<Wanted> wanted;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string name = files.size() > 1 ? name_of_file(files[i]) : "";
    if (options.at.empty()) wanted.push_back({i, std::nullopt, name});
    for (const double at : options.at) {
      const std::string moment = fmt::format("{:g} s", at);
      wanted.push_back({i, at, name.empty() ? moment : name + ", " + moment});
    }
  }
  return wanted;
}

void require_in_time(const std::vector<double>& moments, const Recording& recording) {
  for (const double at : moments) {
    if (at >= recording.begin && at <= recording.end) continue;
    throw InputError("is not in the recording",
                     {.element = "option --at",
                      .value = fmt::format("{:g}", at),
                      .allowed = fmt::format("{:g} to {:g} s", recording.begin, recording.end)});
  }
}

void require_in_area(const Box& area, const Recording& recording) {
  if (area.isEmpty()) return;
  for (const RecordedPerson& person : recording.persons) {
    for (const PersonMoment& moment : person.moments) {
      if (area.contains(moment.position)) return;
    }
  }
  throw InputError("shows nobody", {.element = "option --area",
                                    .allowed = "an area in which somebody of the recording is"});
}

/// One picture, or several side by side, or, where they are wide, below each other: then one legend
/// is enough.
std::string draw_all(PlotOptions options) {
  check_kind(options);
  const bool map = options.kind == "time" || options.kind == "path";
  const std::unique_ptr<Place> place = map ? read_place(options.recording) : nullptr;
  std::vector<std::string> files{options.recording.source.file};
  files.insert(files.end(), options.beside.begin(), options.beside.end());
  std::vector<Recording> recordings;
  for (const std::string& file : files) {
    options.recording.source.file = file;
    recordings.push_back(read_recording(options.recording));
    require_in_time(options.at, recordings.back());
    options.recording.source.fcd.clear();  // of the first one alone
  }
  if (map) require_in_area(box_of_sides(options.area, "--area"), recordings.front());
  const std::vector<Wanted> wanted = wanted_pictures(options, files);
  const auto drawn = [&](const Wanted& one, bool legend) {
    options.recording.source.file = files[one.recording];
    return draw(options, recordings[one.recording], place.get(), one.at, legend);
  };
  const std::string last = drawn(wanted.back(), true);
  if (wanted.size() == 1) return last;
  const bool wide = is_wide(last);
  std::vector<NamedPicture> pictures;
  for (const Wanted& one : wanted) {
    const bool is_last = &one == &wanted.back();
    pictures.push_back({one.name, is_last ? last : drawn(one, !wide)});
  }
  return wide ? svg_column(pictures) : svg_row(pictures);
}

void plot(const PlotOptions& options) {
  const bool png = is_png(options.out);
  CompleteFile out(options.out, "--out");
  const std::string svg = draw_all(options);
  out.write(png ? png_from_svg(svg, options.width) : svg);
  out.finish();
}

constexpr const char* kExamples =
    "Examples:\n"
    "  pedzone run town.sumocfg --trajectories run.csv -- --fcd-output run.fcd.xml\n"
    "  pedzone plot run.csv --fcd run.fcd.xml --scenario town.sumocfg --out time.svg\n"
    "  pedzone plot run.csv --scenario town.sumocfg --at 12 16 20 24 --out four.svg\n"
    "  pedzone plot run.csv --scenario town.sumocfg --kind path --out paths.png\n"
    "  pedzone plot run.csv --fcd run.fcd.xml --scenario town.sumocfg --kind clearance \\\n"
    "               --persons p0 p1 --begin 30 --end 60 --out clearance.svg\n"
    "  sumo -c town.sumocfg --fcd-output sumo.fcd.xml.gz          # SUMO's striping, drawn alike\n"
    "  pedzone plot sumo.fcd.xml.gz --scenario town.sumocfg --begin 60 --end 90 --out sumo.png\n\n"
    "Kinds:\n"
    "  time       where persons and vehicles are at even moments, coloured by time; zones green,\n"
    "             waypoints as stars\n"
    "  path       a line for each person\n"
    "  across     each person's way with y stretched, so that small deviations can be seen\n"
    "  speed      speed over time\n"
    "  clearance  room between each person and the nearest moving vehicle over time\n"
    "Up to 12 persons have a line and a name each. Of more people, charts show the median and the\n"
    "range from 5 to 95 %.\n"
    "Maps show where the persons are in the zones, or --area. --persons and --area come after\n"
    "the recording.\n"
    "Exit codes: 0 done, 2 input at fault.";

}  // namespace

void add_plot(CLI::App& app, int& code) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* command = app.add_subcommand(
      "plot", "Draw a run: time-plot, paths, speeds or clearances, as SVG or PNG");
  command->footer(kExamples);
  add_recording_options(*command, options->recording);
  command->add_option("--kind", options->kind, "What to draw")
      ->check(one_of({"time", "path", "across", "speed", "clearance"}))
      ->type_name("KIND")
      ->capture_default_str();
  command
      ->add_option("--beside", options->beside,
                   "More recordings of the same scenario, drawn beside or below the first")
      ->type_name(kFile)
      ->expected(1, 11);
  command->add_option("--out", options->out, "Picture to write: .svg or .png")
      ->required()
      ->type_name(kFile);
  command->add_option("--every", options->every, "Time-plot: time between two moments")
      ->check(number_in(0.01, 1e6))
      ->type_name(kSeconds)
      ->default_str("10 to 20 moments");
  command->add_option("--at", options->at, "Time-plot: snapshots of these moments, side by side")
      ->check(number_in(-kLongestTime, kLongestTime))
      ->expected(1, 12)
      ->type_name(kSeconds);
  add_box_option(*command, "--area", options->area, "Maps: what is shown, in metres of the network")
      ->default_str("where persons are");
  command->add_option("--colour-by", options->colour, "Path plot: what the colour of a line means")
      ->check(one_of({"auto", "person", "group", "none"}))
      ->type_name("COLOUR")
      ->capture_default_str();
  command->add_option("--title", options->title, "Title")
      ->type_name("TEXT")
      ->default_str("the recording's name");
  command->add_option("--width", options->width, "Width of a PNG")
      ->check(whole_number_in(kLeastPixels, kMostPixels))
      ->type_name("PIXELS")
      ->capture_default_str();
  command->callback([options, &code] { code = guarded([&] { plot(*options); }); });
}

}  // namespace pedzone
