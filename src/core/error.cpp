#include "core/error.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include "core/nearest_word.hpp"

namespace pedzone {
namespace {

/// The names in a list such as "a, b, or the path of c": what is of several words is none.
std::vector<std::string> names_in(const std::string& allowed) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin < allowed.size();) {
    const std::size_t end = std::min(allowed.find(", ", begin), allowed.size());
    const std::string name = allowed.substr(begin, end - begin);
    const bool word = name.find(' ') == std::string::npos && !name.empty();
    if (word && std::isalpha(static_cast<unsigned char>(name.front())) != 0) names.push_back(name);
    begin = end + 2;
  }
  return names;
}

std::string message(const std::string& problem, const InputPlace& place) {
  std::string text;
  if (!place.file.empty()) {
    text += place.file;
    if (place.line > 0) text.append(":").append(std::to_string(place.line));
    text += ": ";
  }
  if (!place.element.empty()) text += place.element + ": ";
  if (!place.value.empty()) text.append("'").append(place.value).append("' ");
  text += problem;
  if (!place.allowed.empty()) text += "; allowed: " + place.allowed;
  if (!place.value.empty()) text += did_you_mean(place.value, names_in(place.allowed));
  return text;
}

}  // namespace

InputError::InputError(const std::string& problem, const InputPlace& place)
    : std::runtime_error(message(problem, place)) {}

}  // namespace pedzone
