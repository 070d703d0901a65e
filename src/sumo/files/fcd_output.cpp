#include "sumo/files/fcd_output.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include "sumo/files/said_options.hpp"

namespace pedzone {
namespace {

const SumoOption kFcd{{"fcd-output"}};
const SumoOption kPrefix{{"output-prefix"}};
const SumoOption kGeo{{"fcd-output.geo"}};
const SumoOption kAttributes{{"fcd-output.attributes"}};
const SumoOption kEdges{{"fcd-output.filter-edges.input-file"}};

/// What else changes an fcd-output, and SUMO's default.
const std::pair<SumoOption, const char*> kAsUsual[] = {
    {kGeo, "false"},
    {kAttributes, ""},
    {{{"fcd-output.filter-shapes"}}, ""},
    {{{"device.fcd.begin"}}, "-1"},
    {{{"device.fcd.period"}}, "0"},
    {{{"person-device.fcd.period"}}, "0"},
};

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
  const bool plain = *value != "-" && *value != "stdout" && *value != "stderr" && *value != "NUL" &&
                     value->find(':') == std::string::npos &&
                     (!fs::exists(file) || fs::is_regular_file(file));
  if (!plain || said.value(kPrefix)) {
    throw said.error(kFcd, "cannot be read after the run, as --animate has to", *value,
                     "no fcd-output (--animate makes its own), or a plain file without "
                     "--output-prefix");
  }
  for (const SumoOption& option : {kGeo, kAttributes}) {
    const auto how = said.value(option);
    if (!how || how->empty() || *how == "false") continue;
    throw said.error(option, "makes an fcd-output that --animate cannot read", *how,
                     "none, or no fcd-output (--animate makes its own)");
  }
  return file.string();
}

void write_everybody(Scenario& scenario, const std::string& file) {
  const SaidOptions said(scenario.config, scenario.sumo_options);
  if (const auto edges = said.value(kEdges); edges && !edges->empty()) {
    throw said.error(kEdges, "leaves out what --animate has to show", *edges,
                     "no list of edges, or an fcd-output of your own");
  }
  const auto set = [&](const SumoOption& option, const std::string& value) {
    set_option(scenario.sumo_options, option, value);
  };
  set(kFcd, file);
  for (const auto& [option, value] : kAsUsual) {
    if (said.value(option)) set(option, value);
  }
  for (const std::string device : {"device.fcd", "person-device.fcd"}) {
    const SumoOption chance{{device + ".probability"}};
    const bool only_some = said.value(chance) ||
                           said.value({{device + ".explicit", device + ".knownveh"}}) ||
                           said.value({{device + ".deterministic"}});
    if (only_some) set(chance, "1");  // those who are listed and all others
  }
}

}  // namespace pedzone
