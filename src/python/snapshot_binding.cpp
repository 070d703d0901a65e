#include <pybind11/stl.h>

#include "python/bindings.hpp"
#include "python/prototype_model.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace pedzone {
namespace {

py::object not_there(const PythonModel& /*model*/, const PythonSnapshot& /*snapshot*/) {
  PyErr_SetString(PyExc_NotImplementedError, "a walking model in Python defines decide(snapshot)");
  throw py::error_already_set();
}

void bind_model(py::module_& module) {
  py::class_<PythonModel>(
      module, "WalkingModel",
      "Base of walking models in Python: for prototypes. A class that derives from it defines\n"
      "decide(); an instance is given to Crowd(model=...).\n\n"
      "Slow: the interpreter works on one thread while the crowd's own models use all of them, "
      "and\n"
      "the snapshot is copied. A model to keep is written in C++ (src/model/README.md).")
      .def(py::init<>())
      .def("decide", not_there, "snapshot"_a,
           "What everybody does next: a tuple (direction, speed) or (direction, speed, waits).\n\n"
           "Each of shape (snapshot.walking,): direction [rad]; speed [m/s] from 0 to the "
           "preferred\n"
           "speed; waits: stands for a vehicle. Called once a substep of at most 0.1 s, by one\n"
           "thread. It depends on the snapshot alone. What it raises ends Crowd.step(), and the\n"
           "crowd cannot be walked on.")
      .attr("sets_velocity") = false;
}

}  // namespace

void bind_snapshot(py::module_& module) {
  using Row = PythonSnapshot;
  py::class_<Row>(module, "Snapshot",
                  "Who is where at one moment, for WalkingModel.decide(). Arrays have a row for\n"
                  "each person: the first `walking` decide, the others are only seen.")
      .def_readonly("walking", &Row::walking, "How many decide.")
      .def_readonly("step", &Row::step, "[s] for which decisions hold.")
      .def_readonly("time", &Row::time, "[s] since the crowd began.")
      .def_readonly("x", &Row::x, "[m]")
      .def_readonly("y", &Row::y, "[m]")
      .def_readonly("vx", &Row::vx, "[m/s]")
      .def_readonly("vy", &Row::vy, "[m/s]")
      .def_readonly("heading", &Row::heading, "[rad] where the body faces.")
      .def_readonly("radius", &Row::radius, "[m] of the body as a disc.")
      .def_readonly("preferred_speed", &Row::preferred_speed, "[m/s]")
      .def_readonly("goal_direction", &Row::goal_direction,
                    "[rad] towards the next corner or goal.")
      .def_readonly("goal_distance", &Row::goal_distance, "[m] to there.")
      .def_readonly("key", &Row::key, "key_of(id); 0 of those who are only seen.")
      .def_readonly("vehicles", &Row::vehicles, "A list of Vehicle.");
  bind_model(module);
}

}  // namespace pedzone
