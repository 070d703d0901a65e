// Winding numbers by a sweep over the arranged edges, and rings from the pieces of border.
#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/overlay.hpp"

namespace pedzone::overlay {
namespace {

/// Order from bottom to top of edges that the sweep line meets at the same time.
struct Lower {
  const std::vector<BorderPiece>* edges;
  bool operator()(int i, int j) const {
    const BorderPiece& e = (*edges)[i];
    const BorderPiece& f = (*edges)[j];
    if (e.from == f.from) {
      const int turn = orientation(e.from, e.to, f.to);
      return turn != 0 ? turn > 0 : i < j;
    }
    const bool e_first = e.from < f.from;
    const int side =
        e_first ? orientation(e.from, e.to, f.from) : -orientation(f.from, f.to, e.from);
    return side != 0 ? side > 0 : i < j;
  }
};

/// Calls visit(edge, edge under its `from` or -1) for all edges in sweep order.
template <class Visit>
void sweep(const std::vector<BorderPiece>& edges, Visit visit) {
  const int count = static_cast<int>(edges.size());
  std::vector<int> ends(count);
  for (int i = 0; i < count; ++i) ends[i] = i;
  std::sort(ends.begin(), ends.end(), [&](int i, int j) { return edges[i].to < edges[j].to; });
  using Status = std::set<int, Lower>;
  Status status(Lower{&edges});
  std::vector<Status::iterator> place(count, status.end());
  int ended = 0;
  for (int i = 0; i < count; ++i) {
    for (; ended < count && edges[ends[ended]].to <= edges[i].from; ++ended) {
      status.erase(place[ends[ended]]);
    }
    place[i] = status.insert(i).first;
    visit(i, place[i] == status.begin() ? -1 : *std::prev(place[i]));
  }
}

/// Border pieces directed so that inside is to their left, chained face by face.
class Tracer {
 public:
  Tracer(const std::vector<BorderPiece>& labelled, Inside inside);
  Region region();

 private:
  struct Chain {
    std::vector<int> pieces;
    double area = 0.0;  ///< [mm²] negative for holes
    int parent = -1;    ///< outer ring of a hole
  };

  GridPoint start(int piece) const {
    return forward_[piece] ? border_[piece].from : border_[piece].to;
  }
  GridPoint end(int piece) const {
    return forward_[piece] ? border_[piece].to : border_[piece].from;
  }
  void link();
  int next_piece(int piece) const;
  void walk(int first);
  void close_chain(std::vector<int> pieces);
  void find_parents();
  Ring ring_of(const Chain& chain) const;

