#include "validation/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/page_parts.hpp"
#include "validation/tuned_clips.hpp"

namespace pedzone {

// Made from validation/page by the build.
extern const std::string_view kValidationPage, kValidationTables, kValidationCurves,
    kValidationStyles, kValidationScripts;

namespace page {

Json look_of(const ValidationResult& result, const ValidationRow& row) {
  // From the back: the page's model is the last one, whatever it is called.
  for (std::size_t m = result.models.size(); m-- > 0;) {
    if (result.models[m] == row.model) return m;
  }
  return "recorded";
}

std::string number(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return "∞";
  return fmt::format("{:.{}f}", value, digits);
}

std::vector<const ValidationRow*> rows_of(const ValidationResult& result, PersonSet set,
                                          const std::string& group) {
  std::vector<const ValidationRow*> rows;
  for (const ValidationRow& row : result.rows) {
    if (row.set == set && row.group == group) rows.push_back(&row);
  }
  return rows;
}

std::vector<std::string> shown_groups(const ValidationResult& result, PersonSet set) {
  std::vector<std::string> shown = groups_of(result.data);
  std::erase_if(shown, [&](const std::string& one) { return rows_of(result, set, one).empty(); });
  return shown;
}

namespace {

/// Not a single manoeuvre of a site.
bool is_whole(const ValidationResult& result, const std::string& group) {
  return group == "all" ||
         std::ranges::any_of(result.data, [&](const Clip& clip) { return clip.site == group; });
}

/// The groups of a set: first all and sites, then their manoeuvres, whose curves the page folds.
Json set_data(const ValidationResult& result, PersonSet set) {
  Json whole = Json::array(), manoeuvres = Json::array();
  std::size_t index = 0;
  for (const std::string& group : shown_groups(result, set)) {
    const ValidationRow& first = *rows_of(result, set, group).front();
    (is_whole(result, group) ? whole : manoeuvres)
        .push_back({{"set", static_cast<int>(set)},
                    {"index", index++},
                    {"name", group},
                    {"persons", first.persons},
                    {"clips", first.clips},
                    {"rows", table_rows(result, set, group)}});
  }
  Json folds = Json::array();
  if (!whole.empty()) folds.push_back({{"folded", false}, {"groups", whole}});
  if (!manoeuvres.empty()) folds.push_back({{"folded", true}, {"groups", manoeuvres}});
  return {{"folds", folds}};
}

std::size_t persons_in(const ValidationResult& result, PersonSet set) {
  return result.runs.empty() || result.runs.front().empty()
             ? 0
             : members(result, result.runs.front(), 0, set, "all").size();
}

/// All and each site, of whom the key figures are told; none where nobody met a vehicle.
std::vector<std::string> glance_groups(const ValidationResult& result) {
  auto groups = shown_groups(result, PersonSet::kRecorded);
  std::erase_if(groups, [&](const std::string& group) { return !is_whole(result, group); });
  return groups;
}

Json glance_data(const ValidationResult& result) {
  Json groups = Json::array();
  for (const std::string& group : glance_groups(result)) {
    const ValidationRow& row = *rows_of(result, PersonSet::kRecorded, group).front();
    groups.push_back({{"index", groups.size()},
                      {"name", row.group},
                      {"persons", row.persons},
                      {"clips", row.clips}});
  }
  return groups;
}

/// What the default was tuned on, and which of the clips that are scored it was not.
Json tuned_data(const ValidationResult& result) {
  const auto named = [](const std::vector<ClipName>& clips) -> Json {
    if (clips.empty()) return false;
    return {{"count", clips.size()}, {"names", listed(clips)}};
  };
  const ShownClips shown = shown_clips(scored_clips(result.data));
  Json tuned = named(shown.tuned);
  if (!shown.tuned.empty()) tuned["some"] = shown.tuned.size() < tuned_clips().size();
  return {{"all", named(tuned_clips())},
          {"shown", tuned},
          {"held_back", named(shown.held_back)},
          {"scored", shown.tuned.size() + shown.held_back.size()}};
}

Json worst_data(const std::vector<DrawnCase>& worst) {
  if (worst.empty()) return false;
  Json cases = Json::array();
  for (const DrawnCase& drawn : worst) cases.push_back(drawn_case(drawn));
  return {{"clock", clock_stops()}, {"cases", cases}};
}

Json shown_data(const ValidationResult& result, const std::vector<DrawnCase>& worst) {
  const std::string model = result.models.empty() ? "Models" : result.models.back();
  return {{"title", "pedzone: " + model + " against recordings"},
          {"model", model},
          {"look", result.models.empty() ? 0 : result.models.size() - 1},
          {"clips", result.clips},
          {"persons", result.persons},
          {"scored", result.scored},
          {"seeds", result.seeds},
          {"tuned", tuned_data(result)},
          {"glance", glance_data(result)},
          {"first_persons", persons_in(result, PersonSet::kRecorded)},
          {"second_persons", persons_in(result, PersonSet::kStraight)},
          {"blocks", table_blocks()},
          {"columns", table_columns()},
          {"first", set_data(result, PersonSet::kRecorded)},
          {"second", set_data(result, PersonSet::kStraight)},
          {"worst", worst_data(worst)}};
}

Json drawn_data(const ValidationResult& result) {
  Json glance = Json::array();
  for (const std::string& group : glance_groups(result)) {
    glance.push_back(key_figures(result, PersonSet::kRecorded, group));
  }
  return {
      {"models", result.models},
      {"glance", glance},
      {"measures", curve_measures()},
      {"drawn", curve_models(result)},
      {"sets", {curve_set(result, PersonSet::kRecorded), curve_set(result, PersonSet::kStraight)}}};
}

}  // namespace
}  // namespace page

std::string validation_page(const ValidationResult& result, const std::vector<DrawnCase>& worst) {
  return rendered_page({kValidationPage,
                        kValidationStyles,
                        kValidationScripts,
                        {{"tables", kValidationTables}, {"curves", kValidationCurves}}},
                       page::shown_data(result, worst), page::drawn_data(result));
}

}  // namespace pedzone
