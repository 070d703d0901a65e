// Lists of files as SUMO takes them.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace pedzone {

/// The files of a list: between commas, without blanks at their ends (names may have blanks
/// inside).
inline std::vector<std::string> split_file_list(std::string_view list) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::vector<std::string> files;
  while (!list.empty()) {
    const std::string_view word = list.substr(0, list.find(','));
    list.remove_prefix(std::min(word.size() + 1, list.size()));
    const std::size_t first = word.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) continue;
    files.emplace_back(word.substr(first, word.find_last_not_of(kBlanks) - first + 1));
  }
  return files;
}

}  // namespace pedzone
