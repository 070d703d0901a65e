#include "demand/route_file.hpp"

#include <fmt/format.h>

#include "core/text.hpp"

namespace pedzone {
namespace {

constexpr double kStay = 86400.0;  // [s] a day: SUMO has no stop without an end

/// As in an XML comment, which must not have two dashes in a row nor end with one.
std::string comment_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '-' && !safe.empty() && safe.back() == '-') safe += ' ';
    safe += c;
  }
  return safe;
}

std::string parameter(const char* key, const std::string& value) {
  return fmt::format("        <param key=\"{}\" value=\"{}\"/>\n", key, xml_value(value));
}

std::string type_of(const PlannedPerson& person, double mean_share) {
  const Profile& profile = *person.profile;
  return fmt::format(
             "    <vType id=\"{}\" vClass=\"pedestrian\" maxSpeed=\"{}\" speedFactor=\"1\" "
             "speedDev=\"0\" length=\"{}\" width=\"{}\">\n",
             xml_value(person.id), person.speed / mean_share, profile.length, profile.width) +
         parameter("pedzone.profile", profile.id) + "    </vType>\n";
}

std::string plan_of(const PlannedPerson& person, const Network& network) {
  const std::string id = xml_value(person.id);
  const std::string from = xml_value(network.edges[person.from.edge].id);
  const std::string to = xml_value(network.edges[person.to.edge].id);
  std::string text =
      fmt::format("    <person id=\"{0}\" type=\"{0}\" depart=\"{1:.2f}\" departPos=\"{2:.2f}\">\n",
                  id, person.depart, person.from.position);
  if (!person.group.empty()) text += parameter("pedzone.group", person.group);
  if (person.activity != Activity::kNone) {
    const ActivityInfo& info = info_of(person.activity);
    text += parameter("pedzone.activities", fmt::format("{}={}", info.id, info.rate));
  }
  if (!person.panel->path.empty()) text += parameter("pedzone.path", person.panel->path);
  text += fmt::format(
      "        <walk from=\"{}\" to=\"{}\" arrivalPos=\"{:.2f}\" departPosLat=\"{:.2f}\"/>\n", from,
      to, person.to.position, person.from.lateral);
  if (person.panel->stay) {
    text += fmt::format("        <stop duration=\"{}\" actType=\"staying\"/>\n", kStay);
  }
  return text + "    </person>\n";
}

}  // namespace

std::string route_file(const std::vector<PlannedPerson>& people, const Network& network,
                       const std::string& comment, double mean_share) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- " + comment_text(comment) +
                     " -->\n<routes xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
                     "xsi:noNamespaceSchemaLocation=\"http://sumo.dlr.de/xsd/routes_file.xsd\">\n";
  for (const PlannedPerson& person : people) text += type_of(person, mean_share);
  for (const PlannedPerson& person : people) text += plan_of(person, network);
  return text + "</routes>\n";
}

}  // namespace pedzone
