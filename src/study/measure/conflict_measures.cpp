#include "study/measure/conflict_measures.hpp"

#include <algorithm>

#include "core/statistics.hpp"

namespace pedzone::study {
namespace {

struct TypeKey {
  EncounterType type;
  const char* key;
};
constexpr TypeKey kTypes[] = {{EncounterType::kHeadOn, "conflict.headOn"},
                              {EncounterType::kFromBehind, "conflict.fromBehind"},
                              {EncounterType::kFollowing, "conflict.following"},
                              {EncounterType::kCrossingLeft, "conflict.crossing"},
                              {EncounterType::kCrossingRight, "conflict.crossing"}};

void keep(const std::optional<Extreme>& extreme, std::vector<double>& sample) {
  if (extreme) sample.push_back(extreme->value);
}

bool below(const std::optional<Extreme>& extreme, double limit) {
  return extreme && extreme->value < limit;
}

}  // namespace

Extreme moment_of(const Conflict& conflict) {
  for (const auto* extreme : {&conflict.contact, &conflict.ttc, &conflict.pet}) {
    if (*extreme) return **extreme;
  }
  return conflict.clearance.value_or(Extreme{});
}

bool with_moving_vehicle(const Conflict& conflict) {
  return moment_of(conflict).vehicle_speed > kMovingVehicle;
}

bool is_insertion(const Conflict& conflict) {
  return conflict.contact && conflict.contact->time <= conflict.begin;
}

void ConflictMeasures::Counts::add(const Conflict& conflict) {
  all += 1.0;
  if (conflict.contact) contacts += 1.0;
  if (conflict.contact || below(conflict.ttc, kSeriousTtc) || below(conflict.pet, kSeriousPet)) {
    serious += 1.0;
  }
}

void ConflictMeasures::add(const Conflict& conflict) {
  if (is_insertion(conflict)) {
    insertions_ += 1.0;
    return;
  }
  if (!with_moving_vehicle(conflict)) {
    standing_.add(conflict);
    return;
  }
  moving_.add(conflict);
  types_[conflict.type] += 1.0;
  keep(conflict.ttc, ttc_);
  keep(conflict.pet, pet_);
  keep(conflict.drac, drac_);
  // Bodies overlap a little before it is told as a contact.
  if (conflict.contact) clearance_.push_back(0.0);
  if (conflict.clearance) clearance_.push_back(std::max(0.0, conflict.clearance->value));
}

void ConflictMeasures::finish(std::map<std::string, double>& values) const {
  values["conflict.count"] = moving_.all;
  values["conflict.serious"] = moving_.serious;
  values["conflict.contacts"] = moving_.contacts;
  values["conflict.standing"] = standing_.all;
  values["conflict.seriousStanding"] = standing_.serious;
  values["conflict.contactsStanding"] = standing_.contacts;
  values["conflict.insertions"] = insertions_;
  for (const TypeKey& type : kTypes) {
    const auto found = types_.find(type.type);
    values[type.key] += found == types_.end() ? 0.0 : found->second;
  }
  if (!ttc_.empty()) values["conflict.ttc"] = median(ttc_);
  if (!pet_.empty()) values["conflict.pet"] = median(pet_);
  if (!drac_.empty()) values["conflict.drac"] = median(drac_);
  if (!clearance_.empty()) values["conflict.clearance"] = std::ranges::min(clearance_);
}

}  // namespace pedzone::study
