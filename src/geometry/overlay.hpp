// Boolean operations on rings, exact on a grid of whole millimetres. Used by polygon.cpp only.
//
//   add rings of one or two operands  →  cut the edges where they meet (arrangement)
//   →  winding numbers on both sides of every piece (sweep)  →  keep the pieces that separate
//   inside from outside  →  chain them into rings (tracing)
//
// All decisions are taken with integers, so there are no nearly collinear edges and no tolerance:
// two edges cross, touch or do neither. Rounding a crossing to the grid moves edges by less than
// one millimetre; the cut is repeated until nothing crosses any more.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "geometry/polygon.hpp"

namespace pedzone::overlay {

/// A point of the grid [mm].
struct GridPoint {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const GridPoint&) const = default;
};

GridPoint to_grid(const Vec2& point);
Vec2 from_grid(const GridPoint& point);

/// How often each operand's rings wind round a place (or what crossing an edge adds to that).
struct Winding {
  int a = 0, b = 0;
};

/// A piece of border, `from` < `to` lexicographically (so "left" of it is above it).
struct BorderPiece {
  GridPoint from, to;
  Winding step;   ///< what crossing it from right to left adds
  Winding below;  ///< winding numbers on its right (set by label)
};

/// Positive: c is to the left of a → b; zero: on the line through them. Exact.
int orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c);

/// Cuts edges until they meet in end points only; merges equal ones. Sorted as label needs them.
void arrange(std::vector<BorderPiece>& edges);

/// Sets `below` of arranged edges. Returns for each edge the index of the edge right under its
/// `from`, or -1.
std::vector<int> label(std::vector<BorderPiece>& edges);

/// Whether the edges of a sorted, merged list meet in end points only.
bool is_arranged(const std::vector<BorderPiece>& edges);

/// Sorts, and merges equal edges; those whose steps cancel out go.
void merge(std::vector<BorderPiece>& edges);

/// Which winding numbers are inside.
using Inside = bool (*)(const Winding&);

/// Chains the pieces that have inside on one side only into simple rings with their holes.
Region trace(const std::vector<BorderPiece>& labelled, Inside inside);

/// Collects operands, then gives the result of an operation.
class Overlay {
 public:
  enum class Operand { kA, kB };

  /// The ring as it runs: winding number +1 inside where it runs counter-clockwise.
  void add(const Ring& ring, Operand operand);
  /// The ring turned counter-clockwise (clockwise if `hole`) first.
  void add_turned(const Ring& ring, Operand operand, bool hole);
  /// What is within the outer rings and in no hole, whatever crosses or overlaps.
  void add(const Region& region, Operand operand);

  Region result(Inside inside);

 private:
  void add(const Polygon& polygon, Operand operand);

  std::vector<BorderPiece> edges_;
};

}  // namespace pedzone::overlay
