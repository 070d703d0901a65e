#include "sumo/calls/vehicles.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <unordered_map>

#include "sumo/calls/api.hpp"
#include "sumo/calls/both.hpp"
#include "sumo/files/frames.hpp"
#include "sumo/files/truth.hpp"

namespace pedzone::PEDZONE_CALLS {
namespace {

using api::Vehicle;

constexpr double kPersonDecel = 5.0;  // [m/s²] assumed: a walker stops within half a metre
constexpr int kExactPlace = 2;        // SUMO's keepRoute: anywhere, on a lane or not
constexpr int kNoLaneChange = 512;    // SUMO's lane change mode: none that is not asked for
constexpr double kLaneReach = 100.0;  // [m] SUMO's default: so near it looks for a lane

class VehicleCalls final : public SumoVehicles {
 public:
  std::vector<std::string> ids() const override { return Vehicle::getIDList(); }
  std::vector<std::string> new_or_gone() const override {
    std::vector<std::string> ids = api::Simulation::getDepartedIDList();
    const std::vector<std::string> gone = api::Simulation::getArrivedIDList();
    ids.insert(ids.end(), gone.begin(), gone.end());
    return ids;
  }
  std::vector<std::string> teleported() const override {
    return api::Simulation::getEndingTeleportIDList();
  }
  std::vector<std::string> pending() const override {
    return api::Simulation::getPendingVehicles();
  }

  std::optional<Vec2> front(const std::string& id) const override {
    const auto position = Vehicle::getPosition(id);
    if (position.x == libsumo::INVALID_DOUBLE_VALUE) return std::nullopt;
    return Vec2(position.x, position.y);
  }

  double heading(const std::string& id) const override {
    return radians_from_sumo(Vehicle::getAngle(id));
  }
  double speed(const std::string& id) const override {
    return std::max(0.0, Vehicle::getSpeed(id));
  }
  double own_speed(const std::string& id) const override {
    return std::max(0.0, Vehicle::getSpeedWithoutTraCI(id));
  }
  double allowed_speed(const std::string& id) const override {
    return Vehicle::getAllowedSpeed(id);
  }
  double time_loss(const std::string& id) const override { return Vehicle::getTimeLoss(id); }
  std::string edge(const std::string& id) const override { return Vehicle::getRoadID(id); }
  std::string lane(const std::string& id) const override { return Vehicle::getLaneID(id); }
  double lateral(const std::string& id) const override {
    return Vehicle::getLateralLanePosition(id);
  }
  std::string route_id(const std::string& id) const override { return Vehicle::getRouteID(id); }
  std::vector<std::string> route(const std::string& id) const override {
    return Vehicle::getRoute(id);
  }
  int route_index(const std::string& id) const override { return Vehicle::getRouteIndex(id); }
  std::vector<std::string> lanes_ahead(const std::string& id) const override {
    const auto lanes = Vehicle::getBestLanes(id);
    const auto own =
        std::ranges::find(lanes, Vehicle::getLaneID(id), &libsumo::TraCIBestLanesData::laneID);
    if (own == lanes.end()) return {};
    if (own->allowsContinuation) return own->continuationLanes;
    const auto needed = own - lanes.begin() + own->bestLaneOffset;
    if (needed < 0 || needed >= std::ssize(lanes)) return {};
    return lanes[static_cast<std::size_t>(needed)].continuationLanes;
  }
  bool is_at_stop(const std::string& id) const override {
    return (Vehicle::getStopState(id) & 1) != 0;
  }
  bool is_parked(const std::string& id) const override {
    return (Vehicle::getStopState(id) & 2) != 0;
  }
  double length(const std::string& id) const override { return Vehicle::getLength(id); }

  void read_body(const std::string& id, VehicleTraits& traits) const override {
    traits.length = Vehicle::getLength(id);
    traits.width = Vehicle::getWidth(id);
    traits.decel = Vehicle::getDecel(id);
    traits.emergency_decel = std::max(traits.decel, Vehicle::getEmergencyDecel(id));
    traits.accel = Vehicle::getAccel(id);
    traits.min_gap = Vehicle::getMinGap(id);
    traits.parts = parts_of(Vehicle::getShapeClass(id), Vehicle::getVehicleClass(id), traits.length,
                            carriage_lengths(id));
    if (!motion_) motion_ = read_motion();
    traits.ballistic = motion_->ballistic;
    traits.drifts = motion_->drifts;
    traits.sublanes = motion_->sublanes;
  }

  std::string type(const std::string& id) const override { return Vehicle::getTypeID(id); }

  std::string parameter(const std::string& id, const std::string& key) const override {
    const std::string own = Vehicle::getParameter(id, key);
    return own.empty() ? api::VehicleType::getParameter(Vehicle::getTypeID(id), key) : own;
  }

