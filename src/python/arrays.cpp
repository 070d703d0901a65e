#include "python/arrays.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace py = pybind11;

namespace pedzone {
namespace {

std::string shape_text(const py::array& array) {
  return py::str(py::tuple(array.attr("shape"))).cast<std::string>();
}

}  // namespace

std::vector<Vec2> points_of(const Numbers& array, const char* what) {
  if (array.ndim() != 2 || array.shape(1) != 2) {
    throw std::invalid_argument(std::string(what) + ": shape " + shape_text(array) +
                                "; allowed: (n, 2)");
  }
  std::vector<Vec2> points;
  points.reserve(static_cast<std::size_t>(array.shape(0)));
  const auto values = array.unchecked<2>();
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    points.emplace_back(finite_number(values(i, 0), what), finite_number(values(i, 1), what));
  }
  return points;
}

std::vector<Vec2> points_of(const Numbers& array, std::size_t n, const char* what) {
  std::vector<Vec2> points = points_of(array, what);
  if (points.size() != n) {
    throw std::invalid_argument(std::string(what) + ": shape " + shape_text(array) +
                                "; allowed: (" + std::to_string(n) + ", 2)");
  }
  return points;
}

std::span<const double> numbers_of(const Numbers& array, std::size_t n, const char* what) {
  if (array.ndim() != 1 || array.shape(0) != static_cast<py::ssize_t>(n)) {
    throw std::invalid_argument(std::string(what) + ": shape " + shape_text(array) +
                                "; allowed: (" + std::to_string(n) + ",)");
  }
  const std::span<const double> numbers(array.data(), n);
  for (const double number : numbers) finite_number(number, what);
  return numbers;
}

Doubles points_array(std::span<const Vec2> points) {
  Doubles array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  auto values = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    values(static_cast<py::ssize_t>(i), 0) = points[i].x();
    values(static_cast<py::ssize_t>(i), 1) = points[i].y();
  }
  return array;
}

double finite_number(double number, const char* what) {
  if (!std::isfinite(number)) {
    throw std::invalid_argument(std::string(what) + ": " + std::to_string(number) +
                                "; allowed: a finite number");
  }
  return number;
}

}  // namespace pedzone
