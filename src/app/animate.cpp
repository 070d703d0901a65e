#include "app/animate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/recording_options.hpp"
#include "core/error.hpp"
#include "results/complete_file.hpp"
#include "view/animation.hpp"

namespace pedzone {
namespace {

struct AnimateOptions {
  RecordingOptions recording;
  std::string name;                             ///< of the run; empty: its file's
  std::string beside, beside_fcd, beside_name;  ///< the second run; empty: none
  std::string out;
  AnimationOptions page;
};

std::string name_of(const std::string& given, const std::string& file) {
  if (!given.empty()) return given;
  std::filesystem::path path = std::filesystem::path(file).filename();
  if (path.extension() == ".gz") path = path.stem();
  return path.stem().string();
}

/// Ids of persons of one run that the other does not have.
std::size_t only_in(const Recording& one, const Recording& other) {
  std::set<std::string_view> ids;
  for (const RecordedPerson& person : other.persons) ids.insert(person.id);
  return static_cast<std::size_t>(std::ranges::count_if(
      one.persons, [&](const RecordedPerson& person) { return !ids.contains(person.id); }));
}

/// Who compares two sides by eye takes them to hold the same people.
void warn_of_different_people(const std::vector<AnimatedRun>& runs) {
  const std::size_t left = only_in(*runs[0].recording, *runs[1].recording);
  const std::size_t right = only_in(*runs[1].recording, *runs[0].recording);
  if (left + right == 0) return;
  print_warning(fmt::format(
      "the two sides hold different people: {} of {} persons are in {} only, {} of {} in {} only. "
      "--fcd adds those whom SUMO walks.",
      left, runs[0].recording->persons.size(), runs[0].name, right,
      runs[1].recording->persons.size(), runs[1].name));
}

void animate(AnimateOptions options) {
  CompleteFile file(options.out, "--out");
  const std::unique_ptr<Place> place = read_place(options.recording);
  const Recording recording = read_recording(options.recording);
  std::vector<AnimatedRun> runs{{name_of(options.name, options.recording.source.file), &recording}};
  Recording beside;
  if (!options.beside.empty()) {
    RecordingOptions second = options.recording;
    second.source.file = options.beside;
    second.source.fcd = options.beside_fcd;
    beside = read_recording(second);
    runs.push_back({name_of(options.beside_name, options.beside), &beside});
    warn_of_different_people(runs);
  }
  if (options.page.title.empty()) {
    options.page.title = options.recording.scenario.empty()
                             ? runs.front().name
                             : name_of("", options.recording.scenario);
  }
  file.write(animation_page(runs, place.get(), options.page));
  file.finish();
  print_result(fmt::format("{}: {:.1f} MB\n", options.out,
                           static_cast<double>(std::filesystem::file_size(options.out)) / 1e6));
}

constexpr const char* kFooter =
    "Examples:\n"
    "  pedzone run town.sumocfg --trajectories t.csv -- --fcd-output fcd.xml\n"
    "  pedzone animate t.csv --fcd fcd.xml --scenario town.sumocfg --out town.html\n"
    "  sumo -c town.sumocfg --fcd-output striping.xml     # the same people, walked by SUMO\n"
    "  pedzone animate t.csv --fcd fcd.xml --name pedzone --beside striping.xml \\\n"
    "                  --beside-name striping --scenario town.sumocfg --out both.html\n\n"
    "The file plays in any browser of 2023 or later and needs nothing else, no network either.\n"
    "Space plays and pauses, the arrow keys step, F shows everything, D is for dark; drag, wheel "
    "or\n"
    "two fingers move the map; a click on somebody shows its numbers. Between the steps that are\n"
    "kept (--rate) everybody moves evenly. What people do beside walking is in --trajectories\n"
    "only; from fcd-output alone, who is slower than 0.1 m/s stands.\n"
    "Exit codes: 0 done, 2 input at fault.";

}  // namespace

void add_animate(CLI::App& app, int& code) {
  CLI::App* command =
      app.add_subcommand("animate", "Make an animation of a run: one HTML file that plays offline");
  command->footer(kFooter);
  const auto options = std::make_shared<AnimateOptions>();
  add_recording_options(*command, options->recording);
  command->add_option("--name", options->name, "What the run is called")
      ->type_name(kNames)
      ->default_str("its file's name");
  auto* beside = command
                     ->add_option("--beside", options->beside,
                                  "A second run of the same scenario, shown beside it")
                     ->type_name(kFile);
  command->add_option("--beside-fcd", options->beside_fcd, "fcd-output of the second run")
      ->type_name(kFile)
      ->needs(beside);
  command->add_option("--beside-name", options->beside_name, "What the second run is called")
      ->type_name(kNames)
      ->needs(beside);
  command->add_option("--title", options->page.title, "Heading of the page")
      ->type_name("TEXT")
      ->default_str("the scenario's");
  command->add_option("--rate", options->page.rate, "At most so many steps a second are kept")
      ->check(number_in(0.01, 100.0))
      ->type_name(kNumber)
      ->capture_default_str();
  command->add_option("--out", options->out, "HTML file to write")->required()->type_name(kFile);
  command->callback([options, &code] { code = guarded([&] { animate(*options); }); });
}

}  // namespace pedzone
