#include "study/plan/free_speed_demand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string_view>

#include "core/xml.hpp"
#include "study/plan/additional_copy.hpp"
#include "study/plan/walk_lengths.hpp"

namespace pedzone::study {
namespace {

constexpr double kLeastInZone = 30.0;  // [m] assumed: some 20 s under each model's control
constexpr double kUsualSpeed = 1.39;   // [m/s] SUMO's maxSpeed of pedestrians
constexpr double kLeastSpeed = 0.1;    // [m/s] numerical: keeps runs finite
/// Share of the maxSpeed that the slowest reach in the mean: an individual factor three deviations
/// low (SUMO's speedFactor of pedestrians deviates by 0.1), 0.9 by dawdling, and a reserve.
/// Assumed.
constexpr double kSlowShare = 0.5;
constexpr double kPause = 10.0;  // [s] assumed: between one's arrival and the next departure

/// Attributes of a flow that a person has not.
constexpr const char* kFlowAttributes[] = {"begin",   "end",         "number",        "period",
                                           "perHour", "probability", "personsPerHour"};

/// Somebody who may be chosen.
struct Candidate {
  pugi::xml_node node;  ///< person or personFlow, walks only
  bool flow = false;
  WalkLength length;
};

/// Types and people of all files.
class People {
 public:
  explicit People(const FreeSpeedInput& input) : lengths_(input.network, input.zone_edges) {}

  /// `types`: whether they are to be copied, since the file is not read any more.
  void take(pugi::xml_node root, bool types) {
    for (const pugi::xml_node& node : root.children()) {
      const std::string_view name = node.name();
      if (name == "vType" || name == "vTypeDistribution") {
        learn_type(node);
        if (types) types_.push_back(node);
      }
      if (name == "person") consider(node, false);
      if (name == "personFlow") consider(node, true);
    }
  }

  const std::vector<pugi::xml_node>& types() const { return types_; }
  const std::vector<Candidate>& candidates() const { return candidates_; }

  /// Time in which even the slowest have arrived [s].
  double time_of(const Candidate& candidate) const {
    const auto type = speeds_.find(candidate.node.attribute("type").value());
    const double speed = type == speeds_.end() ? kUsualSpeed : type->second;
    return candidate.length.total / std::max(kLeastSpeed, kSlowShare * speed);
  }

 private:
  void learn_type(const pugi::xml_node& node) {
    double slowest = speed_of(node);
    for (const pugi::xml_node& member : node.children("vType")) {
      slowest = std::min(slowest, speed_of(member));
      speeds_[member.attribute("id").value()] = speed_of(member);
    }
    for (const std::string& member : split_words(node.attribute("vTypes").value())) {
      if (speeds_.contains(member)) slowest = std::min(slowest, speeds_.at(member));
    }
    speeds_[node.attribute("id").value()] = slowest;
  }

  static double speed_of(const pugi::xml_node& type) {
    double factor = 1.0;
    const bool plain = parse_number(type.attribute("speedFactor").value(), factor);
    return type.attribute("maxSpeed").as_double(kUsualSpeed) *
           (plain ? std::min(factor, 1.0) : 1.0);
  }

  void consider(const pugi::xml_node& node, bool flow) {
    WalkLength sum;
    std::string at;  // edge where the last walk ended
    bool walks = false;
    for (const pugi::xml_node& stage : node.children()) {
      const std::string_view name = stage.name();
      if (stage.type() != pugi::node_element || name == "param" || name == "stop") continue;
      const bool walk = name == "walk" || (name == "personTrip" && !stage.attribute("modes"));
      const auto length = walk ? length_of(stage, at) : std::nullopt;
      if (!length) return;
      sum.total += length->total;
      sum.in_zone += length->in_zone;
      walks = true;
    }
    if (walks) candidates_.push_back({node, flow, sum});
  }

  std::optional<WalkLength> length_of(const pugi::xml_node& walk, std::string& at) const {
    const auto edges = split_words(walk.attribute("edges").value());
    if (!edges.empty()) {
      at = edges.back();
      return lengths_.along(edges);
    }
    const std::string from = walk.attribute("from") ? walk.attribute("from").value() : at;
    at = walk.attribute("to").value();
    return lengths_.between(from, at);
  }

