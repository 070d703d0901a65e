#include "sumo/files/number_text.hpp"

#include <algorithm>
#include <charconv>

namespace pedzone {

std::optional<double> number_of(std::optional<std::string_view> text) {
  double value = 0.0;
  if (!text) return std::nullopt;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc() || end != text->data() + text->size()) return std::nullopt;
  return value;
}

std::optional<double> time_of(std::optional<std::string_view> text) {
  if (!text) return std::nullopt;
  double time = 0.0;
  int parts = 0;
  for (std::string_view rest = *text; parts < 4; ++parts) {
    const std::size_t colon = rest.find(':');
    const auto part = number_of(rest.substr(0, colon));
    if (!part) return std::nullopt;
    time = time * (parts == 1 && std::ranges::count(*text, ':') == 3 ? 24.0 : 60.0) + *part;
    if (colon == std::string_view::npos) return time;
    rest.remove_prefix(colon + 1);
  }
  return std::nullopt;
}

}  // namespace pedzone
