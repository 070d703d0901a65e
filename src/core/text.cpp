#include "core/text.hpp"

namespace pedzone {

std::string xml_value(std::string_view text) {
  std::string value;
  for (const char c : text) {
    switch (c) {
      case '&':
        value += "&amp;";
        break;
      case '<':
        value += "&lt;";
        break;
      case '>':
        value += "&gt;";
        break;
      case '"':
        value += "&quot;";
        break;
      case '\t':
      case '\n':
      case '\r':  // as they are, a reader would make spaces of them
        value += "&#" + std::to_string(static_cast<int>(c)) + ";";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) {
          value += c;
        } else {
          value += "\xEF\xBF\xBD";
        }
    }
  }
  return value;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + "\"";
}

std::string json_string(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string string = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      string += '\\';
      string += c;
    } else if (code < 0x20 || c == '<') {
      string += "\\u00";
      string += kDigits[code >> 4];
      string += kDigits[code & 15];
    } else {
      string += c;
    }
  }
  return string + "\"";
}

}  // namespace pedzone
