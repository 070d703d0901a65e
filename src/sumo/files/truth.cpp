#include "sumo/files/truth.hpp"

#include <algorithm>
#include <cctype>
#include <span>

namespace pedzone {
namespace {

// SUMO's StringUtils::toBool.
constexpr std::string_view kTrue[] = {"1", "yes", "true", "on", "x", "t"};
constexpr std::string_view kFalse[] = {"0", "no", "false", "off", "-", "f"};

bool equal(std::string_view text, std::string_view word) {
  return std::ranges::equal(text, word, {}, [](unsigned char c) { return std::tolower(c); });
}

bool is_one_of(std::string_view text, std::span<const std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return equal(text, word); });
}

}  // namespace

bool is_true(std::string_view text) { return is_one_of(text, kTrue); }
bool is_false(std::string_view text) { return is_one_of(text, kFalse); }

}  // namespace pedzone
