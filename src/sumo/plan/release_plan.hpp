// Who is given back to SUMO, when and where: plans over plain values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sumo/plan/fleet.hpp"
#include "sumo/plan/zone_route.hpp"

namespace pedzone {

/// One call of moveTo.
struct LaneMove {
  std::string lane;
  double position = 0.0;          ///< [m] on the lane
  std::optional<double> lateral;  ///< [m] to the left of its middle; unset: as SUMO chooses

  bool operator==(const LaneMove&) const = default;
};

/// The calls that give a person back.
struct ReleasePlan {
  bool remove_stage = false;    ///< this alone
  bool begin_anew = false;      ///< its walk, before it is moved: tripinfo then has two
  std::vector<LaneMove> moves;  ///< in this order, with no step between them
};

/// A person at the end of its stretch, as the crowd has walked it in this step.
struct Walked {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  ///< [m] before and after the step
  double radius = 0.24;                         ///< [m]
  double preferred_speed = 0.0;                 ///< [m/s]
  bool ends_trip = false;                       ///< SUMO takes it out as soon as it has it
};

/// Whether a person at the end of that stretch has nothing left of its plan, with `stages_left`
/// stages in SUMO.
bool ends_trip(const ZoneStretch& stretch, int stages_left);

/// How a person is given back after a step of `dt` [s]; on a lane that vehicles use as well, beside
/// these. `present_lane`: id of the lane that SUMO has it on.
ReleasePlan plan_release(const Network& network, const ZoneStretch& stretch, const Walked& walked,
                         const std::string& present_lane, double dt);

/// Puts who leaves the zone forward on a lane so far ahead of a vehicle there that SUMO walks it
/// on; over the lane's end where it goes no farther. False where one comes that would have to brake
/// for it. It does not wait for ever: `kept` as in may_release().
bool go_ahead_of_vehicles(const Network& network, const ZoneStretch& stretch, const Fleet& fleet,
                          double dt, double& kept, ReleasePlan& plan);

/// How a person in the middle of its stretch, at `position` [m] with `radius` [m], is given back at
/// once: on the lane of its `route` (Network edges) up to index `last` that is nearest to it.
/// A route of one edge with one lane begins anew there, since there is no lane to hop over. Nothing
/// where SUMO has no lane to put it on.
std::optional<ReleasePlan> plan_let_go(const Network& network, const std::vector<int>& route,
                                       int last, const Vec2& position, double radius,
                                       const std::string& present_lane);

/// Where [m] SUMO has a person that is given back so; nothing where it stays where it is.
std::optional<Vec2> place_of(const Network& network, const ReleasePlan& plan);

/// Whether a person may be given back at `place` [m]. SUMO walks people into vehicles: not beside
/// one that moves or will. A person does not wait for ever, neither for one that waits for people,
/// since that may be the one it waits for, nor where they keep coming by: `kept` [s] counts how
/// long it has. Whose trip ends there waits for none that stands: it is walked nowhere.
bool may_release(const Vec2& place, const Walked& walked, const Fleet& fleet, double dt,
                 double& kept);

/// Whether a person may be given back both where the crowd has walked it to and at `place` [m],
/// where SUMO has it then.
bool may_hand_over(const Walked& walked, const std::optional<Vec2>& place, const Fleet& fleet,
                   double dt, double& kept);

}  // namespace pedzone
