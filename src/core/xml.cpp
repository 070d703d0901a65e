#include "core/xml.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <memory>
#include <sstream>

#include "core/input_files.hpp"
#include "core/text.hpp"

namespace pedzone {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

std::string read_text(const std::string& file) {
  // gzopen reads plain files as they are.
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> input(gzopen(file.c_str(), "rb"), gzclose);
  if (!input) throw InputError("cannot be opened", {.file = file});
  note_input(file);
  std::string text;
  std::array<char, 1 << 16> buffer;
  int got = 0;
  while ((got = gzread(input.get(), buffer.data(), buffer.size())) > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
  int code = Z_OK;
  const char* reason = gzerror(input.get(), &code);
  if (got < 0 || (code != Z_OK && code != Z_STREAM_END)) {
    throw InputError(std::string("cannot be read (") + reason + ")", {.file = file});
  }
  return text;
}

template <typename Names>
std::string listed(const Names& names) {
  const std::string text = comma_list(names);
  return text.empty() ? "none" : text;
}

bool among(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

XmlFile::XmlFile(const std::string& file, std::initializer_list<std::string_view> roots)
    : file_(file) {
  const std::string text = read_text(file);
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    newlines_.push_back(at);
  }
  const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
  if (!result) {
    throw InputError(std::string("is not well-formed XML (") + result.description() + ")",
                     {.file = file_, .line = line_at(result.offset)});
  }
  if (roots.size() > 0 && !among(root().name(), roots)) {
    throw InputError("is not the document element expected", {.file = file_,
                                                              .line = line(root()),
                                                              .element = "document element",
                                                              .value = root().name(),
                                                              .allowed = listed(roots)});
  }
}

int XmlFile::line_at(std::ptrdiff_t offset) const {
  const auto position = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
  return 1 + static_cast<int>(std::lower_bound(newlines_.begin(), newlines_.end(), position) -
                              newlines_.begin());
}

std::string XmlFile::beside(const std::string& name) const {
  return (std::filesystem::path(file_).parent_path() / name).string();  // absolute ones stay
}

int XmlFile::line(const pugi::xml_node& node) const { return line_at(node.offset_debug()); }

InputError XmlFile::error(const std::string& problem, const pugi::xml_node& node,
                          const std::string& attribute, const std::string& value,
                          const std::string& allowed) const {
  std::string element = std::string("<") + node.name();
  for (const char* name : {"id", "key"}) {
    const char* given = node.attribute(name).value();
    if (*given == '\0' || attribute == name) continue;
    element += std::string(" ") + name + "=\"" + given + "\"";
    break;
  }
  element += ">";
  if (!attribute.empty()) element += " attribute " + attribute;
  return InputError(
      problem,
      {.file = file_, .line = line(node), .element = element, .value = value, .allowed = allowed});
}

std::string XmlFile::required(const pugi::xml_node& node, const char* attribute) const {
  const std::string value = node.attribute(attribute).value();
  if (value.empty()) {
    const bool there = !node.attribute(attribute).empty();
    throw error(there ? "is empty" : "is missing", node, attribute);
  }
  return value;
}

double XmlFile::number(const pugi::xml_node& node, const char* attribute,
                       const NumberRange& range) const {
  const std::string value = required(node, attribute);
  double result = 0.0;
  if (!parse_number(value, result)) {
    throw error("is not a number", node, attribute, value, describe(range));
  }
  if (result < range.least || result > range.most) {
    throw error("is out of range", node, attribute, value, describe(range));
  }
  return result;
}

double XmlFile::number(const pugi::xml_node& node, const char* attribute, const NumberRange& range,
                       double otherwise) const {
  return node.attribute(attribute).empty() ? otherwise : number(node, attribute, range);
}

void XmlFile::check_names(const pugi::xml_node& node,
                          std::initializer_list<std::string_view> attributes,
                          std::initializer_list<std::string_view> children) const {
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (name.starts_with("xmlns") || name.starts_with("xsi:")) continue;
    if (!among(name, attributes)) {
      throw error("is an unknown attribute", node, "", std::string(name), listed(attributes));
    }
  }
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_element && !among(child.name(), children)) {
      throw error("is not allowed in <" + std::string(node.name()) + ">", child, "", "",
                  listed(children));
    }
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      throw error("holds text", node, "", child.value(), listed(children));
    }
  }
}

bool parse_number(std::string_view text, double& number) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return false;
  text = text.substr(first, text.find_last_not_of(kSpace) - first + 1);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  return code == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

std::vector<std::string> split_words(std::string_view text, char separator) {
  std::string separators(kSpace);
  separators += separator;
  std::vector<std::string> words;
  std::size_t at = text.find_first_not_of(separators);
  while (at != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = text.find_first_not_of(separators, end);
  }
  return words;
}

std::string describe(const NumberRange& range) {
  constexpr int kDigits = 12;  // 1000000000, not 1e+09
  std::ostringstream text;
  text << std::setprecision(kDigits) << range.least << " to " << range.most;
  return text.str();
}

std::string xml_text(const pugi::xml_document& document) {
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace pedzone
