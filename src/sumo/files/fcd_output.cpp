#include "sumo/files/fcd_output.hpp"

#include <filesystem>

#include "sumo/files/said_options.hpp"

namespace pedzone {
namespace {

const SumoOption kFcd{{"fcd-output"}};
const SumoOption kPrefix{{"output-prefix"}};

}  // namespace

std::optional<std::string> fcd_output_of(const Scenario& scenario) {
  namespace fs = std::filesystem;
  const SaidOptions said(scenario.config, scenario.sumo_options);
  const auto value = said.value(kFcd);
  if (!value || value->empty()) return std::nullopt;
  const fs::path folder =
      said.on_command_line(kFcd) ? fs::path() : fs::path(scenario.config).parent_path();
  const fs::path file = folder / *value;
  // SUMO writes to standard output, and to a socket HOST:PORT, too.
  const bool plain = *value != "-" && *value != "stdout" && *value != "stderr" &&
                     value->find(':') == std::string::npos &&
                     (!fs::exists(file) || fs::is_regular_file(file));
  if (!plain || said.value(kPrefix)) {
    throw said.error(kFcd, "cannot be read after the run, as --animate has to", *value,
                     "no fcd-output (--animate makes its own), or a plain file without "
                     "--output-prefix");
  }
  return file.string();
}

}  // namespace pedzone
