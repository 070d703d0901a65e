#include "sumo/panel_people.hpp"

#include <stdexcept>
#include <string>

#include "sumo/files/people_file.hpp"

namespace pedzone {

PanelPeople::PanelPeople(const SimulationOptions& options, const Network& network,
                         const std::vector<Zone>& zones)
    : scenario_(options.scenario) {
  if (options.panels.empty()) return;
  const std::string text =
      people_file({scenario_, network, zones, options.profiles, options.panels, options.seed});
  file_.reset(std::tmpfile());
  if (!file_ || std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0) {
    throw std::runtime_error("cannot write people to a temporary file");
  }
  add_additional_file(scenario_, "/proc/self/fd/" + std::to_string(fileno(file_.get())));
}

}  // namespace pedzone