  WalkLengths lengths_;
  std::map<std::string, double> speeds_;  ///< [m/s] the slowest of a type, by id
  std::vector<pugi::xml_node> types_;
  std::vector<Candidate> candidates_;
};

/// Of each of as many slices as persons are wanted the one in the middle: all kinds of people
/// occur, and long ways as often as in the scenario. (The shortest ways lead round nothing, so that
/// how much longer ways are alone would be told of other people than the study's.)
std::vector<const Candidate*> choose(const std::vector<Candidate>& all) {
  std::vector<const Candidate*> able;
  for (const double least : {kLeastInZone, 0.0}) {
    for (const Candidate& candidate : all) {
      if (candidate.length.in_zone > least) able.push_back(&candidate);
    }
    if (!able.empty()) break;
  }
  const std::size_t slices = std::min(able.size(), kFreeSpeedPersons);
  std::vector<const Candidate*> chosen;
  for (std::size_t i = 0; i < slices; ++i) {
    chosen.push_back(able[(2 * i + 1) * able.size() / (2 * slices)]);
  }
  return chosen;
}

/// Flows have more than one: everybody in turn until there are enough.
std::vector<std::pair<const Candidate*, int>> repeat(const std::vector<const Candidate*>& chosen) {
  std::vector<std::pair<const Candidate*, int>> persons;
  bool any_flow = true;
  for (int round = 0; any_flow && persons.size() < kFreeSpeedPersons; ++round) {
    any_flow = false;
    for (const Candidate* candidate : chosen) {
      if (persons.size() == kFreeSpeedPersons) break;
      if (round == 0 || candidate->flow) persons.emplace_back(candidate, round);
      any_flow |= candidate->flow;
    }
  }
  return persons;
}

void append_person(pugi::xml_node routes, const Candidate& candidate, int number, double depart) {
  pugi::xml_node person = routes.append_copy(candidate.node);
  person.set_name("person");
  for (const char* attribute : kFlowAttributes) person.remove_attribute(attribute);
  while (person.remove_child("stop")) {
  }
  std::string id = candidate.node.attribute("id").value();
  if (candidate.flow) id += "." + std::to_string(number);
  person.attribute("id").set_value(id.c_str());
  person.remove_attribute("depart");
  person.append_attribute("depart") = fmt::format("{:.2f}", depart).c_str();
}

}  // namespace

FreeSpeedDemand free_speed_demand(const FreeSpeedInput& input) {
  FreeSpeedDemand demand;
  People people(input);
  std::vector<std::unique_ptr<XmlFile>> files;  // what the candidates point into
  for (const std::string& file : input.scenario.additional_files) {
    files.push_back(std::make_unique<XmlFile>(file));
    people.take(files.back()->root(), false);
  }
  for (const std::string& file : input.scenario.route_files) {
    files.push_back(std::make_unique<XmlFile>(file));
    people.take(files.back()->root(), true);
  }
  pugi::xml_document panel;
  panel.load_buffer(input.panel.data(), input.panel.size());
  people.take(panel.document_element(), true);
  const auto persons = repeat(choose(people.candidates()));
  if (persons.empty()) {
    throw InputError("has nobody whose free speed can be measured",
                     {input.scenario.config, 0, "route files", "",
                      "a <person> or <personFlow> that only walks, and through a zone"});
  }
  pugi::xml_document document;
  pugi::xml_node routes = document.append_child("routes");
  for (const pugi::xml_node& type : people.types()) routes.append_copy(type);
  double time = input.begin;
  for (const auto& [candidate, number] : persons) {
    append_person(routes, *candidate, number, time);
    time += people.time_of(*candidate) + kPause;
  }
  dissolve_groups(routes);
  demand.routes = xml_text(document);
  demand.end = std::ceil(time);
  demand.persons = persons.size();
  return demand;
}

}  // namespace pedzone::study
