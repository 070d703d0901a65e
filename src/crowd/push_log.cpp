#include "crowd/push_log.hpp"

#include <algorithm>

namespace pedzone {
namespace {

constexpr double kPause = 1.0;    // [s] assumed: after that, it is another push
constexpr double kStep = 1.0;     // [m] assumed: who steps back before a vehicle goes no farther
constexpr double kPushed = 0.01;  // [m] numerical: moved by less, nobody is pushed

/// Whether what went on until `last` goes on in a step that begins at `begin` [s].
bool goes_on(double last, double begin) { return begin - last <= kPause; }

}  // namespace

void PushLog::add(double time, double dt, std::span<const VehiclePush> pushes) {
  const double end = time + dt;
  for (const VehiclePush& push : pushes) {
    const auto add_to = [&](Going& going, double way) {
      if (!goes_on(going.last, time)) going.way = 0.0;
      going.way += way;
      going.last = end;
      return going.way;
    };
    const double way = add_to(going_[push.person], push.way);
    Pair& pair = pairs_[{push.person, push.vehicle}];
    const double carried = add_to(pair.carried, push.carried);
    const bool run_into = push.run_into || (push.carried > 0.0 && carried > kStep);
    if (way >= kPushed || run_into) {
      PushedPerson& person = persons_[push.person];
      person.way = std::max(person.way, way);
      person.speed = std::max(person.speed, push.speed);
      person.run_into = person.run_into || run_into;
    }
    if (!run_into) continue;
    if (!goes_on(pair.last, time)) {
      run_into_.push_back({time, push.person, push.vehicle, push.contact_speed, push.position});
    }
    pair.last = end;
  }
}

}  // namespace pedzone
