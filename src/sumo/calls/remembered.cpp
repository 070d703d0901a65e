#include "sumo/calls/remembered.hpp"

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "sumo/calls/move_batch.hpp"
#include "sumo/calls/session.hpp"
#include "sumo/calls/wire.hpp"

namespace pedzone::remembered {
namespace {

using libsumo::TraCIDouble;
using libsumo::TraCIInt;
using libsumo::TraCIPosition;
using libsumo::TraCIResults;
using libsumo::TraCIString;
using libsumo::TraCIStringList;
using Variables = std::vector<int>;

constexpr double kLapse = 20.0;  // [s] numerical: renewing costs a message

// What is asked for together is subscribed to together.
const Variables kPlace{libsumo::VAR_POSITION};
const Variables kPlan{libsumo::VAR_STAGES_REMAINING, libsumo::VAR_MAXSPEED,
                      libsumo::VAR_SPEED_FACTOR, libsumo::VAR_TYPE};
const Variables kWalker{libsumo::VAR_ANGLE, libsumo::VAR_SPEED, libsumo::VAR_ROAD_ID,
                        libsumo::VAR_VEHICLE};
const Variables kDriver{libsumo::VAR_SPEED_WITHOUT_TRACI,
                        libsumo::VAR_ANGLE,
                        libsumo::VAR_SPEED,
                        libsumo::VAR_TIMELOSS,
                        libsumo::VAR_ALLOWED_SPEED,
                        libsumo::VAR_LANE_ID,
                        libsumo::VAR_LANEPOSITION_LAT,
                        libsumo::VAR_ROUTE_ID,
                        libsumo::VAR_ROUTE_INDEX,
                        libsumo::VAR_STOPSTATE,
                        libsumo::VAR_TYPE};
const Variables kCounts{libsumo::VAR_TIME,
                        libsumo::VAR_MIN_EXPECTED_VEHICLES,
                        libsumo::VAR_DEPARTED_PERSONS_NUMBER,
                        libsumo::VAR_ARRIVED_PERSONS_NUMBER,
                        libsumo::VAR_TELEPORT_STARTING_VEHICLES_NUMBER,
                        libsumo::VAR_TELEPORT_ENDING_VEHICLES_IDS,
                        libsumo::VAR_EMERGENCYSTOPPING_VEHICLES_NUMBER,
                        libsumo::VAR_COLLIDING_VEHICLES_IDS,
                        libsumo::VAR_DEPARTED_VEHICLES_IDS,
                        libsumo::VAR_ARRIVED_VEHICLES_IDS,
                        libsumo::VAR_PENDING_VEHICLES};

/// What SUMO has sent of a kind of object with its last step.
template <typename Domain>
class Received {
 public:
  void refresh() { of_ = Domain::getAllSubscriptionResults(); }

  /// A variable of `id`, of type Value. Subscribes to `together` where it has not come.
  template <typename Value>
  const Value& get(const std::string& id, int variable, const Variables& together) {
    TraCIResults& known = of_[id];
    auto found = known.find(variable);
    if (found == known.end()) {
      const double now = libtraci::Simulation::getTime();
      Domain::subscribe(id, together, now, now + kLapse);
      known = Domain::getSubscriptionResults(id);
      found = known.find(variable);
    }
    const Value* value =
        found == known.end() ? nullptr : dynamic_cast<const Value*>(found->second.get());
    if (value == nullptr) throw libsumo::TraCIException("SUMO did not tell of '" + id + "'");
    return *value;
  }

