// The parts of the module, each in a file of its own.
#pragma once

#include <pybind11/pybind11.h>

namespace pedzone {

void bind_zones(pybind11::module_& module);
void bind_vehicles(pybind11::module_& module);
void bind_snapshot(pybind11::module_& module);
void bind_crowd(pybind11::module_& module);
void bind_measures(pybind11::module_& module);
void bind_conflicts(pybind11::module_& module);
void bind_tables(pybind11::module_& module);
void bind_studies(pybind11::module_& module);

}  // namespace pedzone
