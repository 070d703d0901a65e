#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>

#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/python_zone.hpp"
#include "world/model_names.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace pedzone {
namespace {

using Path = std::filesystem::path;

/// [(outer, [hole, ...]), ...]
py::list polygons_of(const Region& region) {
  py::list polygons;
  for (const Polygon& polygon : region) {
    py::list holes;
    for (const Ring& hole : polygon.holes) holes.append(points_array(hole));
    polygons.append(py::make_tuple(points_array(polygon.outer), holes));
  }
  return polygons;
}

SharedZone from_polygons(const Numbers& outer, const std::vector<Numbers>& holes,
                         const std::string& id, const std::string& model,
                         const std::map<std::string, double>& parameters) {
  std::vector<Ring> rings;
  for (const Numbers& hole : holes) rings.push_back(points_of(hole, "a hole"));
  return zone_of_polygons(points_of(outer, "outer"), rings, {id, model, parameters});
}

py::array_t<bool> inside(const PythonZone& zone, const Numbers& points) {
  const std::vector<Vec2> places = points_of(points, "points");
  py::array_t<bool> result(static_cast<py::ssize_t>(places.size()));
  std::ranges::transform(places, result.mutable_data(),
                         [&](const Vec2& at) { return zone.zone.walls.inside(at); });
  return result;
}

Doubles room(const PythonZone& zone, const Numbers& points, double limit) {
  if (!(limit >= 0.0)) throw py::value_error("limit has to be 0 m or more");
  const std::vector<Vec2> places = points_of(points, "points");
  Doubles result(static_cast<py::ssize_t>(places.size()));
  std::ranges::transform(places, result.mutable_data(),
                         [&](const Vec2& at) { return zone.zone.walls.room(at, limit); });
  return result;
}

py::object way(const PythonZone& zone, const Point& start, const Point& goal) {
  finite_number(start[0] + start[1], "start");
  finite_number(goal[0] + goal[1], "goal");
  const auto found = zone.zone.ways.way(vector_of(start), vector_of(goal));
  if (!found) return py::none();
  std::vector<Vec2> points{vector_of(start)};
  points.insert(points.end(), found->begin(), found->end());
  return points_array(points);
}

py::dict parameters(const PythonZone& zone) {
  py::dict values;
  for (const ParameterInfo& info : parameter_list()) {
    values[py::str(std::string(info.key))] = zone.zone.parameters.*info.member;
  }
  return values;
}

py::list profile_ids(const PythonZone& zone) {
  py::list ids;
  for (const Profile& profile : zone.profiles->all()) ids.append(profile.id);
  return ids;
}

void bind_zone_class(py::module_& module) {
  py::class_<PythonZone, SharedZone>(
      module, "Zone",
      "Where people are walked: a walkable area with its walls and the ways through it.\n\n"
      "Made by read_zones() or Zone.from_polygons(); it does not change.")
      .def_static(
          "from_polygons", from_polygons, "outer"_a, py::kw_only(),
          "holes"_a = std::vector<Numbers>(), "id"_a = "zone", "model"_a = "heuristic",
          "parameters"_a = std::map<std::string, double>(),
          "A zone without a network: the polygon `outer` less `holes`.\n\n"
          "outer, holes: corners [m], shape (n, 2), either way round. All the rest is a\n"
          "wall that nobody sees through. model: a name of MODELS or the path of a plug-in.\n"
          "parameters: those that differ from their defaults (src/world/README.md has names,\n"
          "units and ranges). Raises InputError.")
      .def_property_readonly(
          "id", [](const PythonZone& zone) { return zone.zone.id; }, "Its name.")
      .def_property_readonly(
          "model", [](const PythonZone& zone) { return zone.zone.model; },
          "The walking model that a Crowd takes where it is given none.")
      .def_property_readonly("parameters", parameters, "All parameters: a dict of floats.")
      .def_property_readonly("profiles", profile_ids, "Names that Crowd.add() takes as `profile`.")
      .def_property_readonly(
          "warnings", [](const PythonZone& zone) { return zone.zone.warnings; },
          "What could not be used, a line each.")
      .def_property_readonly(
          "area", [](const PythonZone& zone) { return area(zone.zone.walkable); },
          "[m²] of the ground.")
      .def_property_readonly(
          "polygons", [](const PythonZone& zone) { return polygons_of(zone.zone.walkable); },
          "The ground: a list of (outer, [hole, ...]), each corners [m] of shape (n, 2).")
      .def_property_readonly(
          "obstacles", [](const PythonZone& zone) { return polygons_of(zone.zone.obstacles); },
          "Buildings and the like, as `polygons`.")
      .def("inside", inside, "points"_a,
           "Whether each point [m] of shape (n, 2) is on the ground: bools of shape (n,).")
      .def("room", room, "points"_a, "limit"_a = 10.0,
           "[m] from each point of shape (n, 2) to the nearest wall, at most `limit`: shape (n,).\n"
           "Raises ValueError.")
      .def(
          "way", way, "start"_a, "goal"_a,
          "The shortest way [m] round corners from (x, y) to (x, y), both included: shape (n, 2).\n"
          "None where there is no way.")
      .def("__repr__",
           [](const PythonZone& zone) { return "<pedzone.Zone '" + zone.zone.id + "'>"; });
}

}  // namespace

void bind_zones(py::module_& module) {
  py::list models;
  for (const std::string_view name : kModelNames) models.append(std::string(name));
  module.attr("MODELS") = py::tuple(models);
  bind_zone_class(module);
  module.def(
      "read_zones",
      [](const Path& scenario, const std::optional<Path>& zone_file) {
        return read_zones(scenario.string(), zone_file ? zone_file->string() : "");
      },
      "scenario"_a, "zone_file"_a = py::none(), py::call_guard<py::gil_scoped_release>(),
      "The zones of a SUMO scenario (.sumocfg) or network (.net.xml, .net.xml.gz), as\n"
      "`pedzone run` makes them: those of the zone file, else the one that is found.\n\n"
      "Empty where there is no shared space. SUMO itself is not started. Raises InputError.");
}

}  // namespace pedzone
