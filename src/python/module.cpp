// `import pedzone`: the crowd, the measures and the tables for Python. What is here converts and
// calls; what it calls is in the layers above.
#include <exception>

#include "core/error.hpp"
#include "model/walking_model.hpp"
#include "python/bindings.hpp"

namespace py = pybind11;

namespace pedzone {
namespace {

/// Whatever the layers call the input's fault is one exception, with the same text.
void bind_errors(py::module_& module) {
  static PyObject* const input_error =
      py::exception<InputError>(module, "InputError", PyExc_ValueError).release().ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      PyErr_SetString(input_error, error.what());
    } catch (const ModelError& error) {
      PyErr_SetString(input_error, error.what());
    }
  });
  module.attr("InputError").attr("__doc__") =
      "Bad input. The text names file, line, element, value and what is allowed.";
}

}  // namespace
}  // namespace pedzone

PYBIND11_MODULE(_pedzone, module) {
  // Classes and signatures then say `pedzone.Crowd`, as users import them.
  const py::object name = module.attr("__name__");
  module.attr("__name__") = "pedzone";
  module.attr("__version__") = PEDZONE_VERSION;
  pedzone::bind_errors(module);
  pedzone::bind_zones(module);
  pedzone::bind_vehicles(module);
  pedzone::bind_snapshot(module);
  pedzone::bind_crowd(module);
  pedzone::bind_measures(module);
  pedzone::bind_conflicts(module);
  pedzone::bind_tables(module);
  pedzone::bind_studies(module);
  module.attr("__name__") = name;
}
