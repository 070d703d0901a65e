// The arrangement: edges cut until they meet in end points only, by snap rounding (Hobby, Practical
// segment intersection with finite precision output, 1999). Each end point and each rounded
// crossing makes its grid cell hot; each edge is led through the centres of all hot cells that it
// passes. Rounding crossings alone would not do: it moves edges across corners next to them, and
// for nearly parallel edges that makes new crossings millimetre by millimetre.
#include <algorithm>
#include <cmath>

#include "geometry/overlay.hpp"

namespace pedzone::overlay {
namespace {

__extension__ using Wide = __int128;  // products of coordinate differences

constexpr double kGridPerMetre = 1000.0;
// Coordinates beyond it are clamped [mm]: 8 · (2 · 10¹¹)³, the largest product, fits into 127 bits.
constexpr double kLargest = 1e11;
// One round does it by theory; more are a guard.
constexpr int kMaxRounds = 20;

struct Cut {
  std::uint32_t edge;
  GridPoint point;
};

Wide cross(const GridPoint& origin, const GridPoint& p, const GridPoint& q) {
  return Wide(p.x - origin.x) * (q.y - origin.y) - Wide(p.y - origin.y) * (q.x - origin.x);
}

int sign(Wide value) { return (value > 0) - (value < 0); }

/// Halves are rounded up, as grid cells are half-open.
std::int64_t divide_rounded(Wide numerator, Wide denominator) {
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  const Wide twice = 2 * numerator + denominator;
  const Wide quotient = twice / (2 * denominator);
  return static_cast<std::int64_t>(quotient - (twice < quotient * 2 * denominator));
}

/// Where two properly crossing edges meet, rounded to the grid.
GridPoint crossing(const BorderPiece& e, const BorderPiece& f) {
  const Wide start = cross(f.from, f.to, e.from);
  const Wide end = cross(f.from, f.to, e.to);
  const Wide span = start - end;
  return {e.from.x + divide_rounded(start * (e.to.x - e.from.x), span),
          e.from.y + divide_rounded(start * (e.to.y - e.from.y), span)};
}

bool within_box(const BorderPiece& e, const GridPoint& p) {
  const auto [low, high] = std::minmax(e.from.y, e.to.y);
  return p.x >= e.from.x && p.x <= e.to.x && p.y >= low && p.y <= high;
}

void cut_at(const std::vector<BorderPiece>& edges, std::uint32_t index, const GridPoint& point,
            std::vector<Cut>& cuts) {
  const BorderPiece& e = edges[index];
  if (point != e.from && point != e.to) cuts.push_back({index, point});
}

/// Notes where edges i and j have to be cut.
void meet(const std::vector<BorderPiece>& edges, std::uint32_t i, std::uint32_t j,
          std::vector<Cut>& cuts) {
  const BorderPiece& e = edges[i];
  const BorderPiece& f = edges[j];
  const int f_from = orientation(e.from, e.to, f.from), f_to = orientation(e.from, e.to, f.to);
  if (f_from * f_to > 0) return;
  const int e_from = orientation(f.from, f.to, e.from), e_to = orientation(f.from, f.to, e.to);
  if (e_from * e_to > 0) return;
  if (f_from == 0 && within_box(e, f.from)) cut_at(edges, i, f.from, cuts);
  if (f_to == 0 && within_box(e, f.to)) cut_at(edges, i, f.to, cuts);
  if (e_from == 0 && within_box(f, e.from)) cut_at(edges, j, e.from, cuts);
  if (e_to == 0 && within_box(f, e.to)) cut_at(edges, j, e.to, cuts);
  if (f_from * f_to < 0 && e_from * e_to < 0) {
    const GridPoint point = crossing(e, f);
    cut_at(edges, i, point, cuts);
    cut_at(edges, j, point, cuts);
  }
}

/// An edge that the sweep by x has come to, and its extent.
struct Active {
  std::int64_t end, low, high;
  std::uint32_t index;

