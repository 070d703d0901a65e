#include "app/validate.hpp"

#include <fmt/format.h>

#include <memory>

#include "app/guarded.hpp"
#include "app/share_bar.hpp"
#include "app/validation_output.hpp"
#include "core/error.hpp"
#include "core/xml.hpp"
#include "results/complete_file.hpp"
#include "validation/page.hpp"

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
  const ParameterInfo* info = find_parameter(text.substr(0, equals));
  if (equals == std::string::npos || info == nullptr) {
    throw InputError("is no parameter",
                     {"", 0, "option --param", text, "KEY=VALUE; `pedzone parameters` lists keys"});
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
    try {
      make_model(name);
    } catch (const ModelError& error) {
      throw InputError(error.problem, {"", 0, "option --model", name, error.allowed});
    }
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
  fmt::print("{}", validation_table(result));
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
  fmt::print("{}", calibration_table(result));
}

}  // namespace

void add_validate(CLI::App& app, int& code) {
  auto options = std::make_shared<ValidateOptions>();
  CLI::App* command =
      app.add_subcommand("validate", "Replay recordings of people around vehicles, and score");
  command->footer(
      "Examples:\n"
      "  pedzone validate --data recordings/ --html validation.html\n"
      "  pedzone validate --data recordings/ --model heuristic --param discomfort=3\n\n"
      "DIR has one CSV a clip, or one folder a site with them: t,kind,id,x,y,heading,front,rear,\n"
      "half_width at 10 Hz. tools/recordings.py makes them from the CITR and DUT data sets.\n"
      "People follow the recording for 1 s, then a model walks them; vehicles are as recorded.\n"
      "Reference rows: straight to the goal, constant velocity, plain (the paper's form).\n"
      "Exit codes: 0 done, 2 input at fault.");
  command->add_option("--data", options->data, "Folder of clips, or of folders of them")
      ->required();
  command->add_option("--model", options->models, "Walking models")->capture_default_str();
  command->add_option("--param", options->parameters, "KEY=VALUE, as <param> of a zone file");
  command->add_option("--seeds", options->seeds, "Replays with 3 % of speed jitter")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--resamples", options->resamples, "Of the bootstrap by clip (95 %)")
      ->check(CLI::Range(10, 100000))
      ->capture_default_str();
  command->add_option("--json", options->json, "Write all figures with their intervals");
  command->add_option("--html", options->html, "Write a page with tables, distributions, paths");
  command->callback([options, &code] { code = guarded([&] { validate(*options); }); });
}

void add_calibrate(CLI::App& app, int& code) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command = app.add_subcommand(
      "calibrate", "Find the parameters of giving way by recordings, with cross-validation");
  command->footer(
      "Example:\n  pedzone calibrate --data recordings/ --out calibration/\n\n"
      "Writes calibration.json (parameters and scores of each fold), calibrated.zone.xml (to be\n"
      "used with --zone), calibrated.inc (src/world/calibrated.inc, the defaults),\n"
      "tuned_clips.inc (src/validation/tuned_clips.inc, what they are tuned on) and\n"
      "evaluations.csv: started again with the same folder, it goes on from there.");
  CalibrationOptions& calibration = options->calibration;
  command->add_option("--data", options->data, "Folder of clips, or of folders of them")
      ->required();
  command->add_option("--out", options->out, "Folder for the results")->required();
  const auto add = [&](const char* name, int& value, int least, int most, const char* meaning) {
    command->add_option(name, value, meaning)
        ->check(CLI::Range(least, most))
        ->capture_default_str();
  };
  add("--seeds", calibration.seeds, 1, 1000, "Replays of each point");
  add("--first", calibration.first, 1, 100000, "Points over the whole box");
  add("--rounds", calibration.rounds, 0, 100, "Rounds about the best");
  add("--points", calibration.points, 1, 10000, "Points in each round");
  command->callback([options, &code] { code = guarded([&] { calibrate(*options); }); });
}

}  // namespace pedzone
