#include "sumo/plan/walk_totals.hpp"

namespace pedzone {

void WalkTotals::take_over(PersonPast& past, bool walked_until_now) {
  if (!walked_until_now) ++takeovers;
  if (!past.was_controlled) ++controlled;
  past.was_controlled = true;
}

void WalkTotals::give_back(PersonPast& past, bool ends) {
  if (ends) ++ended;
  ++returns;
  if (!past.was_given_back) ++given_back;
  past.was_given_back = true;
}

void WalkTotals::walk(const Vec2& from, const PersonView& now, double preferred_speed, double dt) {
  const double walked = (now.position - from).norm();
  distance += walked;
  time += dt;
  if (preferred_speed > 0.0) free_time += walked / preferred_speed;
  if (now.motion != Motion::kWalking) waiting += dt;
}

}  // namespace pedzone
