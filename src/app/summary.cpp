#include "app/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

namespace pedzone {
namespace {

std::string metres(double value) {
  return std::isfinite(value) ? fmt::format("{:.2f} m", value) : "no vehicle came near";
}

constexpr std::size_t kNamed = 10;  // late brakings that are told one by one

std::span<const LateBraking> first_of(const std::vector<LateBraking>& all) {
  return std::span(all).first(std::min(all.size(), kNamed));
}

}  // namespace

std::string summary_table(const RunSummary& summary) {
  const auto& persons = summary.persons;
  const auto& vehicles = summary.vehicles;
  const auto& time = summary.time;
  std::string text;
  const auto line = [&text](const std::string& name, const std::string& value) {
    text += fmt::format("  {:<34}{}\n", name, value);
  };
  text += "Persons\n";
  line("seen", std::to_string(persons.seen));
  line("taken over by pedzone", std::to_string(persons.controlled));
  line("arrived", std::to_string(persons.arrived));
  line("still walking", std::to_string(persons.walking));
  line("lost", std::to_string(persons.lost));
  line("jammed, and squeezed through", std::to_string(summary.jams.size()));
  line("mean speed in the zone", fmt::format("{:.2f} m/s", persons.mean_speed));
  line("mean delay in the zone", fmt::format("{:.1f} s", persons.mean_delay_s));
  line("mean waiting in the zone", fmt::format("{:.1f} s", persons.mean_waiting_s));
  text += "Vehicles near the zone\n";
  line("seen", std::to_string(vehicles.seen));
  line("gave way to persons", std::to_string(vehicles.yielding));
  line("mean delay", fmt::format("{:.1f} s", vehicles.mean_delay_s));
  line("smallest clearance to a person", metres(vehicles.min_clearance_m));
  line("contacts (person-vehicle pairs)", std::to_string(vehicles.contacts));
  line("  by vehicles put onto somebody", std::to_string(vehicles.insertion_contacts));
  line("braked hard for a late step", std::to_string(summary.late_brakings.size()));
  text += "Time\n";
  line("simulated", fmt::format("{:.0f} s", time.simulated_s));
  line("wall", fmt::format("{:.1f} s (SUMO {:.1f} s, pedzone {:.1f} s)", time.wall_s, time.sumo_s,
                           time.pedzone_s));
  line("pedzone per person and step",
       fmt::format("{:.1f} us ({} person-steps)", time.us_per_person_step, time.person_steps));
  return text;
}

std::string summary_json(const RunSummary& summary) {
  const auto& persons = summary.persons;
  const auto& vehicles = summary.vehicles;
  const auto& time = summary.time;
  nlohmann::ordered_json json;
  json["persons"] = {{"seen", persons.seen},
                     {"controlled", persons.controlled},
                     {"arrived", persons.arrived},
                     {"walking", persons.walking},
                     {"lost", persons.lost},
                     {"jammed", summary.jams.size()},
                     {"mean_speed_mps", persons.mean_speed},
                     {"mean_delay_s", persons.mean_delay_s},
                     {"mean_waiting_s", persons.mean_waiting_s}};
  json["vehicles"] = {{"seen", vehicles.seen},
                      {"yielding", vehicles.yielding},
                      {"min_clearance_m", vehicles.min_clearance_m},
                      {"contacts", vehicles.contacts},
                      {"insertion_contacts", vehicles.insertion_contacts},
                      {"late_brakings", summary.late_brakings.size()},
                      {"mean_delay_s", vehicles.mean_delay_s}};
  // JSON has no infinity: no vehicle ever came near.
  if (!std::isfinite(vehicles.min_clearance_m)) json["vehicles"]["min_clearance_m"] = nullptr;
  json["jams"] = nlohmann::ordered_json::array();
  for (const JamRecord& jam : summary.jams) {
    json["jams"].push_back({{"time", jam.time},
                            {"person", jam.person},
                            {"zone", jam.zone},
                            {"x", jam.position.x()},
                            {"y", jam.position.y()}});
  }
  json["late_brakings"] = nlohmann::ordered_json::array();
  for (const LateBraking& braking : first_of(summary.late_brakings)) {
    json["late_brakings"].push_back({{"time", braking.time},
                                     {"vehicle", braking.vehicle},
                                     {"x", braking.front.x()},
                                     {"y", braking.front.y()},
                                     {"deceleration_mps2", braking.deceleration}});
  }
  json["time"] = {{"simulated_s", time.simulated_s},
                  {"wall_s", time.wall_s},
                  {"sumo_s", time.sumo_s},
                  {"pedzone_s", time.pedzone_s},
                  {"us_per_person_step", time.us_per_person_step},
                  {"person_steps", time.person_steps}};
  return json.dump(2) + "\n";
}

}  // namespace pedzone
