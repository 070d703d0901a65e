#include "sumo/live/fleet.hpp"

#include <algorithm>

#include "core/random.hpp"
#include "sumo/files/frames.hpp"
#include "sumo/live/api.hpp"

namespace pedzone {
namespace {

constexpr double kNear = 60.0;  // [m] numerical: vehicles farther from every zone are not read on
constexpr double kLookAhead = 30.0;     // [m] numerical: least length of the way that is built
constexpr double kStandingSpeed = 0.5;  // [m/s] numerical: slower vehicles wait
constexpr double kMoved = 0.01;  // [m] numerical: less than this in a step gives no direction

bool is_true(const std::string& text) { return text == "true" || text == "1" || text == "yes"; }
bool is_false(const std::string& text) { return text == "false" || text == "0" || text == "no"; }

/// A vehicle's parameter, else its type's.
std::string parameter(const std::string& id, const std::string& key) {
  const std::string own = api::Vehicle::getParameter(id, key);
  return own.empty() ? api::VehicleType::getParameter(api::Vehicle::getTypeID(id), key) : own;
}

void append_from(const Polyline& line, double offset, double lateral, double& left, Polyline& out) {
  double passed = 0.0;
  for (std::size_t i = 1; i < line.size() && left > 0.0; ++i) {
    const Vec2 piece = line[i] - line[i - 1];
    const double length = piece.norm();
    if (length <= 0.0) continue;
    if (passed + length > offset) {
      const double begin = std::max(0.0, offset - passed);
      const double taken = std::min(left, length - begin);
      out.push_back(line[i - 1] + piece * ((begin + taken) / length) +
                    left_of(piece / length) * lateral);
      left -= taken;
    }
    passed += length;
  }
}

}  // namespace

double Body::distance(const Vec2& point) const {
  const Vec2 to = point - centre;
  const double along = std::abs(to.dot(axis)) - half_length;
  const double across = std::abs(cross(axis, to)) - half_width;
  if (along <= 0.0 && across <= 0.0) return std::max(along, across);
  return std::hypot(std::max(along, 0.0), std::max(across, 0.0));
}

Body body_of(const FleetVehicle& vehicle) {
  return {vehicle.centre(), unit(vehicle.heading), 0.5 * vehicle.traits.length,
          0.5 * vehicle.traits.width};
}

Body body_after(const FleetVehicle& vehicle, double travelled) {
  if (vehicle.way.size() < 2 || travelled <= 0.0) return body_of(vehicle);
  const Vec2 rear = point_on(vehicle.way, travelled).point;
  const Vec2 front = point_on(vehicle.way, travelled + vehicle.traits.length).point;
  const Vec2 along = front - rear;
  const double chord = along.norm();
  const Vec2 axis = chord > 0.1 ? Vec2(along / chord) : unit(vehicle.heading);
  return {front - axis * (0.5 * vehicle.traits.length), axis, 0.5 * vehicle.traits.length,
          0.5 * vehicle.traits.width};
}

Fleet::Fleet(const Network& network, const std::vector<Zone>& zones)
    : network_(network), zone_of_lane_(network.lanes.size(), -1) {
  for (std::size_t z = 0; z < zones.size(); ++z) {
    const Zone& zone = zones[z];
    grip_ = std::min(grip_, zone.weather->deceleration);
    for (const int lane : zone.lanes) zone_of_lane_[lane] = static_cast<int>(z);
    Vec2 low(1e18, 1e18), high(-1e18, -1e18);
    for (const Polygon& polygon : zone.walkable) {
      for (const Vec2& point : polygon.outer) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
      }
    }
    boxes_.emplace_back(low - Vec2(kNear, kNear), high + Vec2(kNear, kNear));
  }
  connections_from_.resize(network.lanes.size());
  for (std::size_t i = 0; i < network.connections.size(); ++i) {
    connections_from_[network.connections[i].from].push_back(static_cast<int>(i));
  }
}

bool Fleet::near_zone(const Vec2& point) const {
  return std::any_of(boxes_.begin(), boxes_.end(), [&](const auto& box) {
    return (point.array() >= box.first.array()).all() &&
           (point.array() <= box.second.array()).all();
  });
}

