#include "conflict/conflict.hpp"

namespace pedzone {

const char* name_of(EncounterType type) {
  switch (type) {
    case EncounterType::kHeadOn:
      return "headOn";
    case EncounterType::kFromBehind:
      return "fromBehind";
    case EncounterType::kFollowing:
      return "following";
    case EncounterType::kCrossingLeft:
      return "crossingLeft";
    case EncounterType::kCrossingRight:
      return "crossingRight";
    case EncounterType::kParked:
      return "parked";
  }
  return "unknown";
}

const char* name_of(First first) {
  switch (first) {
    case First::kUnknown:
      return "NA";
    case First::kPerson:
      return "person";
    case First::kVehicle:
      return "vehicle";
  }
  return "unknown";
}

bool ConflictLimits::exceeded_by(const Conflict& conflict) const {
  return conflict.contact || (conflict.ttc && conflict.ttc->value < ttc) ||
         (conflict.pet && conflict.pet->value < pet) ||
         (conflict.drac && conflict.drac->value > drac);
}

}  // namespace pedzone
