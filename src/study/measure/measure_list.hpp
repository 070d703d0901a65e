// The measures of a study: what each means. The same code takes them for every model.
#pragma once

#include <span>
#include <string_view>

namespace pedzone::study {

struct Measure {
  std::string_view key;      ///< as in records and tables
  std::string_view name;     ///< for people
  std::string_view unit;     ///< empty: a number or a share
  std::string_view meaning;  ///< a sentence
  std::string_view group;    ///< heading: People, Crossing, Space, Vehicles, Conflicts
  bool primary;  ///< of the family that the verdict is about; the others are told as detail
  bool optional = false;  ///< compared only where runs have it
};

std::span<const Measure> measure_list();
/// Null where there is none.
const Measure* find_measure(std::string_view key);

}  // namespace pedzone::study
