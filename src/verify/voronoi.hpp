// Densities and speeds by Voronoi cells (Steffen and Seyfried 2010): each person has the part of
// the walkable area that is nearer to it than to anybody else, and its density is one over that.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/polygon.hpp"

namespace pedzone::verify {

class VoronoiCells {
 public:
  /// Cells of the people at `points` [m] in `walkable`. Of a cell that walls part, the part with
  /// its person counts. `most`: cells end so far [m] from their person (a polygon of 16 sides round
  /// that circle); unset: at walls only. Points outside `walkable` have no cell.
  VoronoiCells(const Region& walkable, std::span<const Vec2> points,
               std::optional<double> most = {});

  std::size_t size() const { return cells_.size(); }
  const Region& cell(std::size_t person) const { return cells_[person]; }
  /// [m²]; 0 where a person has no cell.
  double area(std::size_t person) const { return areas_[person]; }
  /// [m²] of the person's cell within a convex ring that runs counter-clockwise.
  double area_within(std::size_t person, const Ring& convex) const;

  /// Mean density [persons/m²] in the ring: each cell counts by its share of the ring's area.
  double density(const Ring& convex) const;
  /// Mean of one value a person in the ring, by the area of the cells there; none where none is.
  std::optional<double> mean(std::span<const double> values, const Ring& convex) const;

 private:
  std::vector<Region> cells_;
  std::vector<double> areas_;
};

/// The part of a ring on the left of the line from `a` to `b` (where that is not convex, its parts
/// may hang together by edges of no width; the area is right).
Ring left_part(const Ring& ring, const Vec2& a, const Vec2& b);

}  // namespace pedzone::verify
