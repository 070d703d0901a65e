#include "app/demand.hpp"

#include <optional>

#include "app/command_line/common_options.hpp"
#include "app/command_line/sumo_words.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/panel_options.hpp"
#include "results/complete_file.hpp"
#include "sumo/files/people_file.hpp"

namespace pedzone {
namespace {

struct DemandOptions {
  std::string config;     ///< .sumocfg
  std::string zone_file;  ///< empty: the zone is found by itself
  PanelOptions panel;
  std::optional<std::uint64_t> seed;
  std::string out;                        ///< route file to write
  std::vector<std::string> sumo_options;  ///< what stands after `--`
};

void write(const DemandOptions& options) {
  const Scenario scenario = read_scenario(options.config, options.sumo_options);
  const ZoneFile zone_file = read_zone_file(options.zone_file, options.panel);
  if (zone_file.panels.empty()) {
    throw InputError("asks for nobody",
                     {options.zone_file, 0, "pedzone demand", "",
                      "--pedestrians N, or <pedestrians> elements in the zone file"});
  }
  CompleteFile out(options.out, "--out");
  const Network network = read_scenario_network(scenario);
  const std::vector<Zone> zones = build_zones(network, zone_file.zones);
  out.write(
      people_file({scenario, network, zones, zone_file.profiles, zone_file.panels, options.seed}));
  out.finish();
}

int demand(const DemandOptions& options) {
  return guarded([&] { write(options); });
}

constexpr const char* kFooter =
    "Examples:\n"
    "  pedzone demand town.sumocfg --pedestrians 200 --seed 7 --out people.rou.xml\n"
    "  sumo -c town.sumocfg --additional-files people.rou.xml    # walked by SUMO's striping\n\n"
    "The same scenario, zone file, options and seed give the same people as in `pedzone run`, to\n"
    "the bit. On SUMO's command line, --additional-files replaces the additional files of the\n"
    "configuration: name those, too, if they are needed. Profiles: `pedzone profiles`.\n"
    "Exit codes: 0 done, 2 input at fault.";

}  // namespace

void add_demand(CLI::App& app, int& code) {
  const auto options = std::make_shared<DemandOptions>();
  CLI::App* command = app.add_subcommand(
      "demand", "Write the people that `pedzone run` would make as a SUMO route file");
  command->footer(kFooter);
  add_scenario(*command, options->config, options->zone_file);
  command->add_option("--seed", options->seed, "Seed")
      ->check(a_seed())
      ->type_name(kNumber)
      ->default_str("the scenario's, else SUMO's");
  command->add_option("--out", options->out, "Route file to write")->required()->type_name(kFile);
  add_panel_options(*command, options->panel);
  add_sumo_words(*command, options->sumo_options);
  set_callback(*command, options, demand, code);
}

}  // namespace pedzone
