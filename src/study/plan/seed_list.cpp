#include "study/plan/seed_list.hpp"

#include <charconv>
#include <set>
#include <string_view>

#include "core/xml.hpp"

namespace pedzone::study {
namespace {

const std::string kAllowed =
    "numbers from 0 to " + std::to_string(kMostSeed) + " and ranges of them, such as \"1-50 61\"";

std::uint64_t parse_seed(std::string_view text, const std::string& word) {
  std::uint64_t seed = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (code == std::errc() && end == text.data() + text.size() && seed <= kMostSeed) return seed;
  throw SeedListError{"is no seed", word, kAllowed};
}

}  // namespace

std::vector<std::uint64_t> parse_seeds(const std::string& text) {
  std::set<std::uint64_t> seeds;
  for (const std::string& word : split_words(text)) {
    const std::string_view view = word;
    const std::size_t dash = view.find('-');
    const std::uint64_t first = parse_seed(view.substr(0, dash), word);
    const std::uint64_t last =
        dash == std::string_view::npos ? first : parse_seed(view.substr(dash + 1), word);
    if (last < first) throw SeedListError{"runs backwards", word, kAllowed};
    if (seeds.size() + (last - first) >= kMostSeeds) {
      throw SeedListError{"makes too many seeds", word, std::to_string(kMostSeeds) + " in all"};
    }
    for (std::uint64_t seed = first; seed <= last; ++seed) {
      if (seeds.insert(seed).second) continue;
      throw SeedListError{"is named twice", std::to_string(seed), "each seed once"};
    }
  }
  if (seeds.empty()) throw SeedListError{"names no seed", "", kAllowed};
  return {seeds.begin(), seeds.end()};
}

}  // namespace pedzone::study
