#include "sumo/path_references.hpp"

#include "core/xml_stream.hpp"

namespace pedzone {

void require_known_paths(const Scenario& scenario, const std::vector<WaypointPath>& paths) {
  const auto check = [&](const XmlElement& element) {
    if (element.name() != "param" || element.value("key") != kPathKey) return;
    const std::string id(element.value("value").value_or(""));
    // SUMO tells a parameter without a value from none as little as we do.
    if (id.empty() || find_path(paths, id) != nullptr) return;
    throw element.error("is no path of the zone file", "value", id, path_ids(paths));
  };
  for (const auto* files : {&scenario.route_files, &scenario.additional_files}) {
    for (const std::string& file : *files) visit_elements(file, "", check);
  }
}

}  // namespace pedzone
