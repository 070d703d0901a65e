#include "crowd/behaviour/jams.hpp"

#include <algorithm>

#include "crowd/sense/danger.hpp"
#include "crowd/state/parallel.hpp"

namespace pedzone {
namespace {

constexpr float kProgress = 0.5F;      // [m] assumed: coming nearer by less is standing in a jam
constexpr double kVehicleNear = 10.0;  // [m] assumed: with a vehicle so near it is not people who
                                       // are in the way
constexpr float kFree = 2.0F;          // [s] assumed: with room for so long, a jam is over
constexpr float kNarrowest = 0.25F;    // assumed: least share of the turned width. Two adults pass
                                       // each other in 0.3 m then, as if one stepped off the kerb
constexpr float kSqueezeTime = 10.0F;  // [s] assumed: until somebody is as narrow as that
constexpr double kWithinReach = 0.15;  // [m] assumed: between turned bodies that face each other
// Of two who face each other none gets on by waiting, as somebody in a queue does. What they have
// waited so long they do not forget after a step or two.
constexpr float kFaceToFace = 12.0F;  // assumed: so many times as fast does their time pass
constexpr float kForgotten = 1.0F;    // [s] assumed: of that with each `kProgress`
constexpr float kKept = 0.8F;         // assumed: share of jamTime that is left after squeezing

/// Whether people alone keep the person from going on.
bool lacks_room(const CrowdState& crowd, std::size_t i) {
  const WalkState& walker = crowd.walkers[i];
  if (walker.arrived || walker.waits || crowd.groups[walker.handle].waits) return false;
  if (crowd.children[walker.handle].led) return false;
  if (!crowd.decisions[i].turns && !walker.pressed) return false;
  return moving_near(crowd, crowd.position(i), kVehicleNear, 0.0) == nullptr;
}

/// Whether somebody stands in the person's way who wants to go where it comes from.
bool faces_somebody(const CrowdState& crowd, std::size_t block, std::size_t i) {
  const Persons& persons = crowd.persons;
  const Vec2 way = unit(persons.goal_direction[i]);
  return std::ranges::any_of(crowd.near.of(block, i), [&](std::uint32_t j) {
    if (j >= persons.walking) return false;
    const Vec2 there = crowd.position(j) - crowd.position(i);
    const double distance = there.norm();
    return distance < persons.turned_radius[i] + persons.turned_radius[j] + kWithinReach &&
           there.dot(way) > 0.5 * distance && way.dot(unit(persons.goal_direction[j])) < -0.5;
  });
}

void keep_clocks(const CrowdState& crowd, std::size_t block, std::size_t i, float step,
                 JamMemory& jam) {
  const auto jam_time = static_cast<float>(crowd.zone.parameters.jam_time);
  const bool stuck = lacks_room(crowd, i);
  jam.free = stuck ? 0.0F : jam.free + step;
  if (jam.squeezes() && jam.free > kFree) {
    jam.squeezed = jam.stuck = 0.0F;
    jam.faced = kKept * jam_time;
  }
  const auto left = static_cast<float>(way_left(crowd.walkers[i].route, crowd.position(i)));
  if (left < jam.least_left - kProgress) {
    jam.least_left = left;
    jam.stuck = 0.0F;
    jam.faced = std::max(jam.faced - kForgotten, 0.0F);
  } else if (stuck) {
    jam.stuck += step;
  }
  if (stuck && faces_somebody(crowd, block, i)) jam.faced += (kFaceToFace - 1.0F) * step;
  if (jam.squeezes() || (stuck && jam.stuck + jam.faced >= jam_time)) {
    jam.squeezed += step;
  }
}

}  // namespace

float width_left(const JamMemory& jam) {
  return 1.0F - (1.0F - kNarrowest) * std::min(jam.squeezed / kSqueezeTime, 1.0F);
}

void notice_jams(const CrowdState& crowd, double dt, ByHandle<JamMemory>& jams,
                 std::vector<JamNotice>& notices) {
  const auto step = static_cast<float>(dt);
  for_each_block(crowd.persons.walking,
                 [&](std::size_t block, std::size_t first, std::size_t last) {
                   for (std::size_t i = first; i < last; ++i) {
                     keep_clocks(crowd, block, i, step, jams[crowd.handle(i)]);
                   }
                 });
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    const bool begins = jams[crowd.handle(i)].squeezed == step;  // for this one substep
    if (begins) notices.push_back({crowd.handle(i), crowd.position(i)});
  }
}

}  // namespace pedzone
