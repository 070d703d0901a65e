// Every pass reads the places after the pass before and writes new ones (Jacobi), and the pushes
// on one body are summed as integers, so neither the order of persons nor the number of threads
// can change a bit of the result. Who walks into a contact gives way in it: a standing person is
// not shoved by one that walks up to it, but makes way for half of it to one that squeezes.
#include "crowd/motion/contacts.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "core/random.hpp"
#include "crowd/state/parallel.hpp"

namespace pedzone {
namespace {

constexpr int kPasses = 4;             // numerical: see the pile of bodies in the tests
constexpr int kCorePasses = 24;        // numerical: with 8, in dense counterflow of wide bodies
                                       // some are left 1 cm nearer than turned shoulders allow
constexpr double kPushPerPass = 0.05;  // [m] numerical: a pile comes apart in steps, no jumps
constexpr double kEvenShare = 1e-4;    // [m] numerical: bodies that both stand share a push evenly
constexpr double kHindered = 0.5;      // assumed: share of its way that a push must take from it
constexpr double kCoincident = 1e-9;   // [m] numerical: no direction between centres so near
// Numerical: what a block's list holds from the start, so that it need not grow step by step.
// A person at four persons per square metre has about eight neighbours.
constexpr std::size_t kNeighbours = 8 * kBlock;
constexpr double kUnitsPerMetre = 0x1p40;  // numerical: sums of pushes are exact to 1e-12 m

/// A sum of vectors that does not depend on the order of its terms.
class ExactSum {
 public:
  void add(const Vec2& v) {
    x_ += static_cast<std::int64_t>(v.x() * kUnitsPerMetre);
    y_ += static_cast<std::int64_t>(v.y() * kUnitsPerMetre);
    ++terms_;
  }
  int terms() const { return terms_; }
  Vec2 value() const {
    return {static_cast<double>(x_) / kUnitsPerMetre, static_cast<double>(y_) / kUnitsPerMetre};
  }

