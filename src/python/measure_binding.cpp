// Measures of single moments, for arrays of them.
#include <pybind11/stl.h>

#include <limits>
#include <optional>

#include "conflict/approach.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/body_arguments.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace pedzone {
namespace {

std::optional<double> room_between(const Approach& approach) { return clearance(approach); }

/// `measure` of each moment; NaN where there is none.
Doubles measured(std::optional<double> (*measure)(const Approach&), const Numbers& person,
                 const Numbers& person_velocity, const Numbers& vehicle,
                 const Numbers& vehicle_velocity, const Numbers& heading, double length,
                 double width, double radius) {
  const std::vector<Vec2> at = points_of(person, "person");
  const std::size_t n = at.size();
  const std::vector<Vec2> own = points_of(person_velocity, n, "person_velocity");
  const std::vector<Vec2> centre = points_of(vehicle, n, "vehicle");
  const std::vector<Vec2> velocity = points_of(vehicle_velocity, n, "vehicle_velocity");
  const std::span<const double> headings = numbers_of(heading, n, "heading");
  const Sizes sizes = sizes_of(length, width, radius);
  Doubles values(static_cast<py::ssize_t>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 axis = unit(headings[i]);
    const Approach approach{to_frame(axis, at[i] - centre[i]), to_frame(axis, own[i] - velocity[i]),
                            axis.dot(velocity[i]), sizes};
    values.mutable_data()[i] = measure(approach).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

template <std::optional<double> (*kMeasure)(const Approach&)>
void bind_measure(py::module_& module, const char* name, const char* doc) {
  module.def(
      name,
      [](const Numbers& person, const Numbers& person_velocity, const Numbers& vehicle,
         const Numbers& vehicle_velocity, const Numbers& heading, double length, double width,
         double radius) {
        return measured(kMeasure, person, person_velocity, vehicle, vehicle_velocity, heading,
                        length, width, radius);
      },
      "person"_a, "person_velocity"_a, "vehicle"_a, "vehicle_velocity"_a, "heading"_a,
      py::kw_only(), "length"_a = 5.0, "width"_a = 1.8, "radius"_a = 0.24, doc);
}

}  // namespace

void bind_measures(py::module_& module) {
  bind_measure<time_to_contact>(
      module, "time_to_contact",
      "TTC [s] at each of n moments if both keep their velocity: shape (n,); NaN: they never "
      "touch.\n\n"
      "person: centre of its disc [m], vehicle: centre of its rectangle [m], their velocities "
      "[m/s]:\n"
      "shape (n, 2). heading [rad] of the vehicle: shape (n,). length, width, radius [m] > 0.\n"
      "Raises ValueError.");
  bind_measure<deceleration_to_avoid>(
      module, "deceleration_to_avoid",
      "DRAC [m/s²] at each of n moments: with which the vehicle does not touch the person. NaN: "
      "no\n"
      "contact is ahead, or braking does not help. Arguments as time_to_contact().");
  bind_measure<room_between>(
      module, "clearance",
      "[m] between the bodies at each of n moments; negative: they overlap.\n\n"
      "Arguments as time_to_contact().");
}

}  // namespace pedzone
