#include "app/validate.hpp"

#include <fmt/format.h>

#include <memory>

#include "app/command_line/common_options.hpp"
#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/share_bar.hpp"
#include "app/validation_output.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/xml.hpp"
#include "results/complete_file.hpp"
#include "validation/page.hpp"
#include "validation/tuned_clips.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kWorstCases = 8;

struct ValidateOptions {
  std::string data, json, html;
  std::vector<std::string> models{"heuristic"}, parameters;
  int seeds = 5, resamples = 1000;
};

/// From KEY=VALUE, checked like a <param> of a zone file.
void set_parameter(const std::string& text, Parameters& parameters) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    throw InputError("has no value", {"", 0, "option --param", text, "KEY=VALUE"});
  }
  const std::string key = text.substr(0, equals);
  const ParameterInfo* info = find_parameter(key);
  if (info == nullptr) {
    throw InputError("is no parameter", {"", 0, "option --param", key,
                                         comma_list(parameter_list(), &ParameterInfo::key)});
  }
  double value = 0.0;
  const std::string number = text.substr(equals + 1);
  if (!parse_number(number, value) || value < info->least || value > info->most) {
    throw InputError("is out of range", {"", 0, "option --param " + std::string(info->key), number,
                                         describe({info->least, info->most})});
  }
  parameters.*info->member = value;
}

std::vector<ReplayModel> models_of(const ValidateOptions& options) {
  std::vector<ReplayModel> models;
  for (const std::string& name : options.models) {
    if (name == "plain") continue;  // among the reference rows
    require_models({name});
    ReplayModel model;
    model.name = model.model = name;
    for (const std::string& text : options.parameters) set_parameter(text, model.parameters);
    models.push_back(std::move(model));
  }
  return models;
}

void validate(const ValidateOptions& options) {
  ValidationOptions validation;
  validation.models = models_of(options);
  validation.seeds = options.seeds;
  validation.resamples = options.resamples;
  std::unique_ptr<CompleteFile> json, html;
  std::vector<Clip> clips = read_clips(options.data);
  if (!options.json.empty()) json = std::make_unique<CompleteFile>(options.json, "--json");
  if (!options.html.empty()) html = std::make_unique<CompleteFile>(options.html, "--html");
  ShareBar bar("Replaying");
  const ValidationResult result =
      validate(std::move(clips), validation, [&](double share) { bar.update(share); });
  bar.finish();
  std::vector<DrawnCase> worst;
  if (html && !validation.models.empty()) {
    worst = worst_cases(result, validation.models.back(), kWorstCases);
  }
  if (json) json->write(validation_json(result));
  if (html) html->write(validation_page(result, worst));
  if (json) json->finish();
  if (html) html->finish();
  print_result(validation_table(result));
  if (scored_clips(result.data).empty()) {
    print_warning(
        "in no recording does anybody come within 3 m of a vehicle that moves: nobody is scored. "
        "Coordinates are in m, headings in rad, counter-clockwise from +x.");
  }
}

struct CalibrateOptions {
  std::string data, out;
  CalibrationOptions calibration;
};

void calibrate(CalibrateOptions options) {
  const std::vector<Clip> clips = read_clips(options.data);
  CompleteFile json(options.out + "/calibration.json", "--out");
  CompleteFile header(options.out + "/calibrated.inc", "--out");
  CompleteFile tuned(options.out + "/tuned_clips.inc", "--out");
  CompleteFile zone(options.out + "/calibrated.zone.xml", "--out");
  options.calibration.log = options.out + "/evaluations.csv";
  ShareBar bar("Calibrating");
  const CalibrationResult result =
      calibrate(clips, options.calibration, [&](double share) { bar.update(share); });
  bar.finish();
  json.write(calibration_json(result));
  header.write(calibrated_include(result, options.calibration));
  tuned.write(tuned_include(clips));
  zone.write(calibrated_zone(result));
  json.finish();
  header.finish();
  tuned.finish();
  zone.finish();
  print_result(calibration_table(result));
}

}  // namespace

