// The random numbers of one panel: each drawn for (unit or person, what for), so that none depends
// on the others.
#pragma once

#include <string>

#include "core/random.hpp"

namespace pedzone {

class Draws {
 public:
  /// `key`: of the panel, its unit (group or single person) or its person.
  Draws(std::uint64_t seed, const std::string& key) : seed_(seed), key_(person_key(key)) {}

  /// The next number, uniform in [0, 1).
  double uniform() { return random_uniform(seed_, key_, count_++, Purpose::kDemand); }
  /// The next number, uniform in [least, most).
  double uniform(double least, double most) { return least + (most - least) * uniform(); }

  /// The index of one of these weights, in proportion. At least one is positive.
  template <class Weights>
  std::size_t index(const Weights& weights) {
    double sum = 0.0;
    for (const double weight : weights) sum += weight;
    double left = uniform() * sum;
    std::size_t last = 0, i = 0;
    for (const double weight : weights) {
      if (weight > 0.0) {
        last = i;
        if (left < weight) return i;
        left -= weight;
      }
      ++i;
    }
    return last;  // rounding
  }

 private:
  std::uint64_t seed_, key_, count_ = 0;
};

}  // namespace pedzone
