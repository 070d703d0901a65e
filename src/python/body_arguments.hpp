// Bodies as Python gives them to measures.
#pragma once

#include <stdexcept>
#include <vector>

#include "conflict/approach.hpp"
#include "python/arrays.hpp"

namespace pedzone {

/// [m] Throws std::invalid_argument where one is not positive.
inline Sizes sizes_of(double length, double width, double radius) {
  if (!(length > 0.0 && width > 0.0 && radius > 0.0)) {
    throw std::invalid_argument("length, width, radius: allowed: more than 0 m");
  }
  return {0.5 * length, 0.5 * width, radius};
}

}  // namespace pedzone
