// Persons that pedzone walks, and programs that meddle with them: when SUMO's plan for a person is
// read again, and what follows from it. Reading plans is dear: each is read twice a second where
// there are such programs, before it is acted upon, and when the number of stages has changed.
#pragma once

#include <cstddef>
#include <functional>

#include "sumo/plan/takeover_plan.hpp"

namespace pedzone {

/// [s] numerical: between two looks at a plan; and where no other program is about, so that only
/// SUMO's rerouters give people other plans.
constexpr double kPlanInterval = 0.5, kPlanIntervalAlone = 5.0;

/// What is known of SUMO's plan for a person.
struct PlanWatch {
  std::size_t plan = 0;   ///< its number (plan_number)
  int stages_left = 0;    ///< when it was looked at last
  double check_at = 0.0;  ///< [s] when it is looked at again; ≤ 0: at once
};

/// Whether it is time [s] to read the plan. SUMO tells that so many stages are left.
bool is_due(const PlanWatch& watch, double time, int stages_left);

/// It is read now, and again after `interval` [s].
void note_look(PlanWatch& watch, double time, int stages_left, double interval = kPlanInterval);

/// What a look at a person finds.
enum class GuestFinding {
  kUnchanged,  ///< it walks on
  kMoved,      ///< another program has put it elsewhere: it is left to that program
  kReplanned,  ///< it has another plan: it is taken over anew, if that leads through the zone
};

/// SUMO's plan for the person has number `plan` now. `told` [m]: where SUMO was told to have it.
/// `place` [m]: where SUMO has it; asked only where the plan is the same, since with another plan
/// SUMO moves the person itself.
GuestFinding what_happened(const PlanWatch& watch, std::size_t plan, const Vec2& told,
                           const std::function<Vec2()>& place);

/// Whether a person is still walked by its plan, of which SUMO says that it has number `plan` now:
/// it may be given back then, or told another edge. Where that is another one, or nobody has looked
/// at it yet, it is looked at in the next step.
bool is_plan_sure(PlanWatch& watch, std::size_t plan);

/// What is remembered of a person that has another plan: nothing of its old way.
PersonPast with_new_plan(const PersonPast& past);

}  // namespace pedzone
