#include "core/shell_word.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace pedzone {

std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain = "._-/+=:,@%";
  const auto plain = [=](unsigned char c) {
    return std::isalnum(c) != 0 || kPlain.find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string shell_command(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

}  // namespace pedzone