  static Active of(const BorderPiece& edge, std::uint32_t index) {
    const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
    return {edge.to.x, low, high, index};
  }
};

/// All cuts between edges of which at least one is fresh. `edges` are sorted by `from`: going
/// through them by x, only those that have not ended yet are looked at.
std::vector<Cut> find_cuts(const std::vector<BorderPiece>& edges, const std::vector<char>& fresh) {
  std::vector<Cut> cuts;
  std::vector<Active> active;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const Active current = Active::of(edges[i], i);
    std::size_t kept = 0;
    for (const Active other : active) {
      if (other.end < edges[i].from.x) continue;
      active[kept++] = other;
      if (other.low > current.high || other.high < current.low) continue;
      if (!fresh[i] && !fresh[other.index]) continue;
      meet(edges, i, other.index, cuts);
    }
    active.resize(kept);
    active.push_back(current);
  }
  return cuts;
}

/// Whether an edge passes the grid cell round a point: the half-open square [-½, ½)² round it.
bool passes(const BorderPiece& e, const GridPoint& p) {
  // In half grid steps: the cell's corners are odd numbers then, and nothing ends on its rim.
  const GridPoint from{2 * e.from.x, 2 * e.from.y}, to{2 * e.to.x, 2 * e.to.y};
  const std::int64_t x = 2 * p.x, y = 2 * p.y;
  const int lower_left = orientation(from, to, {x - 1, y - 1});
  const int lower_right = orientation(from, to, {x + 1, y - 1});
  const int upper_left = orientation(from, to, {x - 1, y + 1});
  const int upper_right = orientation(from, to, {x + 1, y + 1});
  const int most = std::max({lower_left, lower_right, upper_left, upper_right});
  const int least = std::min({lower_left, lower_right, upper_left, upper_right});
  // Of the cell's corners only the lower left one belongs to it.
  return (most > 0 && least < 0) || lower_left == 0;
}

/// All places where an edge passes a hot cell: end points and cuts.
std::vector<Cut> find_hot_cells(const std::vector<BorderPiece>& edges,
                                const std::vector<Cut>& crossings) {
  std::vector<GridPoint> hot;
  hot.reserve(2 * edges.size() + crossings.size());
  for (const BorderPiece& edge : edges) {
    hot.push_back(edge.from);
    hot.push_back(edge.to);
  }
  for (const Cut& cut : crossings) hot.push_back(cut.point);
  std::sort(hot.begin(), hot.end());
  hot.erase(std::unique(hot.begin(), hot.end()), hot.end());

  std::vector<Cut> cuts;
  std::vector<Active> active;
  std::uint32_t next = 0;
  for (const GridPoint& point : hot) {
    for (; next < edges.size() && edges[next].from.x <= point.x; ++next) {
      active.push_back(Active::of(edges[next], next));
    }
    std::size_t kept = 0;
    for (const Active other : active) {
      if (other.end < point.x) continue;
      active[kept++] = other;
      if (point.y < other.low || point.y > other.high) continue;
      if (passes(edges[other.index], point)) cut_at(edges, other.index, point, cuts);
    }
    active.resize(kept);
  }
  return cuts;
}

void push_piece(const GridPoint& from, const GridPoint& to, const Winding& step,
                std::vector<BorderPiece>& out) {
  if (from < to) {
    out.push_back({from, to, step, {}});
  } else if (to < from) {
    out.push_back({to, from, {-step.a, -step.b}, {}});
  }
}

/// Replaces the edges that are cut by their pieces, which come behind `untouched`.
std::size_t apply_cuts(std::vector<BorderPiece>& edges, std::vector<Cut>& cuts) {
  std::sort(cuts.begin(), cuts.end(), [&](const Cut& s, const Cut& t) {
    if (s.edge != t.edge) return s.edge < t.edge;
    const BorderPiece& e = edges[s.edge];
    const auto along = [&](const GridPoint& p) {
      return Wide(p.x - e.from.x) * (e.to.x - e.from.x) +
             Wide(p.y - e.from.y) * (e.to.y - e.from.y);
    };
    return along(s.point) < along(t.point);
  });
  std::vector<BorderPiece> untouched, pieces;
  untouched.reserve(edges.size());
  auto cut = cuts.begin();
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (cut == cuts.end() || cut->edge != i) {
      untouched.push_back(edges[i]);
      continue;
    }
    GridPoint start = edges[i].from;
    for (; cut != cuts.end() && cut->edge == i; ++cut) {
      push_piece(start, cut->point, edges[i].step, pieces);
      start = cut->point;
    }
    push_piece(start, edges[i].to, edges[i].step, pieces);
  }
  const std::size_t old = untouched.size();
  edges = std::move(untouched);
  edges.insert(edges.end(), pieces.begin(), pieces.end());
  return old;
}

bool in_sweep_order(const BorderPiece& e, const BorderPiece& f) {
  if (e.from != f.from) return e.from < f.from;
  const int turn = orientation(e.from, e.to, f.to);
  return turn != 0 ? turn > 0 : e.to < f.to;
}

/// Sorts, and merges equal edges; those whose steps cancel out go. Edges from index `fresh_from`
/// on are fresh; returns the flags in the new order.
std::vector<char> merge_equal(std::vector<BorderPiece>& edges, std::size_t fresh_from) {
  std::vector<std::uint32_t> order(edges.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return in_sweep_order(edges[i], edges[j]); });
  std::vector<BorderPiece> merged;
  std::vector<char> fresh;
  merged.reserve(edges.size());
  for (std::size_t i = 0; i < order.size();) {
    BorderPiece edge = edges[order[i]];
    bool is_fresh = order[i] >= fresh_from;
    for (++i;
         i < order.size() && edges[order[i]].from == edge.from && edges[order[i]].to == edge.to;
         ++i) {
      edge.step.a += edges[order[i]].step.a;
      edge.step.b += edges[order[i]].step.b;
      is_fresh = is_fresh && order[i] >= fresh_from;
    }
    if (edge.step.a == 0 && edge.step.b == 0) continue;
    merged.push_back(edge);
    fresh.push_back(is_fresh);
  }
  edges = std::move(merged);
  return fresh;
}

}  // namespace

GridPoint to_grid(const Vec2& point) {
  const auto coordinate = [](double metres) {
    const double value = std::clamp(metres * kGridPerMetre, -kLargest, kLargest);
    return static_cast<std::int64_t>(std::llround(value));
  };
  return {coordinate(point.x()), coordinate(point.y())};
}

Vec2 from_grid(const GridPoint& point) {
  return {static_cast<double>(point.x) / kGridPerMetre,
          static_cast<double>(point.y) / kGridPerMetre};
}

int orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return sign(cross(a, b, c));
}

bool is_arranged(const std::vector<BorderPiece>& edges) {
  return find_cuts(edges, std::vector<char>(edges.size(), 1)).empty();
}

void merge(std::vector<BorderPiece>& edges) { merge_equal(edges, 0); }

void arrange(std::vector<BorderPiece>& edges) {
  std::vector<char> fresh = merge_equal(edges, 0);
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<Cut> crossings = find_cuts(edges, fresh);
    if (crossings.empty()) return;
    std::vector<Cut> cuts = find_hot_cells(edges, crossings);
    fresh = merge_equal(edges, apply_cuts(edges, cuts));
  }
}

}  // namespace pedzone::overlay
