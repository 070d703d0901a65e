#include "sumo/files/path_vehicles.hpp"

#include <algorithm>

#include "core/xml_stream.hpp"

namespace pedzone {
namespace {

/// Whether "flow.12" is of the flow.
bool is_of_flow(std::string_view vehicle, std::string_view flow) {
  if (!vehicle.starts_with(flow) || vehicle.size() < flow.size() + 2) return false;
  const std::string_view number = vehicle.substr(flow.size() + 1);
  return vehicle[flow.size()] == '.' &&
         number.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Whether the element makes the vehicle.
bool makes(const XmlElement& element, std::string_view vehicle) {
  const auto id = element.value("id");
  if (!id) return false;
  if (element.name() == "flow") return is_of_flow(vehicle, *id);
  return (element.name() == "vehicle" || element.name() == "trip") && *id == vehicle;
}

}  // namespace

void require_vehicles(const Scenario& scenario, const std::vector<VehiclePath>& paths) {
  if (paths.empty()) return;
  std::vector<bool> known(paths.size(), false);
  for (const auto* files : {&scenario.route_files, &scenario.additional_files}) {
    for (const std::string& file : *files) {
      visit_elements(file, "", [&](const XmlElement& element) {
        for (std::size_t k = 0; k < paths.size(); ++k) {
          if (makes(element, paths[k].vehicle())) known[k] = true;
        }
      });
    }
  }
  const auto unknown = std::ranges::find(known, false);
  if (unknown == known.end()) return;
  throw paths[static_cast<std::size_t>(unknown - known.begin())].error(
      "is no vehicle of the scenario", "ids of vehicles in its route and additional files");
}

}  // namespace pedzone
