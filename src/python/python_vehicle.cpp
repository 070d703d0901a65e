#include "python/python_vehicle.hpp"

#include <pybind11/stl.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "core/random.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace pedzone {
namespace {

void check(const VehicleState& state) {
  for (const double number :
       {state.centre.x(), state.centre.y(), state.heading, state.velocity.x(), state.velocity.y(),
        state.yaw_rate, state.gain, state.claim, state.claimed, state.length, state.width}) {
    finite_number(number, "a number of a vehicle");
  }
  if (!(state.length > 0.0 && state.width > 0.0)) {
    throw std::invalid_argument("length and width of a vehicle: allowed: more than 0 m");
  }
}

PythonVehicle make_vehicle(const std::string& id, const Point& centre, double heading, double speed,
                           double length, double width) {
  PythonVehicle vehicle;
  vehicle.state.key = person_key(id);
  vehicle.state.centre = vector_of(centre);
  vehicle.state.heading = heading;
  vehicle.state.velocity = speed * unit(heading);
  vehicle.state.length = length;
  vehicle.state.width = width;
  check(vehicle.state);
  return vehicle;
}

/// A property of the state that is read and written as it is.
template <class Value>
void bind_member(py::class_<PythonVehicle>& bound, const char* name, Value VehicleState::*member,
                 const char* doc) {
  bound.def_property(
      name, [member](const PythonVehicle& vehicle) { return vehicle.state.*member; },
      [member](PythonVehicle& vehicle, Value value) { vehicle.state.*member = value; }, doc);
}

void bind_vector(py::class_<PythonVehicle>& bound, const char* name, Vec2 VehicleState::*member,
                 const char* doc) {
  bound.def_property(
      name, [member](const PythonVehicle& vehicle) { return tuple_of(vehicle.state.*member); },
      [member](PythonVehicle& vehicle, const Point& point) {
        vehicle.state.*member = vector_of(point);
      },
      doc);
}

}  // namespace

std::vector<VehicleState> states_of(const std::vector<PythonVehicle>& vehicles) {
  std::vector<VehicleState> states;
  states.reserve(vehicles.size());
  for (const PythonVehicle& vehicle : vehicles) {
    check(vehicle.state);
    states.push_back(vehicle.state);
    states.back().way = vehicle.way;
  }
  return states;
}

PythonVehicle vehicle_of(const VehicleState& state) {
  PythonVehicle vehicle{state, {state.way.begin(), state.way.end()}};
  vehicle.state.way = {};
  return vehicle;
}

void bind_vehicles(py::module_& module) {
  py::class_<PythonVehicle> bound(module, "Vehicle",
                                  "A vehicle at one moment: a rectangle and how it moves.");
  bound.def(py::init(&make_vehicle), "id"_a, "centre"_a, "heading"_a = 0.0, "speed"_a = 0.0,
            py::kw_only(), "length"_a = 5.0, "width"_a = 1.8,
            "id: people know it again by it. centre: (x, y) [m] of the rectangle. heading [rad]\n"
            "counter-clockwise from +x. speed [m/s] along it, negative: reversing.\n"
            "length, width [m] > 0.");
  bind_vector(bound, "centre", &VehicleState::centre, "(x, y) [m] of the rectangle.");
  bind_vector(bound, "velocity", &VehicleState::velocity, "(x, y) [m/s] of the centre.");
  bind_member(bound, "heading", &VehicleState::heading, "[rad] counter-clockwise from +x.");
  bind_member(bound, "yaw_rate", &VehicleState::yaw_rate, "[rad/s]");
  bind_member(bound, "gain", &VehicleState::gain,
              "[m/s] >= 0: so much faster people expect it to drive in the next second.");
  bind_member(bound, "length", &VehicleState::length, "[m] > 0");
  bind_member(bound, "width", &VehicleState::width, "[m] > 0");
  bind_member(bound, "claim", &VehicleState::claim,
              "[m] [0, 50] of room ahead that it asks for when people hold it up.");
  bind_member(bound, "claimed", &VehicleState::claimed, "[s] for how long it has asked.");
  bind_member(bound, "electric", &VehicleState::electric, "No engine is heard.");
  bind_member(bound, "horn", &VehicleState::horn, "It sounds its horn.");
  bind_member(bound, "invites", &VehicleState::invites, "It lets people go first.");
  bound.def_property(
      "way", [](const PythonVehicle& vehicle) { return points_array(vehicle.way); },
      [](PythonVehicle& vehicle, const Numbers& points) { vehicle.way = points_of(points, "way"); },
      "[m] where it is about to drive, from its rear on: shape (n, 2); empty: not known.");
  bound.def_property_readonly(
      "key", [](const PythonVehicle& vehicle) { return vehicle.state.key; }, "key_of(id)");
  module.def("key_of", person_key, "id"_a,
             "The 64-bit number that stands for an id in `Crowd.keys` and random draws.");
}

}  // namespace pedzone
