#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <variant>

#include "core/random.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/prototype_model.hpp"
#include "python/python_crowd.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace pedzone {
namespace {

/// (x, y), or both ends of a line.
using Goal = std::variant<Point, std::array<Point, 2>>;
/// (x, y), or (x, y, radius).
using PathPoint = std::variant<Point, std::array<double, 3>>;

Destination destination_of(const Goal& goal) {
  if (const auto* point = std::get_if<Point>(&goal)) return {vector_of(*point), vector_of(*point)};
  const auto& line = std::get<std::array<Point, 2>>(goal);
  return {vector_of(line[0]), vector_of(line[1])};
}

Waypoint waypoint_of(const PathPoint& given) {
  if (const auto* point = std::get_if<Point>(&given)) return {vector_of(*point)};
  const auto& with_radius = std::get<std::array<double, 3>>(given);
  return {{with_radius[0], with_radius[1]}, with_radius[2]};
}

std::unique_ptr<WalkingModel> model_of(const py::object& given, const Zone& zone) {
  if (given.is_none()) return make_model(zone.model);
  if (py::isinstance<py::str>(given)) return make_model(given.cast<std::string>());
  if (py::isinstance<PythonModel>(given)) return std::make_unique<PrototypeModel>(given);
  throw py::type_error(
      "model: a name of pedzone.MODELS, the path of a plug-in, or an object of a "
      "class derived from pedzone.WalkingModel");
}

std::unique_ptr<PythonCrowd> make_crowd(const SharedZone& zone, std::uint64_t seed,
                                        const py::object& model) {
  return std::make_unique<PythonCrowd>(zone, seed, model_of(model, zone->zone));
}

Crowd::Handle checked(const Crowd& crowd, Crowd::Handle handle) {
  if (!crowd.has(handle)) {
    throw py::key_error("nobody in the crowd has the handle " + std::to_string(handle));
  }
  return handle;
}

Crowd::Handle add(PythonCrowd& crowd, const Point& position, const Goal& goal, double speed,
                  const std::string& id, double radius, const Point& velocity,
                  std::optional<double> heading, const std::string& profile,
                  std::optional<bool> aware, const std::string& group,
                  const std::vector<PathPoint>& path, bool place_freely) {
  NewPerson person;
  person.key = id.empty() ? crowd.next_key() : person_key(id);
  person.position = vector_of(position);
  person.destination = destination_of(goal);
  person.preferred_speed = speed;
  person.radius = radius;
  person.velocity = vector_of(velocity);
  const Vec2 middle = 0.5 * (person.destination.a + person.destination.b);
  person.heading = heading ? *heading : angle_of(middle - person.position);
  person.aware = aware;
  person.group = group.empty() ? 0 : person_key(group);
  for (const PathPoint& point : path) person.path.push_back(waypoint_of(point));
  person.place_freely = place_freely;
  return crowd.add(person, profile);
}

/// A value of each person, by row.
template <class Value, class Get>
py::array_t<Value> by_row(const PythonCrowd& crowd, const Get& get) {
  const Crowd& read = crowd.read();
  py::array_t<Value> values(static_cast<py::ssize_t>(read.size()));
  for (std::size_t i = 0; i < read.size(); ++i) values.mutable_data()[i] = get(read, i);
  return values;
}

Doubles positions(const PythonCrowd& crowd) {
  const Persons& persons = crowd.read().persons();
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < crowd.read().size(); ++i)
    points.push_back({persons.x[i], persons.y[i]});
  return points_array(points);
}

void see(PythonCrowd& crowd, const Numbers& places, const std::optional<Numbers>& velocities,
         double radius, const std::vector<std::string>& ids) {
  const std::vector<Vec2> at = points_of(places, "positions");
  const std::vector<Vec2> moves = velocities ? points_of(*velocities, "velocities")
                                             : std::vector<Vec2>(at.size(), Vec2::Zero());
  if (moves.size() != at.size() || (!ids.empty() && ids.size() != at.size())) {
    throw std::invalid_argument("velocities, ids: allowed: as many as positions");
  }
  std::vector<SeenPerson> seen;
  for (std::size_t i = 0; i < at.size(); ++i) {
    seen.push_back({.position = at[i],
                    .velocity = moves[i],
                    .radius = finite_number(radius, "radius"),
                    .key = ids.empty() ? 0 : person_key(ids[i])});
  }
  crowd.change().see(seen);
}

