// The velocity nearest to a wanted one among those that half-planes and a greatest speed allow.
#pragma once

#include <span>
#include <vector>

#include "core/vec.hpp"

namespace pedzone {

/// Velocities v with normal·v ≥ least.
struct HalfPlane {
  Vec2 normal;   ///< unit vector
  double least;  ///< [m/s]
};

/// The linear programs of van den Berg et al. 2011, sections 5.1 to 5.3. Keeps room for its work;
/// no allocation once sizes have settled.
class HalfPlaneProgram {
 public:
  /// The velocity with |v| ≤ most [m/s] nearest to `wanted` in all half-planes. The first `hard`
  /// of them must have a velocity in common with that disc. Where all together have none: the one
  /// in the hard ones that violates the others least (the largest of their shortfalls is least).
  Vec2 solve(std::span<const HalfPlane> planes, std::size_t hard, double most, const Vec2& wanted);

 private:
  std::vector<HalfPlane> work_;
};

}  // namespace pedzone
