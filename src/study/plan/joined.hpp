// Names of a list, for messages.
#pragma once

#include <functional>
#include <string>

namespace pedzone::study {

/// "a, b, c"
template <class List, class Name = std::identity>
std::string joined(const List& list, Name name = {}) {
  std::string text;
  for (const auto& item : list) {
    text += (text.empty() ? "" : ", ") + std::string(std::invoke(name, item));
  }
  return text;
}

}  // namespace pedzone::study
