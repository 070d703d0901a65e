// JSON that commands print and write for other programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace pedzone {

/// In every JSON that pedzone prints for programs and in a run's summary, as "version": raised when
/// a key goes or changes its meaning. New keys do not raise it.
inline constexpr int kJsonVersion = 1;

/// Indented. What is not UTF-8 in the user's names becomes U+FFFD.
inline std::string json_text(const nlohmann::ordered_json& json) {
  constexpr int kIndent = 2;
  using nlohmann::ordered_json;
  return json.dump(kIndent, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace pedzone
