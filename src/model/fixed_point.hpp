// Positions as integers on a lattice, so that differences are exact: a decision does not depend
// on where in the network (thousands of metres from its origin) a scene lies, nor on its mirroring.
#pragma once

#include <cstdint>

namespace pedzone {

/// Nearest integer, ties to even; |x| below 2^51, default rounding mode.
inline double nearest_integer(double x) {
  constexpr double kShift = 6755399441055744.0;  // 1.5·2^52: the sum's last bit is worth 1
  return (x + kShift) - kShift;
}

/// Lattice points per metre. Numerical: 61 µm are far below what a step moves anybody; 32 bits
/// then span ±131 km, and differences up to 1 km are exact in single precision.
inline constexpr double kLatticePerMetre = 16384.0;
inline constexpr float kMetrePerLattice = 1.0F / 16384.0F;

/// Corner from which one zone's lattice counts; any lattice point gives the same decisions.
struct LatticeOrigin {
  std::int64_t x = 0, y = 0;
};

/// Nearest lattice coordinate of `metres` [m]. Ties go to even, so mirroring is exact.
inline std::int64_t to_lattice(double metres) {
  return static_cast<std::int64_t>(nearest_integer(metres * kLatticePerMetre));
}

struct LatticePoint {
  std::int32_t x = 0, y = 0;
};

inline LatticePoint to_lattice(double x, double y, const LatticeOrigin& origin) {
  return {static_cast<std::int32_t>(to_lattice(x) - origin.x),
          static_cast<std::int32_t>(to_lattice(y) - origin.y)};
}

/// [m] a − b, exact up to 1 km.
inline float lattice_difference(std::int32_t a, std::int32_t b) {
  return static_cast<float>(a - b) * kMetrePerLattice;
}

}  // namespace pedzone
