#include "sumo/live/vehicle_reader.hpp"

#include <cmath>

#include "geometry/polyline.hpp"
#include "sumo/files/truth.hpp"
#include "sumo/plan/zone_route.hpp"

namespace pedzone {
namespace {

constexpr double kAskAgain = 1.0;       // [s] numerical: each question is a message to SUMO
constexpr double kLong = 50.0;          // [m] numerical: a shorter one is out of all zones when its
                                        // front is no longer near them
constexpr char kOfOne = '@';            // in SUMO's name for it: TYPE@VEHICLE
constexpr double kForksWithin = 100.0;  // [m] numerical: farther away nobody minds it

/// [m] to the left of the lane's middle. SUMO counts to the right where vehicles drive on the left.
double to_the_left(double lateral, const Lane& lane, const Vec2& front) {
  return lateral == 0.0 ? 0.0 : std::copysign(lateral, project_on(lane.shape, front).lateral);
}

/// Whether the route that is known of it cannot be the one that it takes: it has got another one
/// under the same id.
bool is_elsewhere(const Network& network, const VehicleSeen& vehicle) {
  const int edge = network.lanes[vehicle.lane].edge;
  if (network.edges[edge].function != EdgeFunction::kNormal) return false;
  const auto index = static_cast<std::size_t>(vehicle.route_index);
  return index >= vehicle.route.size() ||
         (vehicle.route[index] != edge && network.lanes[vehicle.lane].opposite < 0);
}

/// Whether the lane on which SUMO has it is not one of the edge that its route has come to, but
/// beside that, for the other direction.
bool overtakes_on_opposite(const Network& network, const VehicleSeen& vehicle) {
  const Lane& lane = network.lanes[vehicle.lane];
  const auto index = static_cast<std::size_t>(vehicle.route_index);
  if (lane.opposite < 0 || index >= vehicle.route.size()) return false;
  return network.lanes[lane.opposite].edge == vehicle.route[index];
}

}  // namespace

/// What its type says of it: when it is new, and when a program has given it another type. A change
/// of one vehicle's size or brakes makes it a type of its own in SUMO: that one is read again
/// whenever `again`.
void VehicleReader::ask_type(const std::string& id, double grip, bool again, Known& known) const {
  std::string type = sumo_.type(id);
  const bool is_new = known.type.empty();
  const bool its_own = type.find(kOfOne) != std::string::npos;
  if (type == known.type && !(again && its_own)) return;
  known.type = std::move(type);
  VehicleTraits& traits = known.traits;
  sumo_.read_body(id, traits);
  if (grip < 1.0 && (is_new || !its_own)) {
    // On a slippery road neither SUMO nor we may brake as on a dry one.
    traits.decel *= grip;
    traits.emergency_decel *= grip;
    sumo_.set_braking(id, traits.decel, traits.emergency_decel);
  }
  traits.electric = is_true(sumo_.parameter(id, "pedzone.electric"));
}

bool VehicleReader::is_near(const Fleet& fleet, const std::string& id, const Vec2& front) const {
  if (fleet.near_zone(front)) return true;
  const auto known = known_.find(id);
  if (known == known_.end() || known->second.traits.length < kLong) return false;
  const Vec2 rear = front - unit(sumo_.heading(id)) * known->second.traits.length;
  return fleet.near_zone(front, rear);
}

/// Which lanes it will take matters only where its lane leads onto several of the next edge.
void VehicleReader::ask_lanes(const VehicleSeen& vehicle, bool again, Known& known) const {
  if (!again && known.lane == vehicle.lane) return;
  known.lane = vehicle.lane;
  if (!forks_.ahead(vehicle.route, vehicle.route_index, kForksWithin)) {
    known.means.clear();
    return;
  }
  const std::vector<std::string> lanes = sumo_.lanes_ahead(vehicle.id);
  if (lanes.empty()) return;  // inside a junction what it was before holds
  known.means.clear();
  for (const std::string& lane : lanes) {
    const auto found = network_.lane_index.find(lane);
    if (found != network_.lane_index.end()) known.means.push_back(found->second);
  }
}

/// Other programs declare a vehicle when it is there already, and give it other routes.
void VehicleReader::ask(const std::string& id, double time, Known& known) const {
  if (time >= known.ask_at) {
    known.ask_at = time + kAskAgain;
    known.traits.yields = !is_false(sumo_.parameter(id, "pedzone.yield"));
    known.traits.external = is_true(sumo_.parameter(id, "pedzone.external"));
  }
  const std::string route = sumo_.route_id(id);
  if (known.route_id.empty()) known.taxi = is_true(sumo_.parameter(id, "has.taxi.device"));
  if (route == known.route_id && !known.taxi) return;
  known.route_id = route;
  ask_route(id, known);
}

void VehicleReader::ask_route(const std::string& id, Known& known) const {
  known.route = edge_indices(network_, sumo_.route(id));
}

std::vector<VehicleSeen> VehicleReader::read(const Fleet& fleet, const Told& told, double time) {
  std::vector<VehicleSeen> seen;
  for (const std::string& id : sumo_.ids()) {
    const auto front = sumo_.front(id);
    if (!front || !(is_near(fleet, id, *front) || told.speed(id))) continue;
    auto found = known_.find(id);
    if (found == known_.end()) found = known_.emplace(id, Known{}).first;
    Known& known = found->second;
    const bool again = time >= known.ask_at;
    ask_type(id, fleet.grip(), again, known);
    ask(id, time, known);
    VehicleSeen vehicle;
    vehicle.id = id;
    vehicle.traits = known.traits;
    vehicle.front = *front;
    vehicle.heading = sumo_.heading(id);
    vehicle.speed = sumo_.speed(id);
    vehicle.own_speed = sumo_.own_speed(id);
    vehicle.allowed_speed = sumo_.allowed_speed(id);
    vehicle.time_loss = sumo_.time_loss(id);
    vehicle.horn = is_true(sumo_.parameter(id, "pedzone.horn"));
    vehicle.invites = sumo_.parameter(id, "pedzone.signal") == "after-you";
    vehicle.stopped = sumo_.is_at_stop(id);
    vehicle.parks = vehicle.stopped && sumo_.is_parked(id);
    const auto lane = network_.lane_index.find(sumo_.lane(id));
    if (lane != network_.lane_index.end()) {
      vehicle.lane = lane->second;
      vehicle.lateral = to_the_left(sumo_.lateral(id), network_.lanes[vehicle.lane], *front);
      vehicle.route_index = sumo_.route_index(id);
      vehicle.route = known.route;
      if (is_elsewhere(network_, vehicle)) {
        ask_route(id, known);
        vehicle.route = known.route;
      }
      if (overtakes_on_opposite(network_, vehicle)) {
        vehicle.overtakes = true;
        vehicle.lane = network_.lanes[vehicle.lane].opposite;
        vehicle.lateral = project_on(network_.lanes[vehicle.lane].shape, *front).lateral;
      }
      ask_lanes(vehicle, again, known);
      vehicle.means = known.means;
    }
    seen.push_back(std::move(vehicle));
  }
  return seen;
}

}  // namespace pedzone