/// On a slippery road neither SUMO nor we may brake as on a dry one.
void Fleet::reduce_braking(const std::string& id, VehicleTraits& traits) const {
  traits.decel *= grip_;
  traits.emergency_decel *= grip_;
  api::Vehicle::setEmergencyDecel(id, traits.emergency_decel);
  api::Vehicle::setDecel(id, traits.decel);
}

const VehicleTraits& Fleet::traits(const std::string& id) {
  const auto [entry, is_new] = traits_.try_emplace(id);
  VehicleTraits& traits = entry->second;
  if (is_new) {
    traits.length = api::Vehicle::getLength(id);
    traits.width = api::Vehicle::getWidth(id);
    traits.decel = api::Vehicle::getDecel(id);
    traits.emergency_decel = std::max(traits.decel, api::Vehicle::getEmergencyDecel(id));
    traits.accel = api::Vehicle::getAccel(id);
    if (grip_ < 1.0) reduce_braking(id, traits);
    traits.yields = !is_false(parameter(id, "pedzone.yield"));
    traits.external = is_true(parameter(id, "pedzone.external"));
    traits.electric = is_true(parameter(id, "pedzone.electric"));
  }
  return traits;
}

const std::vector<int>& Fleet::route(const std::string& id) {
  const auto [entry, is_new] = routes_.try_emplace(api::Vehicle::getRouteID(id));
  if (is_new) {
    for (const std::string& edge : api::Vehicle::getRoute(id)) {
      const auto found = network_.edge_index.find(edge);
      entry->second.push_back(found == network_.edge_index.end() ? -1 : found->second);
    }
  }
  return entry->second;
}

/// The lane after `lane` on the way along `route`, of which route[index] is the edge last reached;
/// -1 at the end. A lane that does not lead on stands for a lane change: its neighbour's way.
int Fleet::next_lane(int lane, const std::vector<int>& route, int& index) const {
  if (index + 1 >= static_cast<int>(route.size())) return -1;
  const int goal = route[index + 1];
  const auto leading = [&](int from) {
    for (const int i : connections_from_[from]) {
      const Connection& connection = network_.connections[i];
      if (network_.lanes[connection.to].edge != goal) continue;
      if (connection.via >= 0) return connection.via;
      ++index;
      return connection.to;
    }
    return -1;
  };
  const int direct = leading(lane);
  if (direct >= 0) return direct;
  for (const int other : network_.edges[network_.lanes[lane].edge].lanes) {
    const int around = other == lane ? -1 : leading(other);
    if (around >= 0) return around;
  }
  return -1;
}

void Fleet::look_ahead(FleetVehicle& vehicle, double distance) {
  Polyline& way = vehicle.way;
  way = {vehicle.front - unit(vehicle.heading) * vehicle.traits.length, vehicle.front};
  const auto found = network_.lane_index.find(api::Vehicle::getLaneID(vehicle.id));
  if (found == network_.lane_index.end()) {
    way.push_back(vehicle.front + unit(vehicle.heading) * distance);
    return;
  }
  int lane = found->second;
  int index = api::Vehicle::getRouteIndex(vehicle.id);
  int zone = -1;
  const std::vector<int>& edges = route(vehicle.id);
  const double lateral = api::Vehicle::getLateralLanePosition(vehicle.id);
  double offset = project_on(network_.lanes[lane].shape, vehicle.front).offset;
  double left = distance;
  while (lane >= 0 && left > 0.0) {
    append_from(network_.lanes[lane].shape, offset, lateral, left, way);
    if (zone < 0) zone = zone_of_lane_[lane];
    offset = 0.0;
    lane = next_lane(lane, edges, index);
  }
  vehicle.zone = std::max(0, zone);
}