  void set_braking(const std::string& id, double decel, double emergency_decel) override {
    // SUMO warns of one that is less than the other, at any time.
    const bool lower = emergency_decel < Vehicle::getDecel(id);
    if (lower) Vehicle::setDecel(id, decel);
    Vehicle::setEmergencyDecel(id, emergency_decel);
    if (!lower) Vehicle::setDecel(id, decel);
  }

  SafeSpeeds safe_speeds() const override {
    return {[](const FleetVehicle& vehicle, double gap) {
              return Vehicle::getStopSpeed(vehicle.id, vehicle.speed, gap);
            },
            [](const FleetVehicle& vehicle, double gap, double speed) {
              return Vehicle::getFollowSpeed(vehicle.id, vehicle.speed, gap, speed, kPersonDecel);
            }};
  }

  void send(const std::vector<SpeedOrder>& orders) override {
    for (const SpeedOrder& order : orders) {
      if (const auto* mode = std::get_if<SpeedMode>(&order.what)) {
        set_speed_mode(order.vehicle, *mode);
      } else if (const auto* changes = std::get_if<LaneChanges>(&order.what)) {
        set_lane_changes(order.vehicle, *changes);
      } else {
        Vehicle::setSpeed(order.vehicle, std::get<double>(order.what));
        act_now(order.vehicle);
      }
    }
  }

  void send(const std::vector<SteerOrder>& orders) override {
    for (const SteerOrder& order : orders) {
      if (order.place) {
        const auto& [front, heading] = *order.place;
        Vehicle::moveToXY(order.vehicle, "", -1, front.x(), front.y(), sumo_from_radians(heading),
                          kExactPlace, kLaneReach);
      } else {
        Vehicle::remove(order.vehicle, libsumo::REMOVE_ARRIVED);
      }
    }
  }

  void forget(const std::string& id) override {
    action_steps_.erase(id);
    own_lane_changes_.erase(id);
    own_speed_modes_.erase(id);
  }

 private:
  /// How SUMO moves vehicles.
  struct Motion {
    bool ballistic, drifts, sublanes;
  };
  static Motion read_motion() {
    const auto number = [](const char* option) {
      return std::strtod(api::Simulation::getOption(option).c_str(), nullptr);
    };
    const bool sublanes = number("lateral-resolution") > 0.0;
    return {is_true(api::Simulation::getOption("step-method.ballistic")),
            !sublanes && number("lanechange.duration") > 0.0, sublanes};
  }

  /// As its type's parameters have them.
  CarriageLengths carriage_lengths(const std::string& id) const {
    const auto length = [&](const char* key) -> std::optional<double> {
      const std::string value = parameter(id, key);
      return value.empty() ? std::nullopt : std::optional(std::strtod(value.c_str(), nullptr));
    };
    return {length("locomotiveLength"), length("carriageLength"), length("carriageGap")};
  }

  /// A vehicle whose driver acts more seldom than SUMO steps (actionStepLength) keeps its
  /// acceleration meanwhile: told once to brake, and then to drive on, it would brake on. The
  /// pattern of its acts begins anew with the next step.
  void act_now(const std::string& id) {
    const double length = action_step(id);
    if (length > 0.0) Vehicle::setActionStepLength(id, length, true);
  }

  /// [s] 0: it acts in every step.
  double action_step(const std::string& id) {
    const auto [known, is_new] = action_steps_.try_emplace(id, 0.0);
    if (is_new) {
      const double length = Vehicle::getActionStepLength(id);
      if (length > api::Simulation::getDeltaT()) known->second = length;
    }
    return known->second;
  }

  void set_lane_changes(const std::string& id, LaneChanges changes) {
    if (changes == LaneChanges::kNone) {
      own_lane_changes_.try_emplace(id, Vehicle::getLaneChangeMode(id));
      Vehicle::setLaneChangeMode(id, kNoLaneChange);
    } else if (const auto own = own_lane_changes_.extract(id)) {
      try {
        Vehicle::setLaneChangeMode(id, own.mapped());
      } catch (const libsumo::TraCIException&) {  // it has left the simulation
      }
    }
  }

  void set_speed_mode(const std::string& id, SpeedMode mode) {
    if (mode != SpeedMode::kOwn) {
      own_speed_modes_.try_emplace(id, Vehicle::getSpeedMode(id));
      Vehicle::setSpeedMode(id, static_cast<int>(mode));
    } else if (const auto own = own_speed_modes_.extract(id)) {
      Vehicle::setSpeedMode(id, own.mapped());
    }
  }

  std::unordered_map<std::string, double> action_steps_;  // [s]
  mutable std::optional<Motion> motion_;                  // nobody can change it
  // What clients had set before pedzone told them otherwise.
  std::unordered_map<std::string, int> own_lane_changes_, own_speed_modes_;
};

}  // namespace

std::unique_ptr<SumoVehicles> vehicle_calls() { return std::make_unique<VehicleCalls>(); }

}  // namespace pedzone::PEDZONE_CALLS
