// Lists for messages, and text that comes from users, made safe for the files it is written to.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace pedzone {

/// Texts with `separator` between them. `name`: of a thing, its text.
template <class Things, class Name = std::identity>
std::string separated_list(const Things& things, std::string_view separator,
                           const Name& name = {}) {
  std::string text;
  for (const auto& thing : things) {
    if (!text.empty()) text += separator;
    text += std::invoke(name, thing);
  }
  return text;
}

/// "a, b, c".
template <class Things, class Name = std::identity>
std::string comma_list(const Things& things, const Name& name = {}) {
  return separated_list(things, ", ", name);
}

/// How many characters at its begin are a byte order mark, which Excel writes into UTF-8 files.
inline std::size_t mark_length(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

/// As a value of an XML attribute. Characters that XML does not know become U+FFFD.
std::string xml_value(std::string_view text);

/// As a field of a CSV file: quoted as in RFC 4180 where it holds commas, quotes or line ends.
std::string csv_field(std::string_view text);

/// As a string of JSON, quotes included, that may stand inside <script> in HTML too: without '<'.
std::string json_string(std::string_view text);

}  // namespace pedzone
