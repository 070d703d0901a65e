#include "sumo/files/walk_speeds.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "sumo/files/number_text.hpp"

namespace pedzone {
namespace {

constexpr std::array<std::string_view, 5> kStages{"walk", "ride", "stop", "personTrip", "tranship"};

bool is_person(const XmlElement& element) {
  return element.name() == "person" || element.name() == "personFlow";
}

}  // namespace

/// What SUMO could not read it has refused, or will.
void WalkSpeeds::add_stage(const XmlElement& element, Plan& plan) {
  if (std::ranges::find(kStages, element.name()) == kStages.end()) return;
  plan.has_trip = plan.has_trip || element.name() == "personTrip";
  Stage stage;
  if (element.name() == "walk") {
    stage.speed = number_of(element.value("speed")).value_or(0.0);
    stage.duration = time_of(element.value("duration")).value_or(0.0);
  }
  plan.stages.push_back(stage);
}

void WalkSpeeds::keep(Plan plan) {
  const auto says = [](const Stage& stage) { return stage.speed > 0.0 || stage.duration > 0.0; };
  if (plan.has_trip || std::ranges::none_of(plan.stages, says)) return;
  (plan.is_flow ? flows_ : persons_)[plan.id] = std::move(plan.stages);
}

void WalkSpeeds::read(const std::string& file) {
  Plan plan;
  int depth = -1;  // of the person that is being read
  visit_elements(file, "", [&](const XmlElement& element) {
    if (is_person(element)) {
      const std::string id(element.value("id").value_or(""));
      keep(std::exchange(plan, {id, element.name() == "personFlow", {}, false}));
      depth = element.depth();
    } else if (element.depth() <= depth) {
      depth = -1;
    } else if (depth >= 0 && element.depth() == depth + 1) {
      add_stage(element, plan);
    }
  });
  keep(std::move(plan));
}

/// SUMO calls the persons of a flow "flow.0", "flow.1" ...
const std::vector<WalkSpeeds::Stage>* WalkSpeeds::stages_of(const std::string& person) const {
  const auto own = persons_.find(person);
  if (own != persons_.end()) return &own->second;
  const std::size_t dot = person.rfind('.');
  const bool numbered = dot != std::string::npos && dot + 1 < person.size() &&
                        person.find_first_not_of("0123456789", dot + 1) == std::string::npos;
  const auto flow = numbered ? flows_.find(person.substr(0, dot)) : flows_.end();
  return flow == flows_.end() ? nullptr : &flow->second;
}

std::optional<double> WalkSpeeds::of(const std::string& person, int stages_left,
                                     double length) const {
  if (stages_left < 1) return std::nullopt;
  const std::vector<Stage>* const stages = stages_of(person);
  const auto left = static_cast<std::size_t>(stages_left);
  if (stages == nullptr || left > stages->size()) return std::nullopt;
  const Stage& stage = (*stages)[stages->size() - left];
  if (stage.duration > 0.0 && length > 0.0) return length / stage.duration;
  return stage.speed > 0.0 ? std::optional(stage.speed) : std::nullopt;
}

}  // namespace pedzone
