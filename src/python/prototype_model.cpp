#include "python/prototype_model.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/error.hpp"
#include "model/decision_check.hpp"
#include "python/arrays.hpp"

namespace py = pybind11;

namespace pedzone {
namespace {

constexpr const char* kAnswer = "a tuple (direction, speed) or (direction, speed, waits)";

PythonSnapshot copy_of(const Snapshot& snapshot) {
  const Persons& persons = *snapshot.persons;
  PythonSnapshot copy;
  copy.walking = persons.walking;
  copy.step = snapshot.step;
  copy.time = snapshot.time ? py::object(py::float_(*snapshot.time)) : py::none();
  copy.x = array_of(persons.x);
  copy.y = array_of(persons.y);
  copy.vx = array_of(persons.vx);
  copy.vy = array_of(persons.vy);
  copy.heading = array_of(persons.heading);
  copy.radius = array_of(persons.radius);
  copy.preferred_speed = array_of(persons.preferred_speed);
  copy.goal_direction = array_of(persons.goal_direction);
  copy.goal_distance = array_of(persons.goal_distance);
  copy.key = array_of(persons.key);
  for (const VehicleState& vehicle : snapshot.vehicles)
    copy.vehicles.push_back(vehicle_of(vehicle));
  return copy;
}

/// What Python gave, as an array. Throws InputError, naming the model by `whose`.
Numbers array_in(const py::handle& given, const std::string& whose, const char* what) {
  Numbers array = Numbers::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw InputError("is no array of numbers",
                     {whose, 0, std::string(what) + " of the walking model's decision",
                      py::str(py::type::of(given).attr("__name__")), kAnswer});
  }
  return array;
}

}  // namespace

PrototypeModel::PrototypeModel(py::object model)
    : model_(std::move(model)),
      name_(py::str(py::type::of(model_).attr("__name__"))),
      sets_velocity_(model_.attr("sets_velocity").cast<bool>()) {}

void PrototypeModel::prepare(const Snapshot& snapshot) {
  const py::gil_scoped_acquire lock;
  decisions_.assign(snapshot.persons->walking, Decision{});
  if (decisions_.empty()) return;
  const py::object answer = model_.attr("decide")(copy_of(snapshot));
  if (!py::isinstance<py::tuple>(answer) || py::len(answer) < 2 || py::len(answer) > 3) {
    throw InputError("returned something else from decide()",
                     {.file = name_,
                      .value = py::str(py::type::of(answer).attr("__name__")),
                      .allowed = kAnswer});
  }
  take(snapshot, answer);
}

void PrototypeModel::take(const Snapshot& snapshot, const py::tuple& answer) {
  const std::size_t n = decisions_.size();
  const Numbers directions = array_in(answer[0], name_, "direction");
  const Numbers speeds = array_in(answer[1], name_, "speed");
  const std::span<const double> direction = numbers_of(directions, n, "direction");
  const std::span<const double> speed = numbers_of(speeds, n, "speed");
  Numbers waits(static_cast<py::ssize_t>(n));
  std::fill_n(waits.mutable_data(), n, 0.0);
  if (answer.size() == 3) waits = array_in(answer[2], name_, "waits");
  const std::span<const double> waiting = numbers_of(waits, n, "waits");
  for (std::size_t i = 0; i < n; ++i) {
    Decision& decision = decisions_[i];
    decision.direction = direction[i];
    decision.speed = speed[i];
    decision.free_distance = snapshot.parameters->sight;  // bodies and walls stop it on contact
    decision.waits = waiting[i] != 0.0;
    check_decision(name_, decision, snapshot.persons->preferred_speed[i]);
  }
}

void PrototypeModel::decide(std::size_t first, std::size_t last,
                            std::span<Decision> decisions) const {
  std::copy(decisions_.begin() + static_cast<std::ptrdiff_t>(first),
            decisions_.begin() + static_cast<std::ptrdiff_t>(last),
            decisions.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace pedzone
