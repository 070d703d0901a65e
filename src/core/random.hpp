// Random numbers keyed by (seed, person, step, purpose): no state, so the order of persons and
// the number of threads cannot change a result, and a seed repeats to the bit.
#pragma once

#include <cstdint>
#include <string_view>

namespace pedzone {

/// What a number is drawn for, so that two uses never share one.
enum class Purpose : std::uint32_t {
  kHeadingNoise,
  kPlacement,
  kTieBreak,
  kSpeedJitter,
  kCaution,
  kBootstrap,
  kAwareness,
  kActivity,
  kImpulse,
  kDemand,
  kStepPhase
};

/// 64-bit key of a person's id (FNV-1a): independent of insertion order.
std::uint64_t person_key(std::string_view id);

/// 64 well-mixed bits of the four keys (SplitMix64 finaliser, Steele, Lea and Flood 2014).
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t person, std::uint64_t step,
                          Purpose purpose);

/// Uniform number in [0, 1).
double random_uniform(std::uint64_t seed, std::uint64_t person, std::uint64_t step,
                      Purpose purpose);

/// Standard normal number (Box and Muller 1958).
double random_normal(std::uint64_t seed, std::uint64_t person, std::uint64_t step, Purpose purpose);

}  // namespace pedzone
