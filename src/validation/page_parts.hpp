// The page's parts, each as HTML that is well-formed as XML.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "validation/validation.hpp"

namespace pedzone::page {

/// Appends formatted text.
template <class... Arguments>
void add(std::string& out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Arguments>(arguments)...);
}

/// The style sheet.
std::string_view style();

/// "main" for the model that the page is about, "plain", "straight", "constant", "other": names of
/// colours and dashes in the style sheet, as is "recorded".
std::string_view look_of(const ValidationResult& result, std::size_t model);

/// The same for the model of a row, and "recorded" for the recording.
std::string_view look_of(const ValidationResult& result, const ValidationRow& row);

/// The name beside a piece of the line that stands for it in pictures.
std::string named_key(std::string_view name, std::string_view look);

/// A value as tables print it; a dash for what is no number.
std::string number(double value, int digits);

/// Rows of the set and group; the recording first.
std::vector<const ValidationRow*> rows_of(const ValidationResult& result, PersonSet set,
                                          const std::string& group);

/// The key figures of a group as dots with intervals.
std::string overview(const ValidationResult& result, PersonSet set, const std::string& group);

/// All figures of a group as a table in a container that scrolls sideways.
std::string table(const ValidationResult& result, PersonSet set, const std::string& group);

/// What each figure means, as a list.
std::string figure_meanings();

/// Cumulative curves of the set's groups, for each measure a picture.
class Curves {
 public:
  Curves(const ValidationResult& result, PersonSet set);
  /// All pictures of one group.
  std::string of_group(const std::string& group) const;

 private:
  std::string chart(const std::string& group, std::size_t measure) const;

  const ValidationResult& result_;
  PersonSet set_;
  std::vector<double> ends_;  ///< of the axes, one for each measure: the same for all groups
};

/// The legend of the curves.
std::string curve_legend(const ValidationResult& result);

/// One person's recorded and walked way, with the vehicle.
std::string drawn_case(const DrawnCase& drawn);

/// The colours of the clock in those pictures.
std::string clock_legend();

}  // namespace pedzone::page