void bind_person(py::module_& module) {
  using View = PersonView;
  py::class_<View>(module, "Person", "One person at one moment, as Crowd.person() tells it.")
      .def_property_readonly(
          "position", [](const View& view) { return tuple_of(view.position); }, "(x, y) [m]")
      .def_property_readonly(
          "velocity", [](const View& view) { return tuple_of(view.velocity); }, "(x, y) [m/s]")
      .def_readonly("heading", &View::heading, "[rad] where it faces.")
      .def_readonly("radius", &View::radius, "[m] as it holds its shoulders now.")
      .def_property_readonly(
          "motion", [](const View& view) { return name_of(view.motion); },
          "'walking', 'waiting' (for a vehicle) or 'standing'.")
      .def_property_readonly(
          "activity", [](const View& view) { return std::string(info_of(view.activity).id); },
          "'none', 'texting', ...")
      .def_readonly("arrived", &View::arrived, "On its goal, or gave up there.")
      .def_readonly("gave_up", &View::gave_up, "Arrived only since its goal is blocked.")
      .def_readonly("waits_for_group", &View::waits_for_group, "Is too far ahead of its group.")
      .def_readonly("holds_hand", &View::holds_hand, "A child whom an adult leads.");
}

void bind_push(py::module_& module) {
  py::class_<VehiclePush>(module, "Push", "What a vehicle that drives did to a person in one step.")
      .def_readonly("person", &VehiclePush::person, "key_of() the person's id.")
      .def_readonly("vehicle", &VehiclePush::vehicle, "key_of() the vehicle's id.")
      .def_readonly("way", &VehiclePush::way,
                    "[m] by which it moved the person from where its own steps led.")
      .def_readonly("carried", &VehiclePush::carried,
                    "[m] of that the part along which the vehicle drives, before its bumper.")
      .def_readonly("speed", &VehiclePush::speed, "[m/s] of the fastest of those moves.")
      .def_readonly("run_into", &VehiclePush::run_into, "The bodies overlap.")
      .def_readonly("contact_speed", &VehiclePush::contact_speed,
                    "[m/s] of the vehicle when that began; else as it drove last.")
      .def_property_readonly(
          "position", [](const VehiclePush& push) { return tuple_of(push.position); },
          "(x, y) [m] of the person.");
}

std::vector<VehiclePush> pushes(const PythonCrowd& crowd) {
  const std::span<const VehiclePush> all = crowd.read().pushes();
  return {all.begin(), all.end()};
}

void bind_people(py::class_<PythonCrowd>& bound) {
  bound
      .def(
          "add", add, "position"_a, "goal"_a, py::kw_only(), "speed"_a = 1.34, "id"_a = "",
          "radius"_a = 0.24, "velocity"_a = Point{0.0, 0.0}, "heading"_a = py::none(),
          "profile"_a = "", "aware"_a = py::none(), "group"_a = "",
          "path"_a = std::vector<PathPoint>(), "place_freely"_a = false,
          "Puts a person at (x, y) [m], or the nearest place inside the walls; returns its "
          "handle.\n\n"
          "goal: (x, y), or both ends of a line to be crossed, ((x, y), (x, y)). speed [m/s] that\n"
          "it prefers, (0, 5], and radius [m] of its body, [0.05, 1], are clamped. velocity "
          "[m/s].\n"
          "heading [rad]; None: towards the goal. id: what random draws depend on (key_of).\n"
          "profile: a name of Zone.profiles. aware: of vehicles; None: by the profile's share.\n"
          "group: persons of one name keep together. path: come by (x, y) or (x, y, radius) in\n"
          "turn. place_freely: at the nearest free place. Raises InputError, ValueError.")
      .def(
          "remove",
          [](PythonCrowd& crowd, Crowd::Handle handle) {
            crowd.change().remove(checked(crowd.read(), handle));
          },
          "handle"_a, "Takes a person out. Its handle will be given to another. Raises KeyError.")
      .def(
          "set_goal",
          [](PythonCrowd& crowd, Crowd::Handle handle, const Goal& goal) {
            crowd.change().set_destination(checked(crowd.read(), handle), destination_of(goal));
          },
          "handle"_a, "goal"_a, "Plans the way anew, to a goal as in add(). Raises KeyError.")
      .def(
          "set_speed",
          [](PythonCrowd& crowd, Crowd::Handle handle, double speed) {
            crowd.change().set_preferred_speed(checked(crowd.read(), handle), speed);
          },
          "handle"_a, "speed"_a, "Sets the preferred speed [m/s] (0, 5]. Raises KeyError.")
      .def("see", see, "positions"_a, "velocities"_a = py::none(), "radius"_a = 0.24,
           "ids"_a = std::vector<std::string>(),
           "Replaces those whom the crowd only sees: positions [m], velocities [m/s] (None: they\n"
           "stand) of shape (n, 2), radius [m], ids (none: not known again from call to call).\n"
           "They move on with their velocity.")
      .def(
          "person",
          [](const PythonCrowd& crowd, Crowd::Handle handle) {
            return crowd.read().view(checked(crowd.read(), handle));
          },
          "handle"_a, "All that is told of one person. Raises KeyError.");
}

