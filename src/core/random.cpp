#include "core/random.hpp"

#include <cmath>
#include <numbers>

namespace pedzone {
namespace {

constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ULL;  // 2^64 / golden ratio, SplitMix64

std::uint64_t mix(std::uint64_t z) {
  z += kGolden;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

double to_unit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

}  // namespace

std::uint64_t person_key(std::string_view id) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : id) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  return hash;
}

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t person, std::uint64_t step,
                          Purpose purpose) {
  return mix(mix(mix(mix(seed) ^ person) ^ step) ^ static_cast<std::uint64_t>(purpose));
}

double random_uniform(std::uint64_t seed, std::uint64_t person, std::uint64_t step,
                      Purpose purpose) {
  return to_unit(random_bits(seed, person, step, purpose));
}

double random_normal(std::uint64_t seed, std::uint64_t person, std::uint64_t step,
                     Purpose purpose) {
  const std::uint64_t bits = random_bits(seed, person, step, purpose);
  const double radius = std::sqrt(-2.0 * std::log1p(-to_unit(bits)));
  return radius * std::cos(2.0 * std::numbers::pi * to_unit(mix(bits)));
}

}  // namespace pedzone
