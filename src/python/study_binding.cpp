#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <stdexcept>

#include "python/bindings.hpp"
#include "python/table_reader.hpp"
#include "study/run/store.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace pedzone {
namespace {

/// What `pedzone study run` has left in its folder.
struct PythonStudy {
  study::Store store;
  study::Plan plan;
};

PythonStudy open_study(const std::filesystem::path& folder) {
  study::Store store = study::Store::open(folder.string());
  study::Plan plan = store.plan();
  return {std::move(store), std::move(plan)};
}

std::vector<std::string> conditions(const PythonStudy& study) {
  std::vector<std::string> names;
  for (const study::Condition& condition : study.plan.conditions) names.push_back(condition.name);
  return names;
}

std::string run_folder(const PythonStudy& study, const std::string& model, std::uint64_t seed,
                       std::size_t condition) {
  try {
    const std::size_t run = study.plan.run_of(study::RunKind::kStudy, condition, model, seed);
    return study.store.run_folder(study.plan.runs.at(run).id);
  } catch (const std::out_of_range&) {
    throw py::key_error("the study has no run of model '" + model + "' with seed " +
                        std::to_string(seed) + " in condition " + std::to_string(condition));
  }
}

}  // namespace

void bind_studies(py::module_& module) {
  py::class_<PythonStudy>(module, "Study", "The results of a study, in the folder of its --out.")
      .def(py::init(&open_study), "folder"_a, "Raises InputError where it is none.")
      .def_property_readonly(
          "folder", [](const PythonStudy& study) { return study.store.folder(); }, "Absolute.")
      .def_property_readonly(
          "models", [](const PythonStudy& study) { return study.plan.study.models; }, "Names.")
      .def_property_readonly(
          "reference", [](const PythonStudy& study) { return study.plan.study.reference; },
          "The model that the others are compared with.")
      .def_property_readonly(
          "seeds", [](const PythonStudy& study) { return study.plan.study.seeds; }, "Numbers.")
      .def_property_readonly("conditions", conditions,
                             "Names of the scenarios with a level of each factor.")
      .def(
          "runs",
          [](const PythonStudy& study) { return read_table(study.store.folder() + "/runs.csv"); },
          "A row for each run, with its measures: as read_table(). Raises InputError.")
      .def(
          "summary",
          [](const PythonStudy& study) {
            return read_table(study.store.folder() + "/summary.csv");
          },
          "A row for each measure of each model, against the reference: as read_table().\n"
          "Raises InputError.")
      .def("run_folder", run_folder, "model"_a, "seed"_a, "condition"_a = 0,
           "The folder of one run: conflicts.csv, series.csv, density.csv and SUMO's outputs are "
           "in\n"
           "it. condition: index into `conditions`. Raises KeyError.");
}

}  // namespace pedzone
