// The page's parts as data: what its template (folder page) and its scripts show.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pages/page_builder.hpp"
#include "validation/validation.hpp"

namespace pedzone::page {

using Json = PageJson;

/// What the page's style knows a row's model by: its index, and "recorded" for the recording.
Json look_of(const ValidationResult& result, const ValidationRow& row);

/// A value as tables print it; a dash for what is no number.
std::string number(double value, int digits);

/// Groups of the set in which there is anybody, in the order of the tables.
std::vector<std::string> shown_groups(const ValidationResult& result, PersonSet set);

/// Rows of the set and group; the recording first.
std::vector<const ValidationRow*> rows_of(const ValidationResult& result, PersonSet set,
                                          const std::string& group);

/// Columns of all tables with what they mean, and the headings of neighbouring ones.
Json table_columns();
Json table_blocks();
/// All figures of a group, a row for each model.
Json table_rows(const ValidationResult& result, PersonSet set, const std::string& group);

/// For the scripts: the key figures of a group with their intervals.
Json key_figures(const ValidationResult& result, PersonSet set, const std::string& group);

/// For the scripts: what cumulative curves are of; the models that have one, the page's last; and
/// the curves of all groups that are shown.
Json curve_measures();
std::vector<std::size_t> curve_models(const ValidationResult& result);
Json curve_set(const ValidationResult& result, PersonSet set);

/// One person's recorded and walked way, with the vehicle.
Json drawn_case(const DrawnCase& drawn);
/// The colours of the clock in those pictures, as stops of a gradient.
Json clock_stops();

}  // namespace pedzone::page
