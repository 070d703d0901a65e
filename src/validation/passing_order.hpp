// Who passed first where a person's way and those of vehicles cross: found without looking at what
// is far away, in space or in time.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "validation/clip.hpp"

namespace pedzone {

/// Vehicles slower than this do not count as moving [m/s] (validation.md, protocol).
inline constexpr double kMovingSpeed = 0.5;

/// Who passed first where a person's way and that of a vehicle's centre cross.
struct PassingOrder {
  bool person_first = false;  ///< by the centres
  double gap = 0.0;  ///< [s] post-encroachment time: from the person there to the vehicle's front,
                     ///< or from its rear to the person; 0 when the person was there in between
};

/// Distance [m] from a point to a vehicle's rectangle; negative inside (depth).
double signed_clearance(const VehicleState& vehicle, const Vec2& point);

/// Pieces [begin, end) of a way, and what is around their beginnings; of a vehicle: around all
/// places where a person's piece may begin that crosses them.
struct WayPart {
  std::size_t begin = 0, end = 0;
  Eigen::AlignedBox2d around;
};

/// The ways of a clip's vehicles, with what is around pieces of them. Refers to the clip, which has
/// to live as long and to stay as it is.
class VehicleWays {
 public:
  explicit VehicleWays(const Clip& clip);

  /// With the vehicle that came closest in time to the person who was at way[k] in frame first + k,
  /// at the place where their ways cross; of several such vehicles with the clip's first. None
  /// where no way crosses.
  std::optional<PassingOrder> closest(int first, const Polyline& way) const;

 private:
  struct Vehicle {
    const VehicleTrack* track = nullptr;
    std::vector<WayPart> parts;
    Eigen::AlignedBox2d around;
  };
  static std::optional<PassingOrder> closest_of(const Vehicle& vehicle, int first,
                                                const Polyline& way,
                                                std::span<const WayPart> parts);

  std::vector<Vehicle> vehicles_;
};

}  // namespace pedzone
