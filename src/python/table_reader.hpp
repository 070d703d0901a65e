// Any table that pedzone writes, as arrays.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace pedzone {

/// {column: array}. Without the interpreter's lock while it reads. Throws InputError.
pybind11::dict read_table(const std::string& file);

/// [(name, unit, meaning), ...] of the file's columns. Throws InputError.
pybind11::list table_columns(const std::string& file);

}  // namespace pedzone
