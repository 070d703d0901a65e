// TTC, PET and DRAC of two trajectories.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <optional>
#include <stdexcept>

#include "conflict/tracker.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/body_arguments.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace pedzone {
namespace {

/// Times ascend. Throws std::invalid_argument.
std::span<const double> times_of(const Numbers& time) {
  const std::span<const double> times =
      numbers_of(time, static_cast<std::size_t>(time.size()), "time");
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(times[i] > times[i - 1])) {
      throw std::invalid_argument("time: allowed: each later than the one before");
    }
  }
  return times;
}

/// Those given, else from each place to the next, the first as the second.
std::vector<Vec2> velocities_of(const std::optional<Numbers>& given,
                                const std::vector<Vec2>& places, std::span<const double> times,
                                const char* what) {
  if (given) return points_of(*given, places.size(), what);
  std::vector<Vec2> velocities(places.size(), Vec2::Zero());
  for (std::size_t i = 1; i < places.size(); ++i) {
    velocities[i] = (places[i] - places[i - 1]) / (times[i] - times[i - 1]);
  }
  if (places.size() > 1) velocities[0] = velocities[1];
  return velocities;
}

/// As ConflictLimits says. Throws std::invalid_argument.
ConflictLimits checked(const ConflictLimits& limits) {
  const auto check = [](const char* what, double value, double most) {
    if (value >= 0.0 && value <= most) return;
    throw std::invalid_argument(fmt::format("{}: {}; allowed: 0 to {}", what, value, most));
  };
  check("ttc", limits.ttc, 60.0);
  check("pet", limits.pet, 60.0);
  check("drac", limits.drac, 100.0);
  check("range", limits.range, 1000.0);
  check("horizon", limits.horizon, 60.0);
  return limits;
}

std::vector<Conflict> conflicts(const Numbers& time, const Numbers& person, const Numbers& vehicle,
                                const Numbers& heading,
                                const std::optional<Numbers>& person_velocity,
                                const std::optional<Numbers>& vehicle_velocity, double length,
                                double width, double radius, double ttc, double pet, double drac,
                                double range, double horizon) {
  const std::span<const double> times = times_of(time);
  const std::size_t n = times.size();
  const std::vector<Vec2> places = points_of(person, n, "person");
  const std::vector<Vec2> centres = points_of(vehicle, n, "vehicle");
  const std::span<const double> headings = numbers_of(heading, n, "heading");
  const auto moves = velocities_of(person_velocity, places, times, "person_velocity");
  const auto drives = velocities_of(vehicle_velocity, centres, times, "vehicle_velocity");
  sizes_of(length, width, radius);
  ConflictTracker tracker(checked({ttc, pet, drac, range, horizon}));
  std::vector<Conflict> over;
  const AwareOf unknown = [](std::size_t, std::size_t) { return std::nullopt; };
  for (std::size_t i = 0; i < n; ++i) {
    const PersonSample walker{"person", places[i], moves[i], angle_of(moves[i]), radius};
    const VehicleSample driver{"vehicle", centres[i], headings[i], drives[i], length, width};
    tracker.step(times[i], {&walker, 1}, {&driver, 1}, unknown, over);
  }
  tracker.finish(over);
  return over;
}

void bind_extreme(py::module_& module) {
  py::class_<Extreme>(module, "Extreme", "A measure at the moment of its extreme.")
      .def_readonly("value", &Extreme::value, "In the measure's unit.")
      .def_readonly("time", &Extreme::time, "[s]")
      .def_property_readonly(
          "position", [](const Extreme& at) { return tuple_of(at.position); },
          "(x, y) [m] where they touch or would touch; clearance and PET: the person's centre.")
      .def_property_readonly(
          "type", [](const Extreme& at) { return name_of(at.type); }, "As Conflict.type, then.")
      .def_readonly("person_speed", &Extreme::person_speed, "[m/s]")
      .def_readonly("vehicle_speed", &Extreme::vehicle_speed, "[m/s]")
      .def_readonly("relative_speed", &Extreme::relative_speed, "[m/s]")
      .def_readonly("closing_speed", &Extreme::closing_speed,
                    "[m/s] at which the bodies come nearer; negative: they part.");
}

void bind_conflict(py::module_& module) {
  py::class_<Conflict>(module, "Conflict",
                       "One encounter of a person with a vehicle. A measure that it does not have\n"
                       "is None.")
      .def_readonly("begin", &Conflict::begin, "[s] first moment in which it mattered.")
      .def_readonly("end", &Conflict::end, "[s] last moment.")
      .def_property_readonly(
          "type", [](const Conflict& one) { return name_of(one.type); },
          "'headOn', 'fromBehind', 'following', 'crossingLeft', 'crossingRight' or 'parked'.")
      .def_property_readonly(
          "first", [](const Conflict& one) { return name_of(one.first); },
          "Who was first at the place of the PET: 'person', 'vehicle' or 'NA'.")
      .def_readonly("ttc", &Conflict::ttc, "Least time to contact [s].")
      .def_readonly("drac", &Conflict::drac, "Greatest deceleration to avoid contact [m/s²].")
      .def_readonly("pet", &Conflict::pet, "Least post-encroachment time [s].")
      .def_readonly("clearance", &Conflict::clearance, "Least clearance [m]; negative: overlap.")
      .def_readonly("contact", &Conflict::contact, "Relative speed at the first contact [m/s].");
}

}  // namespace

void bind_conflicts(py::module_& module) {
  bind_extreme(module);
  bind_conflict(module);
  const ConflictLimits usual;
  module.def(
      "conflicts", conflicts, "time"_a, "person"_a, "vehicle"_a, "heading"_a, py::kw_only(),
      "person_velocity"_a = py::none(), "vehicle_velocity"_a = py::none(), "length"_a = 5.0,
      "width"_a = 1.8, "radius"_a = 0.24, "ttc"_a = usual.ttc, "pet"_a = usual.pet,
      "drac"_a = usual.drac, "range"_a = usual.range, "horizon"_a = usual.horizon,
      "The encounters of a person and a vehicle that were near: a list of Conflict.\n\n"
      "time [s], ascending, and heading [rad] of the vehicle: shape (n,). person: centre of its "
      "disc\n"
      "[m], vehicle: centre of its rectangle [m], their velocities [m/s] (None: from place to "
      "place):\n"
      "shape (n, 2). length, width, radius [m] > 0.\n"
      "Told is what has a TTC below ttc [s], a PET below pet [s], a DRAC above drac [m/s²], or a\n"
      "contact: ttc=60, pet=60, drac=0 tell all. Farther apart than range [m] nothing counts; a "
      "TTC\n"
      "beyond horizon [s] is none. Raises ValueError.");
}

}  // namespace pedzone
