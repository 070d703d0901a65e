#include "crowd/state/vehicles_near.hpp"

#include <algorithm>
#include <numeric>

namespace pedzone {
namespace {

constexpr double kTile = 16.0;         // [m] numerical
constexpr double kRoundBounds = 10.0;  // [m] numerical: who gets farther in a step looks at all
constexpr double kTilesPerPerson = 8.0, kTilesAtLeast = 1024.0;  // numerical

/// [m] from its centre. A body on its way is a chord of that, which turns: its centre gets farther
/// than its front drives, but by less than its length. In a long step it may get far ahead of that,
/// or drive off far.
double reach_of(const VehicleState& vehicle, double dt) {
  return VehiclesNear::kReach + 1.5 * vehicle.length + vehicle.width + vehicle.claim +
         vehicle.velocity.norm() * (VehiclesNear::kAhead + dt) +
         std::max(vehicle.lead, vehicle.starts);
}

LatticeBox grown(const LatticeBox& box, std::int64_t margin) {
  return {box.left - margin, box.low - margin, box.right + margin, box.high + margin};
}

}  // namespace

void VehiclesNear::build(std::span<const VehicleState> vehicles, const Persons& persons,
                         double dt) {
  all_.resize(vehicles.size());
  std::iota(all_.begin(), all_.end(), 0U);
  bounds_ = {0, 0, -1, -1};
  if (vehicles.empty() || persons.size() == 0) return;
  origin_ = {to_lattice(persons.x[0]), to_lattice(persons.y[0])};
  bounds_ = grown(bounds_of(persons.x, persons.y, origin_), to_lattice(kRoundBounds));
  const std::int64_t tile =
      tile_size_for(bounds_, to_lattice(kTile),
                    kTilesPerPerson * static_cast<double>(persons.size()) + kTilesAtLeast);
  tiles_.build(
      bounds_, tile, vehicles.size(),
      [&](std::size_t v) {
        return box_round(to_lattice(vehicles[v].centre.x()) - origin_.x,
                         to_lattice(vehicles[v].centre.y()) - origin_.y,
                         to_lattice(reach_of(vehicles[v], dt)));
      },
      [](std::size_t, const LatticeBox&) { return true; });
}

std::span<const std::uint32_t> VehiclesNear::at(const Vec2& point, double reach,
                                                double time) const {
  if (reach > kReach || time > kAhead) return all_;
  const std::int64_t x = to_lattice(point.x()) - origin_.x;
  const std::int64_t y = to_lattice(point.y()) - origin_.y;
  const bool listed =
      x >= bounds_.left && x <= bounds_.right && y >= bounds_.low && y <= bounds_.high;
  if (!listed) return all_;
  return tiles_.at({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)});
}

}  // namespace pedzone
