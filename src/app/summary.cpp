#include "app/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "app/json_text.hpp"

namespace pedzone {
namespace {

std::string metres(double value) {
  return std::isfinite(value) ? fmt::format("{:.2f} m", value) : "no vehicle came near";
}

void add_line(std::string& text, const std::string& name, const std::string& value) {
  text += fmt::format("  {:<34}{}\n", name, value);
}

constexpr std::size_t kNamed = Standstills::kNamed;  // events that the table names, too

std::string push_text(const RunSummary& summary) {
  const auto& pushes = summary.pushes;
  if (pushes.persons == 0) return "0";
  return fmt::format("{} (longest {:.2f} m, fastest {:.2f} m/s)", pushes.persons, pushes.longest_m,
                     pushes.fastest_mps);
}

std::string run_into_text(const std::vector<RunIntoRecord>& events) {
  std::string text;
  for (std::size_t k = 0; k < std::min(events.size(), kNamed); ++k) {
    const RunIntoRecord& event = events[k];
    text +=
        fmt::format("    '{}' by '{}' at {:.1f} s, ({:.1f}, {:.1f}) in zone '{}': {:.1f} m/s{}\n",
                    event.person, event.vehicle, event.time, event.position.x(), event.position.y(),
                    event.zone, event.speed, event.just_inserted ? ", just inserted by SUMO" : "");
  }
  if (events.size() > kNamed) text += fmt::format("    and {} more\n", events.size() - kNamed);
  return text;
}

template <typename Event>
std::span<const Event> first_of(const std::vector<Event>& all) {
  return std::span(all).first(std::min(all.size(), kNamed));
}

std::string stuck_text(const Stuck& stuck) {
  const std::string most =
      stuck.most == 0 ? "" : fmt::format(", at most {} (at {:.0f} s)", stuck.most, stuck.most_at_s);
  return fmt::format("{} at the end{}", stuck.now.size(), most);
}

std::string stuck_list(const Stuck& stuck) {
  std::string text;
  for (const Standstill& one : first_of(stuck.now)) {
    text += fmt::format("    '{}' since {:.0f} s at ({:.1f}, {:.1f}) {}\n", one.id, one.since,
                        one.position.x(), one.position.y(), one.where);
  }
  if (stuck.now.size() > kNamed)
    text += fmt::format("    and {} more\n", stuck.now.size() - kNamed);
  return text;
}

std::string warned_text(const RunSummary& summary, long WarningCounts::*count) {
  return summary.sumo.warnings ? std::to_string((*summary.sumo.warnings).*count)
                               : "not known: of SUMO's warnings, which are not read over TraCI nor "
                                 "with no-warnings or aggregate-warnings";
}

std::string teleport_text(const RunSummary& summary) {
  const auto& warnings = summary.sumo.warnings;
  if (!warnings) return std::to_string(summary.sumo.teleports);
  return fmt::format("{} (jam {}, yield {}, wrong lane {})", summary.sumo.teleports, warnings->jam,
                     warnings->yield, warnings->wrong_lane);
}

nlohmann::ordered_json stuck_json(const Stuck& stuck) {
  nlohmann::ordered_json json{{"at_end", stuck.now.size()},
                              {"most", stuck.most},
                              {"most_at_s", stuck.most_at_s},
                              {"first", nlohmann::ordered_json::array()}};
  for (const Standstill& one : first_of(stuck.now)) {
    json["first"].push_back({{"id", one.id},
                             {"since", one.since},
                             {"x", one.position.x()},
                             {"y", one.position.y()},
                             {"where", one.where}});
  }
  return json;
}

std::string crossing_text(const CrossingTotals& crossings) {
  std::string text = "Crossed streets between the junctions\n";
  const auto line = [&text](const std::string& name, const std::string& value) {
    add_line(text, name, value);
  };
  line("stepped out", std::to_string(crossings.crossings));
  line("  without looking", std::to_string(crossings.without_looking));
  line("mean wait at the kerb", fmt::format("{:.1f} s", crossings.mean_wait_s));
  const auto& gaps = crossings.gaps;
  line("gap seen that half of them take",
       gaps ? fmt::format("{:.1f} s [{:.1f}, {:.1f}]", gaps->median, gaps->low, gaps->high)
            : "too few gaps to tell");
  return text;
}

nlohmann::ordered_json persons_json(const RunSummary& summary) {
  const auto& persons = summary.persons;
  return {{"seen", persons.seen},
          {"controlled", persons.controlled},
          {"takeovers", persons.takeovers},
          {"given_back", persons.given_back},
          {"returns", persons.returns},
          {"arrived", persons.arrived},
          {"walking", persons.walking},
          {"lost", persons.lost},
          {"jammed", summary.jams.size()},
          {"mean_speed_mps", persons.mean_speed},
          {"mean_delay_s", persons.mean_delay_s},
          {"mean_waiting_s", persons.mean_waiting_s}};
}

nlohmann::ordered_json vehicles_json(const RunSummary& summary) {
  const auto& vehicles = summary.vehicles;
  nlohmann::ordered_json json{{"seen", vehicles.seen},
                              {"yielding", vehicles.yielding},
                              {"min_clearance_m", vehicles.min_clearance_m},
                              {"contacts", vehicles.contacts},
                              {"insertion_contacts", vehicles.insertion_contacts},
                              {"standing_contacts", vehicles.standing_contacts},
                              {"late_brakings", summary.late_brakings.size()},
                              {"mean_delay_s", vehicles.mean_delay_s}};
  // JSON has no infinity: no vehicle ever came near.
  if (!std::isfinite(vehicles.min_clearance_m)) json["min_clearance_m"] = nullptr;
  return json;
}

nlohmann::ordered_json crossing_json(const CrossingTotals& crossings) {
  nlohmann::ordered_json json{{"stepped_out", crossings.crossings},
                              {"without_looking", crossings.without_looking},
                              {"mean_wait_s", crossings.mean_wait_s},
                              {"median_gap", nullptr}};
  if (const auto& gaps = crossings.gaps) {
    json["median_gap"] = {{"s", gaps->median},
                          {"low_s", gaps->low},
                          {"high_s", gaps->high},
                          {"taken", gaps->taken},
                          {"let_pass", gaps->left}};
  }
  return json;
}

nlohmann::ordered_json jams_json(const RunSummary& summary) {
  auto json = nlohmann::ordered_json::array();
  for (const JamRecord& jam : summary.jams) {
    json.push_back({{"time", jam.time},
                    {"person", jam.person},
                    {"zone", jam.zone},
                    {"x", jam.position.x()},
                    {"y", jam.position.y()}});
  }
  return json;
}

nlohmann::ordered_json run_into_json(const RunSummary& summary) {
  auto json = nlohmann::ordered_json::array();
  for (const RunIntoRecord& event : summary.run_into) {
    json.push_back({{"time", event.time},
                    {"person", event.person},
                    {"vehicle", event.vehicle},
                    {"zone", event.zone},
                    {"x", event.position.x()},
                    {"y", event.position.y()},
                    {"speed_mps", event.speed},
                    {"just_inserted", event.just_inserted}});
  }
  return json;
}

nlohmann::ordered_json late_brakings_json(const RunSummary& summary) {
  auto json = nlohmann::ordered_json::array();
  for (const LateBraking& braking : first_of(summary.late_brakings)) {
    json.push_back({{"time", braking.time},
                    {"vehicle", braking.vehicle},
                    {"x", braking.front.x()},
                    {"y", braking.front.y()},
                    {"deceleration_mps2", braking.deceleration}});
  }
  return json;
}

nlohmann::ordered_json sumo_json(const RunSummary& summary) {
  const auto& sumo = summary.sumo;
  const auto warned = [&](long WarningCounts::*count) -> nlohmann::ordered_json {
    if (!sumo.warnings) return nullptr;
    return (*sumo.warnings).*count;
  };
  return {{"teleports", sumo.teleports},
          {"jam_teleports", warned(&WarningCounts::jam)},
          {"yield_teleports", warned(&WarningCounts::yield)},
          {"wrong_lane_teleports", warned(&WarningCounts::wrong_lane)},
          {"collisions", sumo.collisions},
          {"emergency_stops", sumo.emergency_stops},
          {"emergency_brakings", warned(&WarningCounts::emergency_brakings)},
          {"jammed_persons", warned(&WarningCounts::jammed_persons)}};
}

}  // namespace

std::string summary_table(const RunSummary& summary) {
  const auto& persons = summary.persons;
  const auto& vehicles = summary.vehicles;
  const auto& time = summary.time;
  std::string text;
  const auto line = [&text](const std::string& name, const std::string& value) {
    add_line(text, name, value);
  };
  text += "Persons\n";
  line("seen", std::to_string(persons.seen));
  line("taken over by pedzone",
       fmt::format("{} ({} times)", persons.controlled, persons.takeovers));
  line("given back to SUMO", fmt::format("{} ({} times)", persons.given_back, persons.returns));
  line("arrived", std::to_string(persons.arrived));
  line("still there", std::to_string(persons.walking));
  line("lost", std::to_string(persons.lost));
  line("jammed, and squeezed through", std::to_string(summary.jams.size()));
  line("mean speed in the zone", fmt::format("{:.2f} m/s", persons.mean_speed));
  line("mean delay in the zone", fmt::format("{:.1f} s", persons.mean_delay_s));
  line("mean waiting in the zone", fmt::format("{:.1f} s", persons.mean_waiting_s));
  if (summary.crossings) text += crossing_text(*summary.crossings);
  text += "Vehicles near the zone\n";
  line("seen", std::to_string(vehicles.seen));
  line("gave way to persons", std::to_string(vehicles.yielding));
  line("mean delay", fmt::format("{:.1f} s", vehicles.mean_delay_s));
  line("smallest clearance to a person", metres(vehicles.min_clearance_m));
  line("contacts of people it walked", std::to_string(vehicles.contacts));
  line("  by vehicles put onto somebody", std::to_string(vehicles.insertion_contacts));
  line("  with vehicles that stood", std::to_string(vehicles.standing_contacts));
  line("persons pushed", push_text(summary));
  line("ran into a person", std::to_string(summary.run_into.size()));
  text += run_into_text(summary.run_into);
  line("braked hard for a late step", std::to_string(summary.late_brakings.size()));
  text += fmt::format("Has not moved for {:.0f} s\n", Standstills::kLong);
  line("persons", stuck_text(summary.stuck_persons));
  text += stuck_list(summary.stuck_persons);
  line("vehicles", stuck_text(summary.stuck_vehicles));
  text += stuck_list(summary.stuck_vehicles);
  text += "Counted by SUMO\n";
  line("teleports", teleport_text(summary));
  line("collisions", std::to_string(summary.sumo.collisions));
  line("emergency stops", std::to_string(summary.sumo.emergency_stops));
  line("emergency brakings", warned_text(summary, &WarningCounts::emergency_brakings));
  line("jammed persons", warned_text(summary, &WarningCounts::jammed_persons));
  text += "Time\n";
  line("simulated", fmt::format("{:.0f} s", time.simulated_s));
  line("wall", fmt::format("{:.1f} s (SUMO {:.1f} s, pedzone {:.1f} s)", time.wall_s, time.sumo_s,
                           time.pedzone_s));
  line("pedzone per person and step",
       fmt::format("{:.1f} us ({} person-steps)", time.us_per_person_step, time.person_steps));
  return text;
}

std::string summary_json(const RunSummary& summary) {
  const auto& time = summary.time;
  nlohmann::ordered_json json;
  json["version"] = kJsonVersion;
  json["interrupted"] = summary.interrupted_by != 0;
  json["sumo_gone"] = summary.sumo_gone;
  json["persons"] = persons_json(summary);
  json["vehicles"] = vehicles_json(summary);
  if (summary.crossings) json["crossings"] = crossing_json(*summary.crossings);
  json["jams"] = jams_json(summary);
  json["pushes"] = {{"persons", summary.pushes.persons},
                    {"longest_m", summary.pushes.longest_m},
                    {"fastest_mps", summary.pushes.fastest_mps}};
  json["run_into"] = run_into_json(summary);
  json["late_brakings"] = late_brakings_json(summary);
  json["not_moved_for_60_s"] = {{"persons", stuck_json(summary.stuck_persons)},
                                {"vehicles", stuck_json(summary.stuck_vehicles)}};
  json["sumo"] = sumo_json(summary);
  json["time"] = {{"simulated_s", time.simulated_s},
                  {"wall_s", time.wall_s},
                  {"sumo_s", time.sumo_s},
                  {"pedzone_s", time.pedzone_s},
                  {"us_per_person_step", time.us_per_person_step},
                  {"person_steps", time.person_steps}};
  return json_text(json);
}

}  // namespace pedzone
