// Which vehicles may matter to somebody at a place: of a town's vehicles most are near nobody.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/tile_lists.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

class VehiclesNear {
 public:
  /// [m], [s] What a place's list reaches: vehicles that come so near to it so soon. Numerical:
  /// farther than anybody steps aside; as long as people look who are to stand somewhere.
  static constexpr double kReach = 16.0, kAhead = 3.0;

  /// Lists them anew, for a step of `dt` [s] in which vehicles drive on as they are seen to move.
  void build(std::span<const VehicleState> vehicles, const Persons& persons, double dt);

  /// Places in the list of vehicles, ascending, of all whose body is, or within `time` [s] will
  /// be, at most `reach` [m] from the point, and of all that claim room there; a few more.
  std::span<const std::uint32_t> at(const Vec2& point, double reach = kReach,
                                    double time = 0.0) const;

 private:
  LatticeOrigin origin_;
  LatticeBox bounds_{0, 0, -1, -1};  ///< of the persons, and as far as they get in a step
  TileLists tiles_;
  std::vector<std::uint32_t> all_;
};

}  // namespace pedzone
