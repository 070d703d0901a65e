#include "study/measure/tripinfo_reader.hpp"

#include <algorithm>

#include "core/xml_stream.hpp"

namespace pedzone::study {
namespace {

constexpr NumberRange kTimes{-1e9, 1e9};    // [s]
constexpr NumberRange kSpeeds{0.001, 1e3};  // [m/s]

/// SUMO writes times that never came as -1 or, by rounding, as -0.001.
std::optional<double> moment(const XmlElement& element, std::string_view attribute) {
  const double time = element.number(attribute, kTimes);
  return time < 0.0 ? std::nullopt : std::optional(time);
}

/// A type without what programs add that derive one for a single vehicle ("van@car7").
std::string type_of(const XmlElement& element, std::string_view attribute, const std::string& id) {
  std::string type(element.required(attribute));
  if (type.ends_with("@" + id)) type.resize(type.size() - id.size() - 1);
  return type;
}

PersonTrip person_of(const XmlElement& element) {
  PersonTrip trip;
  trip.id = element.required("id");
  trip.type = type_of(element, "type", trip.id);
  trip.due = element.number("depart", kTimes);
  return trip;
}

VehicleTrip vehicle_of(const XmlElement& element) {
  VehicleTrip trip;
  trip.id = element.required("id");
  trip.type = type_of(element, "vType", trip.id);
  // Removed, after a collision say, is not arrived.
  if (element.value("vaporized").value_or("").empty()) trip.arrival = moment(element, "arrival");
  trip.depart_delay = element.number("departDelay", kTimes);
  trip.time_loss = element.number("timeLoss", kTimes);
  const auto depart = moment(element, "depart");
  trip.departed = depart.has_value();
  if (depart) trip.due = *depart - trip.depart_delay;
  return trip;
}

/// A stage of the person whose element is open.
void add_stage(const XmlElement& element, PersonTrip& person) {
  if (!element.value("arrival")) return;
  // Who has come to where it wants to stop has arrived, however long it stops.
  if (element.name() == "stop" && person.moves) return;
  person.moves = person.moves || element.name() != "stop";
  person.arrival = moment(element, "arrival");
  if (element.name() != "walk") return;
  const auto depart = moment(element, "depart");
  if (!depart) return;
  person.walks.push_back({*depart, person.arrival, element.number("maxSpeed", kSpeeds)});
}

}  // namespace

Trips read_tripinfo(const std::string& file) {
  Trips trips;
  bool in_person = false;
  visit_elements(file, "tripinfos", [&](const XmlElement& element) {
    if (element.depth() == 1) {
      in_person = element.name() == "personinfo";
      if (in_person) trips.persons.push_back(person_of(element));
      if (element.name() == "tripinfo") trips.vehicles.push_back(vehicle_of(element));
    } else if (element.depth() == 2 && in_person) {
      add_stage(element, trips.persons.back());
    }
  });
  std::ranges::sort(trips.persons, {}, &PersonTrip::id);
  std::ranges::sort(trips.vehicles, {}, &VehicleTrip::id);
  return trips;
}

void settle(Trips& trips, double end) {
  for (VehicleTrip& trip : trips.vehicles) {
    if (!trip.departed) trip.due = end - trip.depart_delay;
  }
  const auto too_late = [end](const auto& trip) { return trip.due >= end; };
  std::erase_if(trips.persons, too_late);
  std::erase_if(trips.vehicles, too_late);
}

}  // namespace pedzone::study
