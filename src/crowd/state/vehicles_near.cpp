#include "crowd/state/vehicles_near.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pedzone {
namespace {

constexpr double kTile = 16.0;         // [m] numerical
constexpr double kRoundBounds = 10.0;  // [m] numerical: who gets farther in a step looks at all
constexpr double kTilesPerPerson = 8.0, kTilesAtLeast = 1024.0;  // numerical

/// [m] from its centre. A body on its way is a chord of that, which turns: its centre gets farther
/// than its front drives, but by less than its length.
double reach_of(const VehicleState& vehicle, double dt) {
  return VehiclesNear::kReach + 1.5 * vehicle.length + vehicle.width + vehicle.claim +
         vehicle.velocity.norm() * (VehiclesNear::kAhead + dt);
}

LatticeBox bounds_of(const Persons& persons, const LatticeOrigin& origin) {
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  LatticeBox bounds{kMost, kMost, -kMost, -kMost};
  for (std::size_t i = 0; i < persons.size(); ++i) {
    const LatticePoint at = to_lattice(persons.x[i], persons.y[i], origin);
    bounds = {std::min<std::int64_t>(bounds.left, at.x), std::min<std::int64_t>(bounds.low, at.y),
              std::max<std::int64_t>(bounds.right, at.x),
              std::max<std::int64_t>(bounds.high, at.y)};
  }
  const std::int64_t margin = to_lattice(kRoundBounds);
  return {bounds.left - margin, bounds.low - margin, bounds.right + margin, bounds.high + margin};
}

}  // namespace

void VehiclesNear::build(std::span<const VehicleState> vehicles, const Persons& persons,
                         double dt) {
  all_.resize(vehicles.size());
  std::iota(all_.begin(), all_.end(), 0U);
  bounds_ = {0, 0, -1, -1};
  if (vehicles.empty() || persons.size() == 0) return;
  origin_ = {to_lattice(persons.x[0]), to_lattice(persons.y[0])};
  bounds_ = bounds_of(persons, origin_);
  const std::int64_t tile =
      tile_size_for(bounds_, to_lattice(kTile),
                    kTilesPerPerson * static_cast<double>(persons.size()) + kTilesAtLeast);
  tiles_.build(
      bounds_, tile, vehicles.size(),
      [&](std::size_t v) {
        const std::int64_t reach = to_lattice(reach_of(vehicles[v], dt));
        const std::int64_t x = to_lattice(vehicles[v].centre.x()) - origin_.x;
        const std::int64_t y = to_lattice(vehicles[v].centre.y()) - origin_.y;
        return LatticeBox{x - reach, y - reach, x + reach, y + reach};
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
