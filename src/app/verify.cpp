#include "app/verify.hpp"

#include <fmt/format.h>

#include <memory>

#include "app/guarded.hpp"
#include "app/share_bar.hpp"
#include "app/thread_limit.hpp"
#include "app/verify_output.hpp"
#include "core/error.hpp"
#include "results/complete_file.hpp"
#include "verify/page.hpp"
#include "world/model_names.hpp"

namespace pedzone {
namespace {

constexpr int kExitFailed = 1;

struct VerifyCommand {
  std::string json, html;
  std::vector<std::string> models, only;
  int seeds = 3, threads = 0;
  bool list = false;
};

std::vector<std::string> models_of(const VerifyCommand& command) {
  std::vector<std::string> models = command.models;
  if (models.empty()) models.assign(std::begin(kModelNames), std::end(kModelNames));
  for (const std::string& name : models) {
    try {
      make_model(name);
    } catch (const ModelError& error) {
      throw InputError(error.problem, {"", 0, "option --model", name, error.allowed});
    }
  }
  return models;
}

/// The command line that gives the same figures.
std::string repeat_command(const VerifyCommand& command) {
  std::string text = fmt::format("pedzone verify --seeds {}", command.seeds);
  if (!command.models.empty()) text += fmt::format(" --model {}", fmt::join(command.models, " "));
  if (!command.only.empty()) text += fmt::format(" --only {}", fmt::join(command.only, " "));
  return text + " --html verify.html";
}

/// Whether the first of the models passes all tests.
bool verify_all(const VerifyCommand& command) {
  verify::VerifyOptions options;
  options.models = models_of(command);
  options.only = command.only;
  options.seeds = command.seeds;
  std::unique_ptr<CompleteFile> json, html;
  if (!command.json.empty()) json = std::make_unique<CompleteFile>(command.json, "--json");
  if (!command.html.empty()) html = std::make_unique<CompleteFile>(command.html, "--html");
  const ThreadLimit limit(command.threads);
  ShareBar bar("Walking the tests");
  const verify::Verification verification =
      verify::verify(options, [&](double share) { bar.update(share); });
  bar.finish();
  if (json) json->write(verification_json(verification));
  if (html) html->write(verify::verification_page(verification, repeat_command(command)));
  if (json) json->finish();
  if (html) html->finish();
  fmt::print("{}", verification_table(verification));
  return verification.passes(0);
}

}  // namespace

void add_verify(CLI::App& app, int& code) {
  auto options = std::make_shared<VerifyCommand>();
  CLI::App* command =
      app.add_subcommand("verify", "Walk the standard tests of pedestrian models, and judge");
  command->footer(
      "Examples:\n"
      "  pedzone verify --html verify.html                      # all tests, all models\n"
      "  pedzone verify --model heuristic --only doors diagram-one-way\n"
      "  pedzone verify --list                                  # the ids of the tests\n\n"
      "RiMEA, ISO 20414, NIST, IMO 1533, Jülich and Moussaïd, as far as they concern walking on\n"
      "one level. Limits are from the literature; the page says what was chosen on them. SUMO is\n"
      "not needed.\n"
      "Exit codes: 0 the first model passes all, 1 it fails a test, 2 input at fault.");
  command->add_option("--model", options->models,
                      "Walking models [default: all]: " + allowed_models());
  command->add_option("--only", options->only, "Ids of tests [default: all]");
  command->add_option("--seeds", options->seeds, "Runs of each test that differ by chance")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--threads", options->threads, "Threads; 0: all cores")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->add_option("--html", options->html,
                      "Write a page with set-ups, limits, figures, charts and density maps");
  command->add_option("--json", options->json, "Write all figures, limits and curves");
  command->add_flag("--list", options->list, "Print the tests and end");
  command->callback([options, &code] {
    if (options->list) {
      fmt::print("{}", test_list_text());
      return;
    }
    bool passed = true;
    code = guarded([&] { passed = verify_all(*options); });
    if (code == 0 && !passed) code = kExitFailed;
  });
}

}  // namespace pedzone
