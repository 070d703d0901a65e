// What is summed over all persons that pedzone walks.
#pragma once

#include "crowd/state/person.hpp"
#include "sumo/plan/takeover_plan.hpp"

namespace pedzone {

/// Sums over all persons, for the summary.
struct WalkTotals {
  long controlled = 0;     ///< persons taken over at least once
  long given_back = 0;     ///< persons given back to SUMO at least once
  long takeovers = 0;      ///< of all of them
  long returns = 0;        ///< of all of them to SUMO
  long ended = 0;          ///< persons whose plan was ended by us: SUMO does not count them
  double distance = 0.0;   ///< [m] walked while controlled
  double time = 0.0;       ///< [s] while controlled
  double free_time = 0.0;  ///< [s] that distance at the preferred speed
  double waiting = 0.0;    ///< [s] waiting for vehicles or standing

  /// A person is taken over. `walked_until_now`: it was pedzone's already, with another plan.
  void take_over(PersonPast& past, bool walked_until_now);
  /// One is given back. `ends`: with that its plan is over, and SUMO knows it no more.
  void give_back(PersonPast& past, bool ends);
  /// One walks from a place [m] to where `now` has it, in `dt` [s]; its preferred speed [m/s].
  void walk(const Vec2& from, const PersonView& now, double preferred_speed, double dt);
};

}  // namespace pedzone
