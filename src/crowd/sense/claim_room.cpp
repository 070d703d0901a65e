#include "crowd/sense/claim_room.hpp"

#include <cmath>

#include "geometry/polyline.hpp"

namespace pedzone {
namespace {

constexpr double kBehindFront = 0.5;  // [m] numerical: beside the bumper still counts as before it

}  // namespace

std::optional<ClaimPlace> place_in_claim(const VehicleState& vehicle, const Vec2& point,
                                         double margin) {
  if (vehicle.way.size() < 2) return std::nullopt;
  const LineProjection at = project_on(vehicle.way, point);
  const double ahead = at.offset - vehicle.gone - vehicle.length;
  if (ahead < -kBehindFront || ahead > vehicle.claim) return std::nullopt;
  if (std::abs(at.lateral) >= 0.5 * vehicle.width + margin) return std::nullopt;
  return ClaimPlace{ahead, at.lateral, point_on(vehicle.way, at.offset).direction};
}

}  // namespace pedzone
