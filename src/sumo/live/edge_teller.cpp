#include "sumo/live/edge_teller.hpp"

#include <algorithm>

namespace pedzone {
namespace {

constexpr double kOthers = 5.0;  // [m] numerical: SUMO's do not meet it in a step
// SUMO would brake for it who passes within kVehicleSide [m] in kVehicleLook [s], or is within
// kVehicleNear [m], may stand, and drives off (assumed).
constexpr double kVehicleSide = 0.5, kVehicleLook = 5.0, kVehicleNear = 15.0;

}  // namespace

void EdgeTeller::begin_step(double time) {
  time_ = time;
  taken_.clear();
}

/// For the step that follows it is one of SUMO's on the lane, and SUMO's vehicles and people mind
/// it: it must not be in their way, nor in that of another one who is put there.
bool EdgeTeller::is_free(const Lane& lane, const Vec2& position, double radius, const Fleet& fleet,
                         Bystanders& others) const {
  if (taken_.contains(lane.id)) return false;
  if (lane.vehicles) {
    const bool near = std::ranges::any_of(fleet.vehicles(), [&](const FleetVehicle& vehicle) {
      return (vehicle.front - position).norm() < kVehicleNear;
    });
    if (near || fleet.approaches(position, radius + kVehicleSide, kVehicleLook)) return false;
  }
  return std::ranges::none_of(others.all(), [&](const Bystander& other) {
    return other.near && !other.guest && (other.position - position).norm() < kOthers;
  });
}

/// A program may have given the person another plan since the last look: its lane may be on no
/// route of it any more, which ends SUMO.
void EdgeTeller::tell(const std::string& id, EdgesWalked& edges, PlanWatch& watch,
                      const Vec2& position, double radius, const Fleet& fleet, Bystanders& others) {
  if (!edges.is_due(time_)) return;
  const auto move = edges.come_to(network_, position);
  if (!move) return;
  const Lane& lane = network_.lanes[network_.lane_index.at(move->lane)];
  if (!is_free(lane, position, radius, fleet, others)) return;
  if (!sumo_.walks(id) || !is_plan_sure(watch, sumo_.plan(id))) return;
  sumo_.put_on(id, *move);
  edges.be_on(network_, *move);
  taken_.insert(lane.id);
}

}  // namespace pedzone
