#include "conflict/encounter.hpp"

#include <cmath>

namespace pedzone {
namespace {

constexpr double kSameStep = 1e-6;  // [s] numerical: rounding of times

/// `touch`: [s] from the meeting's moment, when the bodies touch or are as near as it tells.
Extreme extreme(const Meeting& meeting, double value, double time, const Vec2& position,
                double touch = 0.0) {
  return {value,
          time,
          position,
          meeting.type,
          meeting.person_velocity.norm(),
          meeting.vehicle_velocity.norm(),
          (meeting.person_velocity - meeting.vehicle_velocity).norm(),
          closing_speed(meeting.approach, touch)};
}

/// The point of contact after `ttc` [s], in the plane.
Vec2 contact_place(const Meeting& meeting, double ttc) {
  return meeting.centre + meeting.vehicle_velocity * ttc +
         from_frame(meeting.axis, contact_point(meeting.approach, ttc));
}

}  // namespace

EncounterType type_of(const Approach& approach, double person_direction, double vehicle_direction,
                      bool vehicle_stands) {
  if (vehicle_stands) return EncounterType::kParked;
  const double turn = wrap_angle(person_direction - vehicle_direction);
  if (std::abs(turn) > kPi - kSameWay) return EncounterType::kHeadOn;
  if (std::abs(turn) >= kSameWay) {
    return turn < 0.0 ? EncounterType::kCrossingLeft : EncounterType::kCrossingRight;
  }
  const bool ahead = approach.at.x() * (approach.speed < 0.0 ? -1.0 : 1.0) >= 0.0;
  return ahead ? EncounterType::kFromBehind : EncounterType::kFollowing;
}

void Encounter::record(const Meeting& meeting, const std::function<std::optional<bool>()>& aware) {
  if (!started_) conflict.begin = meeting.time;
  conflict.end = meeting.time;
  if (!noticed_.value_or(false)) noticed_ = aware();
  record_contact_course(meeting);
  record_closeness(meeting);
  started_ = true;
}

void Encounter::tell_by(const Meeting& meeting) {
  conflict.type = meeting.type;
  conflict.by_pedzone = meeting.by_pedzone;
}

void Encounter::record_contact_course(const Meeting& meeting) {
  if (meeting.braking && !conflict.braking) {
    const bool just_before = last_ttc_ && std::abs(last_ttc_->time - meeting.before) < kSameStep;
    if (just_before) {
      conflict.braking = last_ttc_;  // braking began with the step
    } else if (meeting.ttc) {
      conflict.braking = Reaction{*meeting.ttc, meeting.time};
    }
  }
  if (!meeting.ttc) return;
  const double ttc = *meeting.ttc;
  // Of a vehicle that bends a step has a meeting of each part: the soonest contact counts.
  for (auto* const reaction : {&last_ttc_, &conflict.detection, &conflict.braking}) {
    if (*reaction && (*reaction)->time == meeting.time) {
      (*reaction)->value = std::min((*reaction)->value, ttc);
    }
  }
  if (!last_ttc_ || last_ttc_->time != meeting.time) last_ttc_ = Reaction{ttc, meeting.time};
  if (!conflict.detection) conflict.detection = last_ttc_;
  const Vec2 place = contact_place(meeting, ttc);
  if (!conflict.ttc || ttc < conflict.ttc->value) {
    conflict.ttc = extreme(meeting, ttc, meeting.time, place, ttc);
    conflict.aware = noticed_;
    if (!conflict.contact) tell_by(meeting);
  }
  const auto drac = deceleration_to_avoid(meeting.approach);
  if (drac && (!conflict.drac || *drac > conflict.drac->value)) {
    conflict.drac = extreme(meeting, *drac, meeting.time, place, ttc);
  }
}

void Encounter::record_clearance(const Meeting& meeting) {
  const double clearance = meeting.closest.clearance;
  if (conflict.clearance && clearance >= conflict.clearance->value) return;
  conflict.clearance = extreme(meeting, clearance, meeting.time, meeting.person);
  if (conflict.ttc) return;
  conflict.aware = noticed_;
  if (!conflict.pet) tell_by(meeting);
}

void Encounter::record_closeness(const Meeting& meeting) {
  const Closest& closest = meeting.closest;
  record_clearance(meeting);
  if (meeting.passing && (!conflict.pet || meeting.passing->pet() < conflict.pet->value)) {
    const Passing& passing = *meeting.passing;
    conflict.pet = extreme(meeting, passing.pet(), meeting.time, passing.place);
    conflict.first = passing.gap > 0.0   ? First::kVehicle
                     : passing.gap < 0.0 ? First::kPerson
                                         : First::kUnknown;
    if (!conflict.ttc) tell_by(meeting);
  }
  if (closest.touch && !conflict.contact) {
    const double time = meeting.before + (meeting.time - meeting.before) * *closest.touch;
    conflict.contact =
        extreme(meeting, 0.0, time, contact_place(meeting, 0.0), time - meeting.time);
    conflict.contact->value = conflict.contact->relative_speed;
    tell_by(meeting);
  }
}

}  // namespace pedzone
