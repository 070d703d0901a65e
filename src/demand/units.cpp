#include "demand/units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "demand/draws.hpp"

namespace pedzone {
namespace {

/// Sizes of units, drawn one after the other.
class Sizes {
 public:
  Sizes(const PanelSpec& spec, std::uint64_t seed)
      : spec_(spec), draws_(seed, spec.id + " sizes"), mean_(mean_group(spec)) {
    // Of units; `alone` is of people.
    alone_ = spec.alone <= 0.0 ? 0.0 : spec.alone * mean_ / (1.0 - spec.alone + spec.alone * mean_);
  }

  /// Persons a unit, in the mean.
  double mean() const { return alone_ + (1.0 - alone_) * mean_; }

  /// The next unit where `left` people are left to come: those too few for a group walk alone.
  int next(long left) {
    const double unit = draws_.uniform();
    if (unit < alone_ || left < spec_.group_least) return 1;
    return group(left);
  }

  /// A group of at most `most`, which is no less than the least.
  int group(long most) {
    const int largest = static_cast<int>(std::min<long>(spec_.group_most, most));
    weights_.clear();
    for (int size = spec_.group_least; size <= largest; ++size) {
      weights_.push_back(group_weight(size));
    }
    return spec_.group_least + static_cast<int>(draws_.index(weights_));
  }

  Draws& draws() { return draws_; }

 private:
  const PanelSpec& spec_;
  Draws draws_;
  double mean_, alone_ = 0.0;
  std::vector<double> weights_;
};

/// So many groups among so many people, and the others alone, in any order.
std::vector<Unit> counted_groups(const PanelSpec& spec, Sizes& sizes) {
  std::vector<Unit> units;
  long left = *spec.number;
  for (long others = *spec.groups - 1; others >= 0; --others) {
    units.push_back({sizes.group(left - others * spec.group_least)});
    left -= units.back().size;
  }
  units.resize(units.size() + static_cast<std::size_t>(left));
  for (std::size_t i = units.size(); i > 1; --i) {  // Fisher and Yates
    const double place = sizes.draws().uniform() * static_cast<double>(i);
    std::swap(units[i - 1], units[std::min(i - 1, static_cast<std::size_t>(place))]);
  }
  return units;
}

std::vector<Unit> shared_groups(const PanelSpec& spec, Sizes& sizes) {
  std::vector<Unit> units;
  for (long left = *spec.number; left > 0; left -= units.back().size) {
    units.push_back({sizes.next(left)});
  }
  return units;
}

/// Time to the next unit of a Poisson process [s]; `rate` in 1/s.
double gap(Draws& draws, double rate) { return -std::log1p(-draws.uniform()) / rate; }

/// As many as come until the end.
std::vector<Unit> open_units(const PanelSpec& spec, Sizes& sizes, Draws& times, double begin) {
  const double rate = *spec.per_hour / 3600.0 / sizes.mean();
  std::vector<Unit> units;
  for (double time = begin + gap(times, rate); time < *spec.end; time += gap(times, rate)) {
    units.push_back({sizes.next(std::numeric_limits<long>::max()), time});
  }
  return units;
}

}  // namespace

std::vector<Unit> plan_units(const PanelSpec& spec, std::uint64_t seed, double simulation_begin) {
  const double begin = std::max(simulation_begin, spec.begin.value_or(0.0));
  Sizes sizes(spec, seed);
  Draws times(seed, spec.id + " times");
  if (!spec.number) return open_units(spec, sizes, times, begin);
  std::vector<Unit> units = spec.groups ? counted_groups(spec, sizes) : shared_groups(spec, sizes);
  const double rate = spec.per_hour ? *spec.per_hour / 3600.0 * static_cast<double>(units.size()) /
                                          static_cast<double>(*spec.number)
                                    : 0.0;
  double time = begin;
  for (Unit& unit : units) {
    if (spec.per_hour) {
      time += gap(times, rate);
    } else if (spec.end) {
      time = times.uniform(begin, std::max(begin, *spec.end));
    }
    unit.depart = time;
  }
  const auto sooner = [](const Unit& a, const Unit& b) { return a.depart < b.depart; };
  std::stable_sort(units.begin(), units.end(), sooner);
  if (spec.per_hour && spec.end) {
    std::erase_if(units, [&](const Unit& unit) { return unit.depart >= *spec.end; });
  }
  return units;
}

}  // namespace pedzone
