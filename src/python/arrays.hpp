// Between plane vectors and NumPy's arrays.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <span>
#include <variant>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

/// A point as Python gives it: any sequence of two numbers.
using Point = std::array<double, 2>;
/// Numbers as Python gives them: made double, one after the other in memory.
using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;
using Doubles = pybind11::array_t<double>;

inline Vec2 vector_of(const Point& point) { return {point[0], point[1]}; }
/// (x, y)
inline pybind11::tuple tuple_of(const Vec2& vector) {
  return pybind11::make_tuple(vector.x(), vector.y());
}

/// Points of an array of shape (n, 2). Throws std::invalid_argument, naming `what`, for another
/// shape and for what is not finite.
std::vector<Vec2> points_of(const Numbers& array, const char* what);
/// The same of an array of n points.
std::vector<Vec2> points_of(const Numbers& array, std::size_t n, const char* what);

/// Numbers of an array of shape (n). Throws std::invalid_argument, naming `what`, for another shape
/// or length and for what is not finite.
std::span<const double> numbers_of(const Numbers& array, std::size_t n, const char* what);

/// New array of shape (n, 2).
Doubles points_array(std::span<const Vec2> points);

/// New array of shape (n).
template <class Value>
pybind11::array_t<Value> array_of(const std::vector<Value>& values) {
  return pybind11::array_t<Value>(static_cast<pybind11::ssize_t>(values.size()), values.data());
}

/// Throws std::invalid_argument where the number is not finite.
double finite_number(double number, const char* what);

}  // namespace pedzone
