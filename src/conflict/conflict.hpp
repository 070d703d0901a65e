// What is told about one encounter of a person with a vehicle.
#pragma once

#include <optional>
#include <string>

#include "core/vec.hpp"

namespace pedzone {

/// How the two move to each other, by their directions (kSameWay): from which side of the vehicle
/// the person comes, as its driver sees it. A person who stands: by where it faces.
enum class EncounterType {
  kHeadOn,         ///< towards each other
  kFromBehind,     ///< the same way, the vehicle behind the person
  kFollowing,      ///< the same way, the person behind the vehicle
  kCrossingLeft,   ///< the person comes from the vehicle's left
  kCrossingRight,  ///< from its right
  kParked,         ///< the vehicle stands
};
const char* name_of(EncounterType type);  ///< "headOn", "fromBehind", "following" ...

enum class First { kUnknown, kPerson, kVehicle };
const char* name_of(First first);  ///< "NA", "person", "vehicle"

/// A measure at the moment of its extreme.
struct Extreme {
  double value = 0.0;            ///< in the measure's unit
  double time = 0.0;             ///< [s]
  Vec2 position = Vec2::Zero();  ///< [m] where they touch or would touch; clearance and PET: the
                                 ///< person's centre
  EncounterType type = EncounterType::kHeadOn;
  double person_speed = 0.0, vehicle_speed = 0.0, relative_speed = 0.0;  ///< [m/s]
  double closing_speed = 0.0;  ///< [m/s] at which the bodies come nearer where they touch or would
                               ///< touch, or are nearest; negative: they part
};

/// TTC at a moment of the vehicle's reaction.
struct Reaction {
  double value = 0.0;  ///< [s] TTC
  double time = 0.0;   ///< [s] when
};

struct Conflict {
  std::string person, vehicle;
  double begin = 0.0, end = 0.0;                ///< [s] first and last moment in which it mattered
  EncounterType type = EncounterType::kHeadOn;  ///< at the contact, else at the least TTC, else at
                                                ///< the PET, else at the least clearance
  First first = First::kUnknown;                ///< who was first at the place of the PET
  std::optional<bool> aware;          ///< the person had noticed the vehicle by the moment
                                      ///< of the least TTC, else of the least clearance
  std::optional<bool> by_pedzone;     ///< pedzone walked the person at the moment of `type`;
                                      ///< nothing: not known
  std::optional<Extreme> ttc;         ///< [s] least time to contact
  std::optional<Extreme> drac;        ///< [m/s²] greatest deceleration to avoid contact
  std::optional<Extreme> pet;         ///< [s] least post-encroachment time
  std::optional<Extreme> clearance;   ///< [m] least; negative: overlap
  std::optional<Extreme> contact;     ///< [m/s] relative speed at the first contact
  std::optional<Reaction> detection;  ///< TTC when first found on a collision course (PCT)
  std::optional<Reaction> braking;    ///< TTC when the vehicle first braked (TBT)
};

/// Which encounters are told: those beyond one of the thresholds, and contacts. TTC, PET and DRAC
/// as SUMO's SSM device by default.
struct ConflictLimits {
  double ttc = 3.0;       ///< [s] [0, 60]
  double pet = 2.0;       ///< [s] [0, 60]
  double drac = 3.0;      ///< [m/s²] [0, 100]
  double range = 50.0;    ///< [m] (0, 1000] between the bodies; farther off nothing is detected
  double horizon = 10.0;  ///< [s] [0, 60] a TTC beyond this is none

  bool exceeded_by(const Conflict& conflict) const;
};

}  // namespace pedzone
