#include "app/maps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/box_option.hpp"
#include "app/command_line/common_options.hpp"
#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/json_text.hpp"
#include "app/measurement_area.hpp"
#include "app/recorded_conflicts.hpp"
#include "app/recording_options.hpp"
#include "core/error.hpp"
#include "core/statistics.hpp"
#include "results/complete_file.hpp"
#include "results/density_grid.hpp"
#include "study/measure/conflict_measures.hpp"
#include "view/maps_page.hpp"
#include "view/run_map.hpp"

namespace pedzone {
namespace {

struct MapsOptions {
  RecordingOptions recording;
  std::vector<double> area, measured;  ///< [m] left, bottom, right, top; empty: not given
  std::string out, title;
  bool json = false;
};

/// What is told of a run, beside its maps.
struct MapNumbers {
  std::size_t persons = 0;
  RunGrids grids{kDensityCell};
  std::vector<double> stays;   ///< [s] of each person in the box, from its first to its last moment
  std::vector<double> speeds;  ///< [m/s] mean of each person there
  std::optional<std::vector<Conflict>> conflicts;
  std::vector<AreaMoment> measured;
};

Severity severity_of(const Conflict& conflict) {
  if (conflict.contact) return Severity::kContact;
  const bool serious = (conflict.ttc && conflict.ttc->value < study::kSeriousTtc) ||
                       (conflict.pet && conflict.pet->value < study::kSeriousPet);
  return serious ? Severity::kSerious : Severity::kSlight;
}

/// How long everybody is in the box, and how fast there.
void add_stays(const Recording& recording, const Box& box, MapNumbers& numbers) {
  for (const RecordedPerson& person : recording.persons) {
    double first = 0.0, last = 0.0, sum = 0.0;
    std::size_t count = 0;
    for (const PersonMoment& moment : person.moments) {
      if (!box.contains(moment.position)) continue;
      last = recording.times[moment.step];
      if (count++ == 0) first = last;
      sum += moment.speed;
    }
    if (count == 0) continue;
    ++numbers.persons;
    numbers.stays.push_back(last - first);
    numbers.speeds.push_back(sum / static_cast<double>(count));
  }
}

std::string percentiles_text(const std::vector<double>& sample, int digits, const char* unit) {
  return fmt::format("{:.{}f} / {:.{}f} / {:.{}f} {}", quantile(sample, 0.5), digits,
                     quantile(sample, 0.85), digits, quantile(sample, 0.95), digits, unit);
}

std::size_t count_of(const MapNumbers& numbers, Severity severity) {
  return static_cast<std::size_t>(std::ranges::count_if(
      *numbers.conflicts, [&](const Conflict& one) { return severity_of(one) == severity; }));
}

std::vector<std::pair<std::string, std::string>> table_of(const MapNumbers& numbers) {
  const RunGrids& grids = numbers.grids;
  std::vector<std::pair<std::string, std::string>> rows{
      {"Time", fmt::format("{:g} to {:g} s", grids.begin, grids.end)},
      {"Persons", fmt::format("{}", numbers.persons)},
      {"Mean density where people were", fmt::format("{:.3f} persons/m²", grids.mean_where_people)},
      {"Peak density: the highest mean of a minute in a cell",
       fmt::format("{:.2f} persons/m² (level {}) at ({:.0f}, {:.0f}), from {:g} s on", grids.most,
                   kServiceLevels[service_level(grids.most)].name, grids.most_at.x(),
                   grids.most_at.y(), grids.most_begin)},
      {"Peak minute", fmt::format("{:g} to {:g} s", grids.minute_begin, grids.minute_end)}};
  std::string levels;
  for (std::size_t i = 0; i < grids.area.size(); ++i) {
    levels +=
        fmt::format("{}{} {:.0f} m²", i == 0 ? "" : ", ", kServiceLevels[i].name, grids.area[i]);
  }
  rows.emplace_back("Area at each level of service then", levels);
  rows.emplace_back("Time in the picture, median / 85 % / 95 %",
                    percentiles_text(numbers.stays, 1, "s"));
  rows.emplace_back("Mean speed of a person, median / 85 % / 95 %",
                    percentiles_text(numbers.speeds, 2, "m/s"));
  if (numbers.conflicts) {
    rows.emplace_back(
        "Conflicts with moving vehicles",
        fmt::format("{}: {} slight, {} serious, {} contacts", numbers.conflicts->size(),
                    count_of(numbers, Severity::kSlight), count_of(numbers, Severity::kSerious),
                    count_of(numbers, Severity::kContact)));
  }
  return rows;
}

nlohmann::ordered_json percentiles_json(const std::vector<double>& sample) {
  return {{"median", quantile(sample, 0.5)},
          {"p85", quantile(sample, 0.85)},
          {"p95", quantile(sample, 0.95)}};
}

std::string json_of(const MapNumbers& numbers) {
  const RunGrids& grids = numbers.grids;
  nlohmann::ordered_json json{
      {"version", kJsonVersion},
      {"begin_s", grids.begin},
      {"end_s", grids.end},
      {"persons", numbers.persons},
      {"cell_m", grids.mean.size},
      {"mean_density_per_m2", grids.mean_where_people},
      {"peak",
       {{"density_per_m2", grids.most},
        {"level_of_service", kServiceLevels[service_level(grids.most)].name},
        {"x_m", grids.most_at.x()},
        {"y_m", grids.most_at.y()},
        {"begin_s", grids.most_begin}}},
      {"peak_minute", {{"begin_s", grids.minute_begin}, {"end_s", grids.minute_end}}},
      {"time_in_picture_s", percentiles_json(numbers.stays)},
      {"speed_mps", percentiles_json(numbers.speeds)}};
  for (std::size_t i = 0; i < grids.area.size(); ++i) {
    json["peak_minute"]["area_m2"][std::string(kServiceLevels[i].name)] = grids.area[i];
  }
  if (numbers.conflicts) {
    json["conflicts"] = {{"slight", count_of(numbers, Severity::kSlight)},
                         {"serious", count_of(numbers, Severity::kSerious)},
                         {"contacts", count_of(numbers, Severity::kContact)}};
  }
  for (const AreaMoment& moment : numbers.measured) {
    json["fundamental_diagram"].push_back({{"time_s", moment.time},
                                           {"density_per_m2", moment.density},
                                           {"speed_mps", moment.speed},
                                           {"flow_per_ms", moment.flow()}});
  }
  return json_text(json);
}

void add_conflicts_to(MapsPage& page, const MapNumbers& numbers) {
  page.conflicts_known = numbers.conflicts.has_value();
  if (!numbers.conflicts) return;
  for (const Conflict& one : *numbers.conflicts) {
    const Extreme moment = study::moment_of(one);
    page.conflicts.push_back(
        {moment.position, severity_of(one),
         fmt::format("{} and {} at {:.1f} s", one.person, one.vehicle, moment.time)});
  }
}

std::string page_of(const MapsOptions& options, const Recording& recording, const Place* place,
                    const Box& box, const MapNumbers& numbers) {
  MapsPage page;
  page.title = options.title.empty() ? name_of_file(options.recording.source.file) : options.title;
  page.question = fmt::format("{} persons, {:g} to {:g} s", numbers.persons, numbers.grids.begin,
                              numbers.grids.end);
  page.numbers = table_of(numbers);
  page.note =
      "Of everybody in the picture, also of those whom SUMO walks where --fcd has them. A "
      "minute is one of the run's, counted from its begin; the last one ends with it.";
  page.recording = &recording;
  page.place = place;
  page.box = box;
  // What the picture can show: its cells are larger in a large place, the numbers' are not.
  RunGrids shown = numbers.grids;
  if (const double cell = cell_for(box, kDensityCell); cell > kDensityCell) {
    shown = run_grids(recording, box, cell);
    shown.minute = highest_of(numbers.grids.minute, cell);
  }
  page.grids = &shown;
  if (!options.measured.empty()) page.area = box_of_sides(options.measured, "--measure-area");
  for (const AreaMoment& moment : numbers.measured) {
    page.diagram.push_back({moment.density, moment.speed});
  }
  add_conflicts_to(page, numbers);
  return maps_page(page);
}

void make_maps(const MapsOptions& options) {
  if (options.out.empty() && !options.json) {
    throw InputError("is missing",
                     {.element = "option --out or --json", .allowed = "one of them or both"});
  }
  const Box area = box_of_sides(options.area, "--area");
  const Box measured = box_of_sides(options.measured, "--measure-area");
  std::unique_ptr<CompleteFile> out;
  if (!options.out.empty()) out = std::make_unique<CompleteFile>(options.out, "--out");
  const std::unique_ptr<Place> place = read_place(options.recording);
  const Recording recording = read_recording(options.recording);
  const Box box = shown_box(recording, place.get(), area);
  MapNumbers numbers;
  add_stays(recording, box, numbers);
  if (numbers.persons == 0) {
    throw InputError("shows nobody", {.element = "option --area",
                                      .allowed = "an area in which somebody of the recording is"});
  }
  numbers.grids = run_grids(recording, box, kDensityCell);
  numbers.conflicts = recorded_conflicts(options.recording);
  if (numbers.conflicts) {
    std::erase_if(*numbers.conflicts, [&](const Conflict& one) {
      return !box.contains(study::moment_of(one).position);
    });
  }
  if (!measured.isEmpty()) {
    numbers.measured = measure_area(recording, place.get(), measured);
    if (numbers.measured.empty()) {
      throw InputError("has nobody in it", {.element = "option --measure-area",
                                            .allowed = "an area in which somebody walks"});
    }
  }
  if (out) {
    out->write(page_of(options, recording, place.get(), box, numbers));
    out->finish();
  }
  if (options.json) print_text(json_of(numbers));
}

constexpr const char* kFooter =
    "Examples:\n"
    "  pedzone run town.sumocfg --trajectories t.csv -- --fcd-output fcd.xml\n"
    "  pedzone maps t.csv --fcd fcd.xml --scenario town.sumocfg --out maps.html\n"
    "  pedzone maps t.csv --scenario town.sumocfg --measure-area 20 5 26 9 --json > "
    "numbers.json\n\n"
    "The page shows mean density, Fruin's level of service in the peak minute, speeds, paths and,\n"
    "with fcd-output, conflicts by severity: contact; serious with TTC below 1.5 s or PET below\n"
    "1 s; slight. --measure-area adds the fundamental diagram of a rectangle.\n"
    "Exit codes: 0 done, 2 input at fault.";

}  // namespace

void add_maps(CLI::App& app, int& code) {
  const auto options = std::make_shared<MapsOptions>();
  CLI::App* command = app.add_subcommand(
      "maps", "Map a run: density, level of service, speeds, paths, conflicts; their numbers");
  command->footer(kFooter);
  add_recording_options(*command, options->recording);
  command->add_option("--out", options->out, "HTML file to write")->type_name(kFile);
  command->add_option("--title", options->title, "Heading of the page")
      ->type_name("TEXT")
      ->default_str("the recording's name");
  add_box_option(*command, "--area", options->area, "What is shown, in metres of the network")
      ->default_str("where persons are");
  add_box_option(*command, "--measure-area", options->measured,
                 "A rectangle whose fundamental diagram is measured by Voronoi cells");
  add_json_flag(*command, options->json);
  command->callback([options, &code] { code = guarded([&] { make_maps(*options); }); });
}

}  // namespace pedzone
