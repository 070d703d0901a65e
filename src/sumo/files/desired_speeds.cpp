#include "sumo/files/desired_speeds.hpp"

#include <algorithm>
#include <limits>

#include "core/xml_stream.hpp"

namespace pedzone {
namespace {

constexpr NumberRange kSpeeds{0.0, 1000.0};  // [m/s]
// What SUMO takes where a type does not say (measured with 1.15, in process and over TraCI).
constexpr double kPedestrian = 5.0 / 3.6, kBicycle = 20.0 / 3.6;  // [m/s]
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// For pedestrians maxSpeed is the desired one, unless that is there, too.
double desired_speed(const XmlElement& type) {
  const std::string_view kind = type.value("vClass").value_or("passenger");
  if (type.value("desiredMaxSpeed")) return type.number("desiredMaxSpeed", kSpeeds);
  if (kind == "bicycle") return kBicycle;
  if (kind != "pedestrian") return kUnbounded;
  return type.value("maxSpeed") ? type.number("maxSpeed", kSpeeds) : kPedestrian;
}

}  // namespace

void DesiredSpeeds::read(const std::string& file) {
  visit_elements(file, "", [&](const XmlElement& element) {
    if (element.name() != "vType") return;
    types_[std::string(element.required("id"))] = desired_speed(element);
  });
}

double DesiredSpeeds::of_type(std::string_view type) const {
  std::string name(type);
  auto found = types_.find(name);
  if (found == types_.end()) {
    name.resize(std::min(name.size(), name.rfind('@')));
    found = types_.find(name);
  }
  if (found != types_.end()) return found->second;
  if (name == "DEFAULT_BIKETYPE") return kBicycle;
  return name == "DEFAULT_PEDTYPE" ? kPedestrian : kUnbounded;
}

}  // namespace pedzone