void add_validate(CLI::App& app, int& code) {
  auto options = std::make_shared<ValidateOptions>();
  CLI::App* command = app.add_subcommand(
      "validate", "Replay recordings of people near vehicles, and score the models");
  command->footer(
      "Examples:\n"
      "  pedzone validate --data recordings/ --html validation.html\n"
      "  pedzone validate --data recordings/ --model heuristic --param discomfort=3\n\n"
      "--data has one CSV file for each clip, or one folder with such files for each site.\n"
      "Columns: t,kind,id,x,y,heading,front,rear,half_width, at 10 Hz; in s, m and rad (headings,\n"
      "counter-clockwise from +x). tools/recordings.py makes the files from the CITR and DUT data\n"
      "sets; src/validation/README.md has more.\n"
      "People follow the recording for 1 s, then a model walks them; vehicles are as recorded.\n"
      "Reference rows: straight to the goal, constant velocity, plain (the paper's form).\n"
      "Exit codes: 0 done, 2 input at fault.");
  command->add_option("--data", options->data, "Folder of clips, or of folders of them")
      ->required()
      ->type_name(kFolder);
  command->add_option("--model", options->models, "Walking models, or plug-ins (*.so)")
      ->check(any_beside(model_names()))
      ->type_name(kModelValue)
      ->default_str("heuristic");
  command
      ->add_option("--param", options->parameters,
                   "Parameter of the models, as <param> of a zone file")
      ->type_name("KEY=VALUE");
  add_seeds(*command, options->seeds, "Replays of each clip, with walking speeds varied by 3 %");
  command
      ->add_option("--resamples", options->resamples,
                   "Samples of the bootstrap over clips, for the 95 % intervals")
      ->check(whole_number_in(10, 100000))
      ->type_name(kNumber)
      ->capture_default_str();
  command->add_option("--json", options->json, "Write all figures with their intervals")
      ->type_name(kFile);
  command->add_option("--html", options->html, "Write a page with tables, distributions, paths")
      ->type_name(kFile);
  command->callback([options, &code] { code = guarded([&] { validate(*options); }); });
}

void add_calibrate(CLI::App& app, int& code) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command = app.add_subcommand(
      "calibrate",
      "Calibrate how people give way to vehicles, from recordings, with cross-validation");
  command->footer(
      "Example:\n  pedzone calibrate --data recordings/ --out calibration/\n\n"
      "Writes calibration.json (parameters and scores of each fold), calibrated.zone.xml (to be\n"
      "used with --zone), calibrated.inc (src/world/calibrated.inc, the defaults),\n"
      "tuned_clips.inc (src/validation/tuned_clips.inc, what they are tuned on) and\n"
      "evaluations.csv: started again with the same folder, it goes on from there.");
  CalibrationOptions& calibration = options->calibration;
  command->add_option("--data", options->data, "Folder of clips, or of folders of them")
      ->required()
      ->type_name(kFolder);
  command->add_option("--out", options->out, "Folder for the results")
      ->required()
      ->type_name(kFolder);
  const auto add = [&](const char* name, int& value, int least, int most, const char* meaning) {
    command->add_option(name, value, meaning)
        ->check(whole_number_in(least, most))
        ->type_name(kNumber)
        ->capture_default_str();
  };
  add_seeds(*command, calibration.seeds, "Replays of each point");
  add("--first", calibration.first, 1, 100000,
      "Points to begin with, over the whole range of the parameters");
  add("--rounds", calibration.rounds, 0, 100,
      "Rounds of search, nearer and nearer to the best points");
  add("--points", calibration.points, 1, 10000, "Points in each round");
  command->callback([options, &code] { code = guarded([&] { calibrate(*options); }); });
}

}  // namespace pedzone
