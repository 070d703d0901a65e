#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/random.hpp"
#include "verify/trial.hpp"

namespace pedzone::verify {
namespace {

// A lattice of rows along x, every other one moved by half a gap.
struct Lattice {
  std::size_t rows = 0, in_row = 0;
  double gap = 0.0;    // [m] between neighbours of a row
  double rise = 0.0;   // [m] between rows
  double least = 0.0;  // [m] between any two
};

/// Rows of a strip `length` by `width` [m] (room for centres) that hold `count`.
Lattice lattice_of(double length, double width, std::size_t count, std::size_t rows) {
  Lattice lattice;
  lattice.rows = rows;
  lattice.in_row = (count + rows - 1) / rows;
  lattice.gap = length / (static_cast<double>(lattice.in_row) + (rows > 1 ? 0.5 : 0.0));
  lattice.rise = rows > 1 ? width / static_cast<double>(rows - 1) : width;
  lattice.least = lattice.gap;
  if (rows > 1) lattice.least = std::min(lattice.gap, std::hypot(lattice.gap / 2, lattice.rise));
  if (rows > 2) lattice.least = std::min(lattice.least, 2.0 * lattice.rise);
  return lattice;
}

Lattice widest(double length, double width, std::size_t count) {
  Lattice best;
  for (std::size_t rows = 1; rows <= count; ++rows) {
    const Lattice lattice = lattice_of(length, width, count, rows);
    if (lattice.least > best.least) best = lattice;
  }
  return best;
}

}  // namespace

std::vector<Vec2> places_in(const Vec2& low, const Vec2& high, std::size_t count,
                            std::uint64_t seed) {
  constexpr double kRoom = 0.95;  // numerical: share of the free gap by which places are moved
  const double width = high.y() - low.y() - 2.0 * kBodyRadius;
  const double length = high.x() - low.x();
  const Lattice lattice = widest(length, width, std::max<std::size_t>(count, 1));
  const double free = lattice.least - 2.0 * kBodyRadius;
  if (free < 0.0 || width < 0.0) throw std::invalid_argument("verify: bodies do not fit");
  std::vector<Vec2> places;
  for (std::size_t row = 0; row < lattice.rows; ++row) {
    for (std::size_t k = 0; k < lattice.in_row; ++k) {
      const double shift = row % 2 == 0 ? 0.25 : 0.75;
      const double y = lattice.rows > 1 ? lattice.rise * static_cast<double>(row) : width / 2.0;
      places.emplace_back(low.x() + lattice.gap * (static_cast<double>(k) + shift),
                          low.y() + kBodyRadius + y);
    }
  }
  const auto draw = [&](std::size_t i, std::uint64_t what) {
    return random_uniform(seed, i, what, Purpose::kPlacement);
  };
  // Too many by less than a row: those that go are drawn, so that no end stays empty.
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < places.size(); ++i) order.emplace_back(draw(i, 0), i);
  std::ranges::sort(order);
  std::vector<Vec2> chosen;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = order[k].second;
    const double reach = 0.5 * kRoom * free * std::sqrt(draw(i, 1));
    Vec2 place = places[i] + reach * unit(2.0 * kPi * draw(i, 2));
    place.y() = std::clamp(place.y(), low.y() + kBodyRadius, high.y() - kBodyRadius);
    place.x() = std::clamp(place.x(), low.x(), high.x() - 1e-6);
    chosen.push_back(place);
  }
  return chosen;
}

}  // namespace pedzone::verify
