#include "app/command_line/command_line.hpp"

#include <CLI/CLI.hpp>

#include "app/animate.hpp"
#include "app/attach.hpp"
#include "app/command_line/help.hpp"
#include "app/command_line/look_up.hpp"
#include "app/command_line/mistakes.hpp"
#include "app/command_line/option_text.hpp"
#include "app/command_line/terminal.hpp"
#include "app/conflicts.hpp"
#include "app/demand.hpp"
#include "app/geojson.hpp"
#include "app/guarded.hpp"
#include "app/inspect.hpp"
#include "app/maps.hpp"
#include "app/plot.hpp"
#include "app/run.hpp"
#include "app/study.hpp"
#include "app/validate.hpp"
#include "app/verify.hpp"

namespace pedzone {
namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  pedzone run town.sumocfg --model orca\n"
    "  pedzone help study run                  # the same as pedzone study run --help\n\n"
    "Exit codes: 0 done; 1 `verify`: a test failed; 2 the input is at fault; 3 SUMO failed;\n"
    "4 `study`: some runs failed; 128 + signal: interrupted.\n"
    "NO_COLOR=1 in the environment: no colours. Elsewhere than on a terminal there are none.";

using Add = void (*)(CLI::App&, int&);
struct CommandGroup {
  const char* name;
  std::vector<Add> commands;
};

/// In the order of the help.
const std::vector<CommandGroup>& command_groups() {
  static const std::vector<CommandGroup> groups = {
      {"To walk people", {add_run, add_attach, add_inspect, add_demand}},
      {"To look at what they did", {add_conflicts, add_animate, add_plot, add_maps, add_geojson}},
      {"To compare and to judge", {add_study, add_validate, add_calibrate, add_verify}},
      {kLookUpGroup, {add_parameters, add_profiles, add_help, add_completion, add_man}}};
  return groups;
}

void add_commands(CLI::App& app, int& code) {
  for (const CommandGroup& group : command_groups()) {
    for (const Add add : group.commands) {
      add(app, code);
      app.get_subcommands({}).back()->group(group.name);
    }
  }
}

/// What all commands have in common.
void finish_commands(CLI::App& app) {
  refuse_odd_values(app);
  for (CLI::App* command : app.get_subcommands({})) {
    const bool works = command->get_subcommands({}).empty() && command->get_group() != kLookUpGroup;
    if (works) add_quiet_flag(*command);
    finish_commands(*command);
  }
}

}  // namespace

int command_line(int argc, char** argv) {
  CLI::App app{"Walks the pedestrians of a SUMO simulation through shared space", "pedzone"};
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("-V,--version", PEDZONE_VERSION, "Print the version");
  app.set_help_flag("-h,--help", "Print this help");
  app.footer(kFooter);
  app.require_subcommand(0, 1);
  int code = 0;
  add_commands(app, code);
  finish_commands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return guarded([&] { print_text(help_of(chosen_command(app))); });
  } catch (const CLI::CallForVersion& version) {
    return guarded([&] { print_text(version.what() + std::string("\n")); });
  } catch (const CLI::ParseError& error) {
    return guarded([&] { throw mistake(app, error); });
  }
  const CLI::App& chosen = chosen_command(app);
  if (shown_commands(chosen).empty()) return code;
  return guarded([&] { print_text(help_of(chosen)); });  // `pedzone` or `pedzone study` alone
}

}  // namespace pedzone