  std::vector<BorderPiece> border_;
  std::vector<char> forward_;
  std::vector<int> by_start_;   ///< pieces ordered by start vertex
  std::vector<int> vertex_;     ///< start vertex number of each piece
  std::vector<int> first_out_;  ///< of each vertex: first place in by_start_
  std::vector<int> end_vertex_;
  std::vector<char> used_;
  std::vector<int> on_stack_;  ///< of each vertex: its place in the walk, -1
  std::vector<int> chain_of_;  ///< of each piece
  std::vector<Chain> chains_;
};

Tracer::Tracer(const std::vector<BorderPiece>& labelled, Inside inside) {
  for (const BorderPiece& edge : labelled) {
    const bool below = inside(edge.below);
    const bool above = inside({edge.below.a + edge.step.a, edge.below.b + edge.step.b});
    if (below == above) continue;
    border_.push_back(edge);
    forward_.push_back(above);
  }
}

void Tracer::link() {
  const int count = static_cast<int>(border_.size());
  by_start_.resize(count);
  for (int i = 0; i < count; ++i) by_start_[i] = i;
  std::sort(by_start_.begin(), by_start_.end(), [&](int i, int j) {
    const GridPoint p = start(i), q = start(j);
    return p != q ? p < q : i < j;
  });
  vertex_.assign(count, -1);
  std::vector<GridPoint> points;
  for (int k = 0; k < count; ++k) {
    const GridPoint p = start(by_start_[k]);
    if (points.empty() || points.back() != p) {
      points.push_back(p);
      first_out_.push_back(k);
    }
    vertex_[by_start_[k]] = static_cast<int>(points.size()) - 1;
  }
  first_out_.push_back(count);
  end_vertex_.assign(count, -1);
  for (int i = 0; i < count; ++i) {
    const auto found = std::lower_bound(points.begin(), points.end(), end(i));
    if (found != points.end() && *found == end(i)) {
      end_vertex_[i] = static_cast<int>(found - points.begin());
    }
  }
  used_.assign(count, 0);
  chain_of_.assign(count, -1);
  on_stack_.assign(points.size(), -1);
}

/// The piece that goes on along the same inside face: the first one clockwise from the way back.
int Tracer::next_piece(int piece) const {
  const int vertex = end_vertex_[piece];
  if (vertex < 0) return -1;
  const GridPoint v = end(piece), back = start(piece);
  const auto after_half_turn = [&](const GridPoint& p) { return orientation(v, back, p) >= 0; };
  int best = -1;
  for (int k = first_out_[vertex]; k < first_out_[vertex + 1]; ++k) {
    const int candidate = by_start_[k];
    if (best < 0) {
      best = candidate;
      continue;
    }
    const GridPoint p = end(candidate), q = end(best);
    const bool p_late = after_half_turn(p), q_late = after_half_turn(q);
    if (p_late != q_late ? q_late : orientation(v, p, q) < 0) best = candidate;
  }
  return best < 0 || used_[best] ? -1 : best;
}

/// Follows one face's border; cuts off a ring whenever the walk comes to a vertex again.
void Tracer::walk(int first) {
  std::vector<int> stack;
  for (int piece = first; piece >= 0; piece = next_piece(piece)) {
    used_[piece] = 1;
    on_stack_[vertex_[piece]] = static_cast<int>(stack.size());
    stack.push_back(piece);
    const int vertex = end_vertex_[piece];
    if (vertex < 0 || on_stack_[vertex] < 0) continue;
    const auto loop = stack.begin() + on_stack_[vertex];
    for (auto it = loop; it != stack.end(); ++it) on_stack_[vertex_[*it]] = -1;
    close_chain({loop, stack.end()});
    stack.erase(loop, stack.end());
    if (stack.empty()) break;
  }
  for (const int piece : stack) on_stack_[vertex_[piece]] = -1;
}

void Tracer::close_chain(std::vector<int> pieces) {
  const GridPoint origin = start(pieces.front());
  double twice_area = 0.0;
  for (const int piece : pieces) {
    const GridPoint p = start(piece), q = end(piece);
    twice_area += static_cast<double>(p.x - origin.x) * static_cast<double>(q.y - origin.y) -
                  static_cast<double>(q.x - origin.x) * static_cast<double>(p.y - origin.y);
    chain_of_[piece] = static_cast<int>(chains_.size());
  }
  chains_.push_back({std::move(pieces), 0.5 * twice_area, -1});
}

/// A hole lies in the face above the piece that is right under its leftmost point.
void Tracer::find_parents() {
  std::vector<char> seen(chains_.size(), 0);
  sweep(border_, [&](int piece, int under) {
    const int chain = chain_of_[piece];
    if (chain < 0 || seen[chain]) return;
    seen[chain] = 1;
    if (chains_[chain].area >= 0.0 || under < 0 || chain_of_[under] < 0) return;
    const Chain& other = chains_[chain_of_[under]];
    chains_[chain].parent = other.area > 0.0 ? chain_of_[under] : other.parent;
  });
}

/// The corners of a chain; points in straight pieces of border are left out.
Ring Tracer::ring_of(const Chain& chain) const {
  const std::size_t count = chain.pieces.size();
  Ring ring;
  for (std::size_t i = 0; i < count; ++i) {
    const int before = chain.pieces[(i + count - 1) % count], piece = chain.pieces[i];
    if (orientation(start(before), start(piece), end(piece)) == 0) continue;
    ring.push_back(from_grid(start(piece)));
  }
  return ring;
}

Region Tracer::region() {
  if (border_.empty()) return {};
  link();
  for (const int piece : by_start_) {
    if (!used_[piece]) walk(piece);
  }
  find_parents();
  Region result;
  std::vector<int> place(chains_.size(), -1);
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    if (chains_[i].area <= 0.0) continue;
    place[i] = static_cast<int>(result.size());
    result.push_back({ring_of(chains_[i]), {}});
  }
  for (const Chain& chain : chains_) {
    if (chain.area >= 0.0 || chain.parent < 0) continue;
    result[place[chain.parent]].holes.push_back(ring_of(chain));
  }
  return result;
}

}  // namespace

std::vector<int> label(std::vector<BorderPiece>& edges) {
  std::vector<int> under(edges.size(), -1);
  sweep(edges, [&](int i, int below) {
    under[i] = below;
    if (below < 0) return;
    const BorderPiece& other = edges[below];
    edges[i].below = {other.below.a + other.step.a, other.below.b + other.step.b};
  });
  return under;
}

Region trace(const std::vector<BorderPiece>& labelled, Inside inside) {
  return Tracer(labelled, inside).region();
}

}  // namespace pedzone::overlay
