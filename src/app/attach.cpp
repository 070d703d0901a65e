#include "app/attach.hpp"

#include "app/command_line/values.hpp"
#include "app/run.hpp"

namespace pedzone {
namespace {

constexpr const char* kSumo = "The running SUMO";
constexpr int kHighestOrder = 1000;  // SUMO's MAX_ORDER

constexpr const char* kFooter =
    "Examples:\n"
    "  sumo-gui -c town.sumocfg --remote-port 8813 --num-clients 2\n"
    "  python3 my_shuttle.py --port 8813                   # order 1: your controller\n"
    "  pedzone attach town.sumocfg --port 8813 --order 2\n\n"
    "SUMO starts when all its clients have connected. In each step it waits for all of them, the\n"
    "lowest --order first. Give pedzone the configuration that SUMO runs: it reads the network\n"
    "and the zones from there. It walks people as `pedzone run` does, to the same bits.\n\n"
    "Set pedzone.external=\"true\" on a vehicle that another client drives, or on its vType. SUMO\n"
    "does not report what a client with a lower --order than pedzone tells it (setSpeed,\n"
    "slowDown): pedzone would overwrite that. The same holds for persons whom such a client "
    "moves.\n"
    "pedzone notices by itself who is moved by moveToXY, and what clients after it do.\n\n"
    "When pedzone ends (its --end, SUMO's, or Ctrl-C), it gives the people back to SUMO, and SUMO\n"
    "goes on for its other clients.\n\n"
    "Exit codes: 0 done, 2 input at fault, 3 SUMO is not there or failed, 128 + signal: "
    "interrupted.";

void add_address(CLI::App& command, TraciAddress& address) {
  command.add_option("--port", address.port, "SUMO's --remote-port")
      ->check(a_port())
      ->type_name(kNumber)
      ->capture_default_str()
      ->group(kSumo);
  command.add_option("--host", address.host, "Machine on which SUMO runs")
      ->type_name("HOST")
      ->capture_default_str()
      ->group(kSumo);
  command
      .add_option("--order", address.order,
                  "Place among SUMO's clients in each step; each client has its own")
      ->check(whole_number_in(1, kHighestOrder))
      ->type_name(kNumber)
      ->capture_default_str()
      ->group(kSumo);
  command.add_option("--patience", address.patience, "How long to wait until SUMO can be reached")
      ->check(number_in(0, kLongestTime))
      ->type_name(kSeconds)
      ->capture_default_str()
      ->group(kSumo);
}

}  // namespace

void add_attach(CLI::App& app, int& code) {
  const auto options = std::make_shared<RunOptions>();
  options->attach.emplace();
  options->attach->order = 2;  // a controller that is under test comes first
  CLI::App* command = app.add_subcommand(
      "attach", "Walk the persons of a SUMO that runs, beside its other TraCI clients");
  command->footer(kFooter);
  add_address(*command, *options->attach);
  add_screenshots(*command, *options)->group(kSumo);
  add_walking_options(*command, *options);
  add_output_options(*command, *options);
  add_conflict_options(*command, options->conflicts);
  command->callback([options, &code] { code = run(*options); });
}

}  // namespace pedzone
