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
#include "app/video/video.hpp"
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
  VideoOptions video;
  AnimationOptions page;
};

std::string name_of(const std::string& given, const std::string& file) {
  return given.empty() ? name_of_file(file) : given;
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

/// Throws InputError where nothing is asked for, or what cannot be made.
void check_outputs(const AnimateOptions& options) {
  if (!options.video.file.empty()) return require_video_programs(options.video);
  if (options.out.empty()) {
    throw InputError("is missing", {.element = "option --out", .allowed = "--out or --video"});
  }
}

void write_page(const std::string& out, const std::string& page) {
  CompleteFile file(out, "--out");
  file.write(page);
  file.finish();
  print_result(fmt::format("{}: {:.1f} MB\n", out,
                           static_cast<double>(std::filesystem::file_size(out)) / 1e6));
}

/// Its exit code.
int animate(AnimateOptions options) {
  check_outputs(options);
  // Told before the recording is read: it may be long.
  if (!options.out.empty()) CompleteFile(options.out, "--out");
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
  const std::string page = animation_page(runs, place.get(), options.page);
  if (!options.out.empty()) write_page(options.out, page);
  return options.video.file.empty() ? 0 : make_video(page, options.video);
}

void add_video_options(CLI::App& command, VideoOptions& options) {
  const char* group = "A film";
  auto* video = command
                    .add_option("--video", options.file,
                                "Film to write: .mp4, .webm or .gif. ffmpeg and Chromium make it")
                    ->type_name(kFile)
                    ->group(group);
  command
      .add_option(
          "--video-speed", options.speed,
          "Speed of the film: simulated seconds per second of film. --begin and --end choose the "
          "part")
      ->check(number_in(0.01, 1000.0))
      ->type_name(kNumber)
      ->capture_default_str()
      ->needs(video)
      ->group(group);
  command.add_option("--video-fps", options.rate, "Frames a second")
      ->check(number_in(1.0, 120.0))
      ->type_name(kNumber)
      ->capture_default_str()
      ->needs(video)
      ->group(group);
  command.add_option("--video-width", options.width, "Width of the film; its height is 9/16 of it")
      ->check(whole_number_in(320, 3840))
      ->type_name("PIXELS")
      ->capture_default_str()
      ->needs(video)
      ->group(group);
}

constexpr const char* kFooter =
    "Examples:\n"
    "  pedzone run town.sumocfg --animate town.html       # in one step\n"
    "  pedzone run town.sumocfg --trajectories t.csv -- --fcd-output fcd.xml\n"
    "  pedzone animate t.csv --fcd fcd.xml --scenario town.sumocfg --out town.html\n"
    "  sumo -c town.sumocfg --fcd-output striping.xml     # the same people, walked by SUMO\n"
    "  pedzone animate t.csv --fcd fcd.xml --name pedzone --beside striping.xml \\\n"
    "                  --beside-name striping --scenario town.sumocfg --out both.html\n"
    "  pedzone animate t.csv --fcd fcd.xml --scenario town.sumocfg --begin 60 --end 180 \\\n"
    "                  --video town.mp4 --video-speed 4      # two minutes in half a one\n\n"
    "The file plays in any browser of 2023 or later and needs nothing else, no network either.\n"
    "Space: play or pause. Arrow keys: one step. F: show everything. D: dark. Drag, wheel or two\n"
    "fingers: move the map. Click on a person or vehicle: its numbers. Between the steps that are\n"
    "kept (--rate) everybody moves evenly. Only --trajectories know what people do beside\n"
    "walking; with fcd-output alone, who is slower than 0.1 m/s is shown as standing.\n"
    "Exit codes: 0 done, 2 input at fault, 128 + signal: interrupted.";

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
  command
      ->add_option("--rate", options->page.rate, "Keep at most so many steps per simulated second")
      ->check(number_in(0.01, 100.0))
      ->type_name(kNumber)
      ->capture_default_str();
  command->add_option("--out", options->out, "HTML file to write")->type_name(kFile);
  add_video_options(*command, options->video);
  command->callback([options, &code] { code = guarded_code([&] { return animate(*options); }); });
}

}  // namespace pedzone
