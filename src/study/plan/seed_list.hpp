// Seeds as a user writes them: "1-50 61".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pedzone::study {

inline constexpr std::uint64_t kMostSeed = 2147483647;  ///< SUMO's option is a 32-bit number
inline constexpr std::size_t kMostSeeds = 100000;       ///< numerical: a list is held

/// Why a list of seeds is none.
struct SeedListError {
  std::string problem, value, allowed;
};

/// Numbers and ranges, separated by spaces; ascending, each once. Throws SeedListError where there
/// is none, and for words that are no seeds, ranges that run backwards and seeds named twice.
std::vector<std::uint64_t> parse_seeds(const std::string& text);

}  // namespace pedzone::study
