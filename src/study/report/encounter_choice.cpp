#include "study/report/encounter_choice.hpp"

#include <algorithm>
#include <cmath>

#include "study/measure/conflict_measures.hpp"

namespace pedzone::study {

namespace {

enum Kind { kContact, kTtc, kSlow, kPet, kClearance, kKinds };

constexpr double kFast = 1.0;    // [m/s] assumed: bodies that close in slower hurt nobody much
constexpr double kDepth = 0.03;  // [m] assumed: bodies that overlap less have brushed each other

/// Brushing past each other hurts less than what was avoided in the last moment.
bool hurts(const Conflict& conflict) {
  const bool deep = conflict.clearance && conflict.clearance->value <= -kDepth;
  return conflict.contact && (deep || conflict.contact->closing_speed > kFast);
}

Danger with_moving(const Conflict& conflict) {
  if (hurts(conflict)) return {kContact, -conflict.contact->closing_speed};
  if (conflict.ttc) {
    return {conflict.ttc->closing_speed > kFast ? kTtc : kSlow, conflict.ttc->value};
  }
  if (conflict.pet) return {kPet, conflict.pet->value};
  return {kClearance, conflict.clearance ? conflict.clearance->value : 0.0};
}

}  // namespace

Danger danger_of(const Conflict& conflict) {
  Danger danger = with_moving(conflict);
  if (!with_moving_vehicle(conflict)) danger.kind += kKinds;
  if (is_insertion(conflict)) danger.kind += 2 * kKinds;
  return danger;
}

std::uint32_t EncounterChoice::number_of(const std::string& id) {
  return ids_.try_emplace(id, static_cast<std::uint32_t>(ids_.size())).first->second;
}

void EncounterChoice::add(std::size_t scenario, const Place& place, const Conflict& conflict) {
  const Danger danger = danger_of(conflict);
  const Vec2 at = moment_of(conflict).position;
  candidates_.push_back({static_cast<std::uint32_t>(scenario), number_of(conflict.person),
                         number_of(conflict.vehicle), static_cast<std::uint32_t>(place.run),
                         static_cast<std::uint32_t>(place.row), danger.kind,
                         static_cast<float>(danger.value), static_cast<float>(at.x()),
                         static_cast<float>(at.y())});
}

bool EncounterChoice::alike(const Candidate& a, const Candidate& b, double apart) const {
  if (a.scenario != b.scenario) return false;
  return a.person == b.person || a.vehicle == b.vehicle || std::hypot(a.x - b.x, a.y - b.y) < apart;
}

std::vector<EncounterChoice::Place> EncounterChoice::most_dangerous(std::size_t most,
                                                                    double apart) const {
  std::vector<Candidate> sorted = candidates_;
  std::ranges::stable_sort(sorted, [](const Candidate& a, const Candidate& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.value < b.value;
  });
  std::vector<Candidate> chosen;
  for (const Candidate& one : sorted) {
    if (chosen.size() == most) break;
    const bool known =
        std::ranges::any_of(chosen, [&](const Candidate& c) { return alike(one, c, apart); });
    if (!known) chosen.push_back(one);
  }
  std::vector<Place> places;
  for (const Candidate& one : chosen) places.push_back({one.run, one.row});
  return places;
}

}  // namespace pedzone::study