void bind_columns(py::class_<PythonCrowd>& bound) {
  const auto column = [&](const char* name, std::vector<double> Persons::*member, const char* doc) {
    bound.def_property_readonly(
        name, [member](const PythonCrowd& crowd) { return crowd.show(member); }, doc);
  };
  column("x", &Persons::x, "[m] of the bodies' centres, by row; shown without a copy.");
  column("y", &Persons::y, "[m] the same.");
  column("vx", &Persons::vx, "[m/s] by row; shown without a copy.");
  column("vy", &Persons::vy, "[m/s] the same.");
  column("heading", &Persons::heading, "[rad] where bodies face, by row; shown without a copy.");
  column("radius", &Persons::radius, "[m] of the bodies, by row; shown without a copy.");
  bound
      .def_property_readonly(
          "keys", [](const PythonCrowd& crowd) { return crowd.show(&Persons::key); },
          "key_of(id), by row; shown without a copy.")
      .def_property_readonly(
          "handles",
          [](const PythonCrowd& crowd) {
            return by_row<Crowd::Handle>(
                crowd, [](const Crowd& read, std::size_t i) { return read.handle_in(i); });
          },
          "The handle of each row: a new array.")
      .def_property_readonly(
          "arrived",
          [](const PythonCrowd& crowd) {
            return by_row<bool>(crowd, [](const Crowd& read, std::size_t i) {
              return read.view(read.handle_in(i)).arrived;
            });
          },
          "Whether the person of each row has arrived: a new array.")
      .def("positions", positions, "[m] by row, of shape (n, 2): a copy, since x and y lie apart.");
}

}  // namespace

void bind_crowd(py::module_& module) {
  bind_person(module);
  bind_push(module);
  py::class_<PythonCrowd> bound(
      module, "Crowd",
      "The people of one zone, and the step that moves them.\n\n"
      "x, y, vx, vy, heading, radius and keys are arrays of shape (n,), a row for each person: "
      "the\n"
      "crowd's own memory, shown without a copy and not to be written to. An array stays what it\n"
      "was when it was asked for. Where one is still held when the crowd changes, the crowd "
      "leaves\n"
      "its memory to it and goes on in a copy. Rows change places; handles stay.");
  bound
      .def(py::init(&make_crowd), "zone"_a.none(false), "seed"_a = 1, "model"_a = py::none(),
           "model: a name of MODELS, the path of a plug-in, an object of a class derived from\n"
           "WalkingModel, or None: the zone's. Raises InputError.")
      .def("step", &PythonCrowd::step, "dt"_a, "vehicles"_a = std::vector<PythonVehicle>(),
           "Walks everybody for dt [s], (0, 3600], in substeps of at most 0.1 s.\n\n"
           "vehicles: a list of Vehicle as they are now; between substeps they move on. The\n"
           "interpreter's lock is free meanwhile. Raises ValueError, and what a model in Python\n"
           "raises: after that the crowd cannot be used.")
      .def("pushes", pushes,
           "Whom vehicles that drive pushed or ran into in the last step: a list of Push.")
      .def(
          "let_vehicles_through", [](PythonCrowd& crowd) { crowd.change().let_vehicles_through(); },
          "From now on nobody is kept out of vehicles: for measures of what a model does by "
          "itself.")
      .def("__len__", [](const PythonCrowd& crowd) { return crowd.read().size(); })
      .def(
          "__contains__",
          [](const PythonCrowd& crowd, Crowd::Handle handle) { return crowd.read().has(handle); },
          "handle"_a);
  bind_people(bound);
  bind_columns(bound);
}

}  // namespace pedzone
