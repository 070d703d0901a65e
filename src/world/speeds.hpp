// How slow is standing. One speed for each question that is asked.
#pragma once

namespace pedzone {

/// [m/s] slower, a person or a vehicle stands, for whoever measures or tells it: SUMO's own
/// threshold for halting.
inline constexpr double kHaltingSpeed = 0.1;

/// [m/s] slower, something is taken to stay where it is, by those who foresee contacts with it: a
/// parked vehicle, somebody who stands. Assumed: half of kHaltingSpeed.
inline constexpr float kStaticSpeed = 0.05F;

/// [m/s] faster, a vehicle drives: reason to keep out of its way, to take a child's hand, to run
/// in front of it. Assumed: crawling is not driving.
inline constexpr double kDrivingSpeed = 0.3;

/// [m/s] no faster, a vehicle drives past people who have turned their shoulders since there is no
/// other room beside it. Assumed: below what measures of conflicts call moving (0.5 m/s).
inline constexpr double kSqueezeSpeed = 0.4;

/// Whether people squeeze past a vehicle of that speed [m/s]; a little more is rounding.
constexpr bool lets_squeeze_past(double speed) { return speed < kSqueezeSpeed + kStaticSpeed; }

/// [m/s] slower, a body faces where it likes; faster, it faces where it goes. Assumed.
inline constexpr double kFacingSpeed = 0.3;

}  // namespace pedzone