 private:
  libsumo::SubscriptionResults of_;
};

DesiredSpeeds desired_speeds;
MoveBatch moves;
Received<libtraci::Person> persons;
Received<libtraci::Vehicle> vehicles;
TraCIResults counts;
std::unordered_map<std::string, double> lengths, widths;       // [m] of persons, by type
std::unordered_map<std::string, std::string> type_parameters;  // by type and key

/// What SUMO counts, of type Value.
template <typename Value = TraCIInt>
const auto& count(int variable) {
  if (counts.empty()) {
    libtraci::Simulation::subscribe(kCounts);
    counts = libtraci::Simulation::getSubscriptionResults();
  }
  return dynamic_cast<const Value&>(*counts.at(variable)).value;
}

const std::string& type_of(const std::string& person) {
  return persons.get<TraCIString>(person, libsumo::VAR_TYPE, kPlan).value;
}

template <typename Map, typename Ask>
const auto& once(Map& map, const std::string& key, Ask ask) {
  const auto found = map.find(key);
  return found != map.end() ? found->second : map.emplace(key, ask()).first->second;
}

}  // namespace

void know(const DesiredSpeeds& speeds) { desired_speeds = speeds; }

TraCIPosition Person::getPosition(const std::string& id) {
  return persons.get<TraCIPosition>(id, libsumo::VAR_POSITION, kPlace);
}
double Person::getAngle(const std::string& id) {
  return persons.get<TraCIDouble>(id, libsumo::VAR_ANGLE, kWalker).value;
}
double Person::getSpeed(const std::string& id) {
  return persons.get<TraCIDouble>(id, libsumo::VAR_SPEED, kWalker).value;
}
std::string Person::getRoadID(const std::string& id) {
  return persons.get<TraCIString>(id, libsumo::VAR_ROAD_ID, kWalker).value;
}
std::string Person::getVehicle(const std::string& id) {
  return persons.get<TraCIString>(id, libsumo::VAR_VEHICLE, kWalker).value;
}
int Person::getRemainingStages(const std::string& id) {
  return persons.get<TraCIInt>(id, libsumo::VAR_STAGES_REMAINING, kPlan).value;
}
void Person::moveToXY(const std::string& id, const std::string& edge, double x, double y,
                      double angle, int keep_route, double match_threshold) {
  if (has_wire()) {
    moves.add(id, x, y, angle, keep_route, match_threshold);
  } else {
    libtraci::Person::moveToXY(id, edge, x, y, angle, keep_route, match_threshold);
  }
}
double Person::getMaxSpeed(const std::string& id) {
  const auto number = [&](int variable) {
    return persons.get<TraCIDouble>(id, variable, kPlan).value;
  };
  return std::min(number(libsumo::VAR_MAXSPEED),
                  desired_speeds.of_type(type_of(id)) * number(libsumo::VAR_SPEED_FACTOR));
}
double Person::getLength(const std::string& id) {
  return once(lengths, type_of(id), [&] { return libtraci::Person::getLength(id); });
}
double Person::getWidth(const std::string& id) {
  return once(widths, type_of(id), [&] { return libtraci::Person::getWidth(id); });
}

TraCIPosition Vehicle::getPosition(const std::string& id) {
  return vehicles.get<TraCIPosition>(id, libsumo::VAR_POSITION, kPlace);
}
double Vehicle::getAngle(const std::string& id) {
  return vehicles.get<TraCIDouble>(id, libsumo::VAR_ANGLE, kDriver).value;
}
double Vehicle::getSpeed(const std::string& id) {
  return vehicles.get<TraCIDouble>(id, libsumo::VAR_SPEED, kDriver).value;
}
double Vehicle::getSpeedWithoutTraCI(const std::string& id) {
  return vehicles.get<TraCIDouble>(id, libsumo::VAR_SPEED_WITHOUT_TRACI, kDriver).value;
}
double Vehicle::getAllowedSpeed(const std::string& id) {
  return vehicles.get<TraCIDouble>(id, libsumo::VAR_ALLOWED_SPEED, kDriver).value;
}
double Vehicle::getTimeLoss(const std::string& id) {
  return vehicles.get<TraCIDouble>(id, libsumo::VAR_TIMELOSS, kDriver).value;
}
std::string Vehicle::getLaneID(const std::string& id) {
  return vehicles.get<TraCIString>(id, libsumo::VAR_LANE_ID, kDriver).value;
}
std::string Vehicle::getRouteID(const std::string& id) {
  return vehicles.get<TraCIString>(id, libsumo::VAR_ROUTE_ID, kDriver).value;
}
double Vehicle::getLateralLanePosition(const std::string& id) {
  return vehicles.get<TraCIDouble>(id, libsumo::VAR_LANEPOSITION_LAT, kDriver).value;
}
int Vehicle::getRouteIndex(const std::string& id) {
  return vehicles.get<TraCIInt>(id, libsumo::VAR_ROUTE_INDEX, kDriver).value;
}
int Vehicle::getStopState(const std::string& id) {
  return vehicles.get<TraCIInt>(id, libsumo::VAR_STOPSTATE, kDriver).value;
}
std::string Vehicle::getTypeID(const std::string& id) {
  return vehicles.get<TraCIString>(id, libsumo::VAR_TYPE, kDriver).value;
}

std::string VehicleType::getParameter(const std::string& id, const std::string& key) {
  return once(type_parameters, id + '\n' + key,
              [&] { return libtraci::VehicleType::getParameter(id, key); });
}

/// SUMO tells with the step that it cannot tell of a vehicle that another client has removed: the
/// rest is then asked for anew. Whatever else goes wrong here, SUMO is there no more.
void Simulation::step() {
  try {
    if (!moves.empty()) moves.send();
  } catch (const libsumo::TraCIException&) {
    throw;
  } catch (const std::exception& error) {
    throw ConnectionLost(error.what());
  }
  try {
    libtraci::Simulation::step();
  } catch (const libsumo::TraCIException&) {
  } catch (const std::exception& error) {
    throw ConnectionLost(error.what());
  }
  persons.refresh();
  vehicles.refresh();
  counts = libtraci::Simulation::getSubscriptionResults();
}
double Simulation::getTime() { return count<TraCIDouble>(libsumo::VAR_TIME); }
int Simulation::getMinExpectedNumber() { return count(libsumo::VAR_MIN_EXPECTED_VEHICLES); }
int Simulation::getDepartedPersonNumber() { return count(libsumo::VAR_DEPARTED_PERSONS_NUMBER); }
int Simulation::getArrivedPersonNumber() { return count(libsumo::VAR_ARRIVED_PERSONS_NUMBER); }
int Simulation::getStartingTeleportNumber() {
  return count(libsumo::VAR_TELEPORT_STARTING_VEHICLES_NUMBER);
}
int Simulation::getEmergencyStoppingVehiclesNumber() {
  return count(libsumo::VAR_EMERGENCYSTOPPING_VEHICLES_NUMBER);
}
std::vector<libsumo::TraCICollision> Simulation::getCollisions() {
  const auto& ids = count<TraCIStringList>(libsumo::VAR_COLLIDING_VEHICLES_IDS);
  std::vector<libsumo::TraCICollision> collisions;
  for (std::size_t k = 0; k + 1 < ids.size(); k += 2) {
    collisions.emplace_back();
    collisions.back().collider = ids[k];
    collisions.back().victim = ids[k + 1];
  }
  return collisions;
}
std::vector<std::string> Simulation::getDepartedIDList() {
  return count<TraCIStringList>(libsumo::VAR_DEPARTED_VEHICLES_IDS);
}
std::vector<std::string> Simulation::getArrivedIDList() {
  return count<TraCIStringList>(libsumo::VAR_ARRIVED_VEHICLES_IDS);
}
std::vector<std::string> Simulation::getEndingTeleportIDList() {
  return count<TraCIStringList>(libsumo::VAR_TELEPORT_ENDING_VEHICLES_IDS);
}
std::vector<std::string> Simulation::getPendingVehicles() {
  return count<TraCIStringList>(libsumo::VAR_PENDING_VEHICLES);
}

}  // namespace pedzone::remembered
