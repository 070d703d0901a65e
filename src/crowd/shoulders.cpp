#include "crowd/shoulders.hpp"

#include <algorithm>

#include "crowd/parallel.hpp"

namespace pedzone {
namespace {

/// [m] by which the body can grow on all sides before it touches another, if that grows as much.
double room_around(const CrowdState& crowd, std::size_t i,
                   std::span<const std::uint32_t> neighbours) {
  double least = crowd.persons.radius[i];
  for (const std::uint32_t j : neighbours) {
    const double gap = (crowd.position(i) - crowd.position(j)).norm() -
                       crowd.persons.present_radius[i] - crowd.persons.present_radius[j];
    least = std::min(least, 0.5 * gap);
  }
  return std::max(least, 0.0);
}

/// Who is led by the hand cannot turn; who squeezes is taken for a narrower person by everybody.
void set_widths(const WalkState& walker, double& full, double& turned) {
  const float share = walker.holds_hand ? 1.0F : walker.jam.share * walker.turned_width;
  turned = static_cast<double>(share * walker.full_radius);
  full = walker.jam.squeezed > 0.0F ? turned : walker.full_radius;
}

}  // namespace

void hold_shoulders(CrowdState& crowd, double dt) {
  Persons& persons = crowd.persons;
  crowd.next_radius.resize(persons.walking);
  const double time = std::max(crowd.zone.parameters.turn_time, dt);
  for_each_block(persons.walking, [&](std::size_t block, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      WalkState& walker = crowd.walkers[i];
      const auto near = crowd.neighbours_of(block, i);
      set_widths(walker, persons.radius[i], persons.turned_radius[i]);
      const double full = persons.radius[i], present = persons.present_radius[i];
      if (crowd.decisions[i].turns || walker.pressed || crowd.passed[i] != 0) {
        crowd.next_radius[i] = persons.turned_radius[i];
      } else {
        const double growth = (full - persons.turned_radius[i]) * dt / time;
        crowd.next_radius[i] =
            present < full ? std::min(full, present + std::min(growth, room_around(crowd, i, near)))
                           : full;
      }
      walker.pressed = false;
    }
  });
  std::ranges::copy(crowd.next_radius, persons.present_radius.begin());
}

}  // namespace pedzone
