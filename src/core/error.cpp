#include "core/error.hpp"

namespace pedzone {
namespace {

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
  return text;
}

}  // namespace

InputError::InputError(const std::string& problem, const InputPlace& place)
    : std::runtime_error(message(problem, place)) {}

}  // namespace pedzone
