#include "sumo/live/steering.hpp"

#include <algorithm>

#include "core/xml_stream.hpp"
#include "sumo/files/frames.hpp"
#include "sumo/live/api.hpp"

namespace pedzone {
namespace {

constexpr int kExactPlace = 2;        // SUMO's keepRoute: anywhere, on a lane or not
constexpr double kLaneReach = 100.0;  // [m] SUMO's default: so near it looks for a lane
constexpr double kSeenAhead = 30.0;   // [m] as of other vehicles (fleet.cpp)

InputError path_error(const VehiclePath& path, const std::string& problem,
                      const std::string& allowed) {
  return InputError(
      problem, {path.file, path.line, "<vehiclePath> attribute vehicle", path.vehicle(), allowed});
}

/// Whether "flow.12" is of the flow.
bool is_of_flow(std::string_view vehicle, std::string_view flow) {
  if (!vehicle.starts_with(flow) || vehicle.size() < flow.size() + 2) return false;
  const std::string_view number = vehicle.substr(flow.size() + 1);
  return vehicle[flow.size()] == '.' &&
         number.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Whether the element makes the vehicle.
bool makes(const XmlElement& element, std::string_view vehicle) {
  const auto id = element.value("id");
  if (!id) return false;
  if (element.name() == "flow") return is_of_flow(vehicle, *id);
  return (element.name() == "vehicle" || element.name() == "trip") && *id == vehicle;
}

void require_vehicles(const Scenario& scenario, const std::vector<VehiclePath>& paths) {
  if (paths.empty()) return;
  std::vector<bool> known(paths.size(), false);
  for (const auto* files : {&scenario.route_files, &scenario.additional_files}) {
    for (const std::string& file : *files) {
      visit_elements(file, "", [&](const XmlElement& element) {
        for (std::size_t k = 0; k < paths.size(); ++k) {
          if (makes(element, paths[k].vehicle())) known[k] = true;
        }
      });
    }
  }
  const auto unknown = std::ranges::find(known, false);
  if (unknown == known.end()) return;
  throw path_error(paths[static_cast<std::size_t>(unknown - known.begin())],
                   "is no vehicle of the scenario",
                   "ids of vehicles in its route and additional files");
}

Vec2 centre(const VehiclePath& path, double time, double length) {
  return path.front(time) - 0.5 * length * unit(path.heading(time, length));
}

}  // namespace

Steering::Steering(const Scenario& scenario, std::vector<VehiclePath> paths)
    : paths_(std::move(paths)) {
  require_vehicles(scenario, paths_);
}

void Steering::put(const VehiclePath& path, double time) {
  const Vec2 front = path.front(time);
  const double heading = path.heading(time, api::Vehicle::getLength(path.vehicle()));
  api::Vehicle::moveToXY(path.vehicle(), "", -1, front.x(), front.y(), sumo_from_radians(heading),
                         kExactPlace, kLaneReach);
}

void Steering::apply(double time) {
  if (paths_.empty()) return;
  const std::vector<std::string> all = api::Vehicle::getIDList();
  const std::set<std::string> present(all.begin(), all.end());
  std::erase_if(paths_, [&](const VehiclePath& path) {
    if (time < path.begin()) return false;
    const std::string& id = path.vehicle();
    const bool there = present.contains(id), over = time > path.end();
    if (steered_.insert(id).second && !there) {
      // SUMO would accept one that is still to depart, and dies where that is off the road.
      throw path_error(path, "is not under way at the first row of its path",
                       "vehicles that depart a step before that or earlier");
    }
    if (there && !over) {
      put(path, time);
      return false;
    }
    // Where it is not there it has come to the end of its route, or somebody has removed it.
    if (there) api::Vehicle::remove(id, libsumo::REMOVE_ARRIVED);
    steered_.erase(id);
    return true;
  });
}

void Steering::foresee(Fleet& fleet, double time, double dt) const {
  if (steered_.empty() || dt <= 0.0) return;
  for (FleetVehicle& vehicle : fleet.vehicles()) {
    if (!steered_.contains(vehicle.id)) continue;
    const VehiclePath& path = *std::ranges::find(paths_, vehicle.id, &VehiclePath::vehicle);
    const double length = vehicle.traits.length, before = time - dt;
    vehicle.traits.external = true;
    vehicle.velocity = (centre(path, time, length) - centre(path, before, length)) / dt;
    vehicle.yaw_rate = wrap_angle(path.heading(time, length) - path.heading(before, length)) / dt;
    vehicle.speed = vehicle.velocity.norm();
    vehicle.way = path.way(before, length, kSeenAhead);
  }
}

}  // namespace pedzone
