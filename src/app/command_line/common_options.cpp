#include "app/command_line/common_options.hpp"

#include "app/command_line/values.hpp"
#include "core/error.hpp"
#include "model/walking_model.hpp"

namespace pedzone {

void add_scenario(CLI::App& command, std::string& config, std::string& zone_file) {
  command.add_option("scenario", config, "SUMO configuration (.sumocfg)")->required();
  command.add_option("--zone", zone_file, "Zone file (.zone.xml)")->type_name(kFile);
}

CLI::Option* add_threads(CLI::App& command, int& threads) {
  return command.add_option("--threads", threads, "Threads for walking; 0: all cores")
      ->check(whole_number_in(0, 1024))
      ->type_name(kNumber)
      ->capture_default_str();
}

CLI::Option* add_seeds(CLI::App& command, int& seeds, const char* what) {
  return command.add_option("--seeds", seeds, what)
      ->check(whole_number_in(1, 1000))
      ->type_name(kNumber)
      ->capture_default_str();
}

void add_json_flag(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "Print JSON for programs, not text for people");
}

void require_models(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    try {
      check_model(name);
    } catch (const ModelError& error) {
      throw InputError(error.problem, {"", 0, "option --model", name, error.allowed});
    }
  }
}

}  // namespace pedzone