 private:
  std::int64_t x_ = 0, y_ = 0;
  int terms_ = 0;
};

/// Direction in which body i leaves body j where both centres coincide: any, but the opposite of
/// what j gets, and the same for the same pair in every order.
Vec2 parting_direction(const CrowdState& crowd, std::size_t i, std::size_t j) {
  const std::uint64_t key_i = crowd.persons.key[i], key_j = crowd.persons.key[j];
  const std::uint64_t low = std::min(key_i, key_j), high = std::max(key_i, key_j);
  const Vec2 e = unit(2.0 * kPi * random_uniform(crowd.seed ^ low, high, 0, Purpose::kTieBreak));
  const bool forward = key_i != key_j ? key_i < key_j : i < j;
  return forward ? e : Vec2(-e);
}

/// What must not overlap: bodies as they hold their shoulders now; then, in what the passes over
/// those have left, bodies with the shoulders turned all the way.
enum class Part : std::uint8_t { kBody, kCore };

double reach_of(const Persons& persons, Part part, std::size_t i, std::size_t j) {
  const std::vector<double>& radius =
      part == Part::kBody ? persons.present_radius : persons.turned_radius;
  return radius[i] + radius[j];
}

/// How far body i has to be pushed by body j, and in which direction. Zero when they do not
/// overlap. `start` and `now` are i's place relative to j's before and after the move.
Vec2 push_of_pair(const CrowdState& crowd, Part part, std::size_t i, std::size_t j,
                  const Vec2& start, const Vec2& now) {
  const double reach = reach_of(crowd.persons, part, i, j);
  const bool passed_through = now.dot(start) < 0.0;
  if (!passed_through && now.squaredNorm() >= reach * reach) return Vec2::Zero();
  Vec2 normal = passed_through ? start : now;
  if (normal.norm() < kCoincident) normal = start;
  const double length = normal.norm();
  normal = length < kCoincident ? parting_direction(crowd, i, j) : Vec2(normal / length);
  const double overlap = reach - now.dot(normal);
  if (j >= crowd.persons.walking) return overlap * normal;
  if (part == Part::kCore ||
      crowd.jams[crowd.handle(i)].squeezes() != crowd.jams[crowd.handle(j)].squeezes()) {
    return 0.5 * overlap * normal;
  }
  const Moves& moves = crowd.moves;
  const double into_j = std::max(0.0, -(moves.dx[i] * normal.x() + moves.dy[i] * normal.y()));
  const double into_i = std::max(0.0, moves.dx[j] * normal.x() + moves.dy[j] * normal.y());
  const double share = (into_j + kEvenShare) / (into_j + into_i + 2.0 * kEvenShare);
  return overlap * share * normal;
}

void prepare_lists(std::size_t persons, std::vector<std::vector<std::uint32_t>>& lists) {
  for (std::size_t n = lists.size(); n < block_count(persons); ++n) {
    lists.emplace_back().reserve(kNeighbours);
  }
}

/// Whether the push takes a good part of the way that the person means to make.
bool hinders(const Vec2& push, const Moves& moves, std::size_t i) {
  const Vec2 move(moves.dx[i], moves.dy[i]);
  return -push.dot(move) > kHindered * move.squaredNorm();
}

/// Where person i is after its contacts of one pass; nothing where it has none.
std::optional<Vec2> pushed(const CrowdState& crowd, Part part, std::size_t block, std::size_t i,
                           WalkState& walker) {
  const Moves& moves = crowd.moves;
  const Vec2 here(moves.x[i], moves.y[i]);
  ExactSum sum;
  for (const std::uint32_t j : crowd.near.of(block, i)) {
    const Vec2 now = here - Vec2(moves.x[j], moves.y[j]);
    const Vec2 start = crowd.position(i) - crowd.position(j);
    const Vec2 push = push_of_pair(crowd, part, i, j, start, now);
    if (push != Vec2::Zero()) sum.add(push);
  }
  if (sum.terms() == 0) return std::nullopt;
  walker.pressed = walker.pressed || hinders(sum.value(), moves, i);
  // With many contacts their sum overshoots (each pair counts on itself alone).
  Vec2 push = sum.value() * (2.0 / (sum.terms() + 1.0));
  const double most = kPushPerPass + std::hypot(moves.dx[i], moves.dy[i]);
  if (push.norm() > most) push *= most / push.norm();
  return kept_inside(crowd.walls_of(i), crowd.position(i), here + push,
                     crowd.persons.present_radius[i], walker.wall_room);
}

/// One pass over all contacts; whether there were any.
bool push_apart(const CrowdState& crowd, Part part, std::vector<WalkState>& walkers, Moves& moves) {
  std::atomic<bool> touching = false;
  for_each_block(crowd.persons.walking,
                 [&](std::size_t block, std::size_t first, std::size_t last) {
                   bool touches = false;  // somebody of this block
                   for (std::size_t i = first; i < last; ++i) {
                     const std::optional<Vec2> at = pushed(crowd, part, block, i, walkers[i]);
                     moves.next_x[i] = at ? at->x() : moves.x[i];
                     moves.next_y[i] = at ? at->y() : moves.y[i];
                     touches = touches || at;
                   }
                   if (touches) touching = true;
                 });
  moves.x.swap(moves.next_x);
  moves.y.swap(moves.next_y);
  return touching;
}

}  // namespace

void find_neighbours(const CrowdState& crowd, BodyGrid& grid, Neighbourhood& near) {
  const Persons& persons = crowd.persons;
  if (persons.size() == 0) return;
  prepare_lists(persons.size(), near.lists);
  const double widest = *std::max_element(persons.radius.begin(), persons.radius.end());
  const double slack = 2.0 * (crowd.moves.reach + kPushPerPass);
  grid.build(persons.x, persons.y, 2.0 * widest + slack);
  near.first.resize(persons.walking);
  near.last.resize(persons.walking);
  for_each_block(persons.walking, [&](std::size_t block, std::size_t first, std::size_t last) {
    std::vector<std::uint32_t>& list = near.lists[block];
    list.clear();
    for (std::size_t i = first; i < last; ++i) {
      near.first[i] = static_cast<std::uint32_t>(list.size());
      const Vec2 here = crowd.position(i);
      const double own = persons.radius[i] + slack;
      const Vec2 box = Vec2::Constant(own + widest);
      grid.visit_box(here - box, here + box, [&](std::uint32_t j, const Vec2& there) {
        const double reach = own + persons.radius[j];
        if (j != i && (there - here).squaredNorm() < reach * reach) list.push_back(j);
      });
      near.last[i] = static_cast<std::uint32_t>(list.size());
    }
  });
}

void forget_neighbours(const CrowdState& crowd, Neighbourhood& near) {
  prepare_lists(crowd.persons.size(), near.lists);
  near.first.assign(crowd.persons.walking, 0);
  near.last.assign(crowd.persons.walking, 0);
}

void move_freely(const CrowdState& crowd, std::vector<WalkState>& walkers, Moves& moves) {
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Vec2 from = crowd.position(i);
      const Vec2 to = from + Vec2(moves.dx[i], moves.dy[i]);
      const Vec2 at = kept_inside(crowd.walls_of(i), from, to, crowd.persons.present_radius[i],
                                  walkers[i].wall_room);
      moves.x[i] = at.x();
      moves.y[i] = at.y();
    }
  });
  for (std::size_t j = crowd.persons.walking; j < crowd.persons.size(); ++j) {
    moves.x[j] = moves.next_x[j] = crowd.persons.x[j] + moves.dx[j];
    moves.y[j] = moves.next_y[j] = crowd.persons.y[j] + moves.dy[j];
  }
}

void settle_contacts(const CrowdState& crowd, std::vector<WalkState>& walkers, Moves& moves) {
  for (int pass = 0; pass < kPasses; ++pass) {
    if (!push_apart(crowd, Part::kBody, walkers, moves)) break;
  }
  settle_cores(crowd, walkers, moves);
}

bool settle_cores(const CrowdState& crowd, std::vector<WalkState>& walkers, Moves& moves) {
  int pass = 0;
  while (pass < kCorePasses && push_apart(crowd, Part::kCore, walkers, moves)) ++pass;
  return pass > 0;
}

/// What a contact stopped is taken from the velocity; a push never adds to it.
void commit(const CrowdState& crowd, std::vector<WalkState>& walkers, Persons& persons,
            Moves& moves) {
  for_each_block(persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Vec2 way = Vec2(moves.x[i], moves.y[i]) - crowd.position(i);
      const Vec2 push = way - Vec2(moves.dx[i], moves.dy[i]);
      const double length = push.norm();
      walkers[i].wall_room.spend(way.norm());
      if (length <= kCoincident) continue;
      const Vec2 normal = push / length;
      const Vec2 v = crowd.velocity(i);
      const Vec2 left = v - std::min(0.0, v.dot(normal)) * normal;
      persons.vx[i] = left.x();
      persons.vy[i] = left.y();
    }
  });
  persons.x.swap(moves.x);
  persons.y.swap(moves.y);
}

}  // namespace pedzone
