#include "sumo/plan/replanning.hpp"

namespace pedzone {
namespace {

// [m] numerical: SUMO gives back what it is told, exactly.
constexpr double kPlaceTolerance = 0.01;

}  // namespace

bool is_due(const PlanWatch& watch, double time, int stages_left) {
  return time >= watch.check_at || stages_left != watch.stages_left;
}

void note_look(PlanWatch& watch, double time, int stages_left, double interval) {
  watch.check_at = time + interval;
  watch.stages_left = stages_left;
}

GuestFinding what_happened(const PlanWatch& watch, std::size_t plan, const Vec2& told,
                           const std::function<Vec2()>& place) {
  if (plan != watch.plan) return GuestFinding::kReplanned;
  return (place() - told).norm() > kPlaceTolerance ? GuestFinding::kMoved
                                                   : GuestFinding::kUnchanged;
}

bool is_plan_sure(PlanWatch& watch, std::size_t plan) {
  if (plan != watch.plan) watch.check_at = 0.0;
  return watch.check_at > 0.0;
}

PersonPast with_new_plan(const PersonPast& past) {
  PersonPast now;
  now.was_controlled = true;
  now.was_given_back = past.was_given_back;
  return now;
}

}  // namespace pedzone