void Fleet::read(double dt) {
  std::swap(vehicles_, previous_);
  vehicles_.clear();
  previous_index_.clear();
  for (std::size_t i = 0; i < previous_.size(); ++i) previous_index_[previous_[i].id] = i;
  for (const std::string& id : api::Vehicle::getIDList()) {
    const auto position = api::Vehicle::getPosition(id);
    if (!near_zone({position.x, position.y})) continue;  // also INVALID while teleporting
    FleetVehicle vehicle;
    vehicle.id = id;
    vehicle.traits = traits(id);
    vehicle.front = {position.x, position.y};
    vehicle.heading = radians_from_sumo(api::Vehicle::getAngle(id));
    vehicle.speed = std::max(0.0, api::Vehicle::getSpeed(id));
    vehicle.allowed_speed = api::Vehicle::getAllowedSpeed(id);
    vehicle.horn = is_true(parameter(id, "pedzone.horn"));
    vehicle.invites = parameter(id, "pedzone.signal") == "after-you";
    vehicle.stopped = (api::Vehicle::getStopState(id) & 1) != 0;
    vehicle.velocity = unit(vehicle.heading) * vehicle.speed;
    const auto before = previous_index_.find(id);
    if (before != previous_index_.end()) {
      const FleetVehicle& old = previous_[before->second];
      vehicle.held_up = old.held_up;
      vehicle.creeping = old.creeping;
      vehicle.slowed = old.slowed;
      vehicle.commanded = old.commanded;
      const Vec2 moved = vehicle.centre() - old.centre();
      if (dt > 0.0 && moved.norm() > kMoved) vehicle.velocity = moved.normalized() * vehicle.speed;
    }
    const double braking = vehicle.speed * vehicle.speed / (2.0 * vehicle.traits.decel);
    look_ahead(vehicle, braking + kLookAhead);
    vehicles_.push_back(std::move(vehicle));
  }
}

void Fleet::states(double dt, std::vector<VehicleState>& out) const {
  out.clear();
  for (const FleetVehicle& vehicle : vehicles_) {
    VehicleState state;
    state.centre = vehicle.centre();
    state.heading = vehicle.heading;
    state.length = vehicle.traits.length;
    state.width = vehicle.traits.width;
    state.claim = vehicle.claim;
    state.way = vehicle.way;
    const bool ahead = vehicle.velocity.dot(unit(vehicle.heading)) >= -1e-9;
    if (vehicle.traits.external || !ahead || vehicle.way.size() < 3 || dt <= 0.0) {
      state.velocity = vehicle.velocity;
      state.yaw_rate = vehicle.yaw_rate;
    } else {
      double next = std::min(vehicle.speed + vehicle.traits.accel * dt,
                             std::max(vehicle.allowed_speed, vehicle.speed));
      if (vehicle.stopped) next = 0.0;
      if (vehicle.commanded >= 0.0) next = std::min(next, vehicle.commanded);
      const Body body = body_after(vehicle, next * dt);
      state.velocity = (body.centre - state.centre) / dt;
      state.yaw_rate = wrap_angle(angle_of(body.axis) - vehicle.heading) / dt;
    }
    state.key = person_key(vehicle.id);
    state.electric = vehicle.traits.electric;
    state.horn = vehicle.horn;
    state.invites = vehicle.invites;
    out.push_back(state);
  }
}

bool Fleet::touches(const Vec2& point, double radius) const {
  return std::any_of(vehicles_.begin(), vehicles_.end(), [&](const FleetVehicle& vehicle) {
    return body_of(vehicle).distance(point) < radius;
  });
}

bool Fleet::approaches(const Vec2& point, double margin, double horizon) const {
  constexpr double kStep = 1.0;  // [m] numerical: sampling of the swept area
  for (const FleetVehicle& vehicle : vehicles_) {
    if (vehicle.speed < kStandingSpeed) continue;
    const double reach = vehicle.speed * horizon;
    if ((point - vehicle.front).norm() > reach + vehicle.traits.length + margin) continue;
    for (double travelled = 0.0; travelled <= reach; travelled += kStep) {
      if (body_after(vehicle, travelled).distance(point) < margin) return true;
    }
  }
  return false;
}

const FleetVehicle* Fleet::waiting_beside(const Vec2& point, double margin) const {
  const auto found =
      std::find_if(vehicles_.begin(), vehicles_.end(), [&](const FleetVehicle& vehicle) {
        return vehicle.speed < kStandingSpeed && !vehicle.stopped &&
               body_of(vehicle).distance(point) < margin;
      });
  return found == vehicles_.end() ? nullptr : &*found;
}

}  // namespace pedzone
