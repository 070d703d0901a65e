#include "crowd/motion/shoulders.hpp"

#include <algorithm>

#include "crowd/behaviour/jams.hpp"
#include "crowd/state/parallel.hpp"

namespace pedzone {
namespace {

/// [m] by which the body can grow on all sides before it touches a wall, or another body that grows
/// as much.
double room_around(const CrowdState& crowd, std::size_t block, std::size_t i) {
  const Vec2 here = crowd.position(i);
  const double full = crowd.persons.radius[i], present = crowd.persons.present_radius[i];
  double least = crowd.walls_of(i).room(here, full) - present;
  for (const std::uint32_t j : crowd.near.of(block, i)) {
    const double gap =
        (here - crowd.position(j)).norm() - present - crowd.persons.present_radius[j];
    least = std::min(least, 0.5 * gap);
  }
  return std::max(least, 0.0);
}

/// Who is led by the hand cannot turn; who squeezes is taken for a narrower person by everybody.
void set_widths(const CrowdState& crowd, const WalkState& walker, double& full, double& turned) {
  const JamMemory& jam = crowd.jams[walker.handle];
  const bool by_the_hand = crowd.children[walker.handle].holds_hand;
  const float share = by_the_hand ? 1.0F : width_left(jam) * walker.turned_width;
  turned = static_cast<double>(share * walker.full_radius);
  full = jam.squeezes() ? turned : walker.full_radius;
}

}  // namespace

void hold_shoulders(const CrowdState& crowd, double dt, std::vector<WalkState>& walkers,
                    std::vector<double>& next_radius, Persons& persons) {
  next_radius.resize(persons.walking);
  const double time = std::max(crowd.zone.parameters.turn_time, dt);
  for_each_block(persons.walking, [&](std::size_t block, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      WalkState& walker = walkers[i];
      set_widths(crowd, walker, persons.radius[i], persons.turned_radius[i]);
      const bool turns =
          crowd.decisions[i].turns || walker.pressed || crowd.standing.passed[i] != 0;
      const double wanted = turns ? persons.turned_radius[i] : persons.radius[i];
      const double present = persons.present_radius[i];
      // A body half as wide straightens within the time to turn. So does who cannot turn, after it
      // was narrower all the same: when it squeezed, or before it was taken by the hand. Whom
      // somebody has just put here is as wide as there is room for.
      const double growth =
          walker.new_here ? walker.full_radius : 0.5 * walker.full_radius * dt / time;
      next_radius[i] =
          present < wanted
              ? std::min(wanted, present + std::min(growth, room_around(crowd, block, i)))
              : wanted;
      walker.new_here = false;
      walker.pressed = false;
    }
  });
  std::ranges::copy(next_radius, persons.present_radius.begin());
}

}  // namespace pedzone
