#include "core/nearest_word.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace pedzone {
namespace {

constexpr std::size_t kLettersAMistake = 3;  // assumed: one mistake in so many letters is a slip
constexpr std::size_t kLeastBeginning = 3;   // letters: fewer begin too many words

/// Letters missing, too many, wrong or swapped (the "optimal string alignment" distance).
std::size_t mistakes(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last, row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t wrong = a[i - 1] == b[j - 1] ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + wrong});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_word(std::string_view word, std::span<const std::string> names) {
  std::size_t least = (word.size() + 1) / kLettersAMistake + 1;
  std::string nearest;
  for (const std::string& name : names) {
    const bool begun = word.size() >= kLeastBeginning && name.starts_with(word);
    const std::size_t found = begun ? 1 : mistakes(word, name);
    if (found >= least || name == word) continue;
    least = found;
    nearest = name;
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> names) {
  const std::string nearest = nearest_word(word, names);
  return nearest.empty() ? "" : ". Did you mean '" + nearest + "'?";
}

}  // namespace pedzone
