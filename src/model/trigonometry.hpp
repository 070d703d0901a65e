// Sine and cosine by polynomials: faster than the C library's, the same bits on every machine and
// exactly odd and even, so that mirrored scenes stay mirrored.
#pragma once

#include "core/vec.hpp"
#include "model/fixed_point.hpp"

namespace pedzone {

struct SineCosine {
  double sin, cos;
};

/// Sine and cosine of an angle [rad] in [-2·pi, 2·pi], to 1e-11 (single precision holds 6e-8).
inline SineCosine sine_cosine(double angle) {
  // Taylor series about the nearest multiple of pi/2; the next terms are below 7e-12 at pi/4.
  const double quarters = nearest_integer(angle * (2.0 / kPi));
  const double r = angle - quarters * (kPi / 2.0);
  const double r2 = r * r;
  const double s =
      r + r * r2 *
              (-1.0 / 6 +
               r2 * (1.0 / 120 + r2 * (-1.0 / 5040 + r2 * (1.0 / 362880 - r2 * (1.0 / 39916800)))));
  const double c =
      1.0 + r2 * (-1.0 / 2 +
                  r2 * (1.0 / 24 +
                        r2 * (-1.0 / 720 + r2 * (1.0 / 40320 +
                                                 r2 * (-1.0 / 3628800 + r2 * (1.0 / 479001600))))));
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

/// The same angle [rad] in [-pi, pi]; cheap for what is there already.
inline double wrapped(double angle) {
  return angle >= -kPi && angle <= kPi ? angle : wrap_angle(angle);
}

}  // namespace pedzone
