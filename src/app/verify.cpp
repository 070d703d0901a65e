#include "app/verify.hpp"

#include <fmt/format.h>

#include <memory>

#include "app/command_line/common_options.hpp"
#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/share_bar.hpp"
#include "app/thread_limit.hpp"
#include "app/verify_output.hpp"
#include "core/error.hpp"
#include "results/complete_file.hpp"
#include "verify/page.hpp"

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
  if (models.empty()) models = model_names();
  require_models(models);
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
  print_result(verification_table(verification));
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
      "The tests of RiMEA, ISO 20414, NIST, IMO 1533, Jülich and Moussaïd that are about walking\n"
      "on one level. The page names the source of each limit, and says which limits are assumed.\n"
      "SUMO is not needed.\n"
      "Exit codes: 0 the first model passes all, 1 it fails a test, 2 input at fault.");
  command->add_option("--model", options->models, "Walking models, or plug-ins (*.so)")
      ->check(any_beside(model_names()))
      ->type_name(kModelValue)
      ->default_str("all");
  command->add_option("--only", options->only, "Ids of tests; --list prints them")
      ->type_name("TEST")
      ->default_str("all");
  add_seeds(*command, options->seeds, "Runs of each test that differ by chance");
  add_threads(*command, options->threads);
  command
      ->add_option("--html", options->html,
                   "Write a page with set-ups, limits, figures, charts and density maps")
      ->type_name(kFile);
  command->add_option("--json", options->json, "Write all figures, limits and curves")
      ->type_name(kFile);
  command->add_flag("--list", options->list, "Print the tests and end");
  command->callback([options, &code] {
    if (options->list) {
      code = guarded([] { print_text(test_list_text()); });
      return;
    }
    code = guarded_code([&] { return verify_all(*options) ? 0 : kExitFailed; });
  });
}

}  // namespace pedzone
