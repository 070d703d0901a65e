#include "sumo/files/person_detectors.hpp"

#include "core/xml_stream.hpp"

namespace pedzone {

std::vector<std::string> person_detectors(const Scenario& scenario) {
  std::vector<std::string> ids;
  for (const std::string& file : scenario.additional_files) {
    visit_elements(file, "", [&](const XmlElement& element) {
      const auto whom = element.value("detectPersons");
      if (whom && !whom->empty() && *whom != "none") ids.emplace_back(element.required("id"));
    });
  }
  return ids;
}

}  // namespace pedzone
