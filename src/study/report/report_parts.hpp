// The parts of the report's page as data: what its template and its scripts show.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "study/report/report_verdict.hpp"
#include "study/run/store.hpp"

namespace pedzone::study::report {

using Json = nlohmann::ordered_json;

/// Conditions beyond the first so many have tables, but no pictures: a page has to stay usable.
inline constexpr std::size_t kMostPictured = 24;

/// All that the page is made of.
struct Input {
  const Store& store;
  const Plan& plan;
  const Records& records;
  const std::vector<Comparison>& comparisons;
  const std::vector<FreeSpeed>& speeds;
};

/// How many of the study's conditions have pictures.
std::size_t pictured(const Plan& plan);
/// The study's models but the reference, in their order.
std::vector<std::string> others(const Plan& plan);
/// A finished study run; null where there is none.
const RunRecord* done_run(const Input& input, std::size_t condition, const std::string& model,
                          std::uint64_t seed);
/// Index into Plan::runs of a condition's first finished study run; unset where there is none.
std::optional<std::size_t> first_done_run(const Input& input, std::size_t condition);
/// Directories of the finished runs of a model in a condition, by seed.
std::vector<std::string> run_folders(const Input& input, std::size_t condition,
                                     const std::string& model);

/// What is said of a model in one condition.
Json condition_verdict(const Input& input, std::size_t condition, const std::string& model);

/// For the template. Strings are plain text unless a name ends in `_html`.
Json verdict_part(const Input& input);
Json setup_part(const Input& input);
Json demand_part(const Input& input);
Json tables_part(const Input& input);
Json maps_part(const Input& input);
Json failures_part(const Input& input);

/// For the scripts: distributions of measures, means over time, and the gaps between vehicles that
/// people take, where streets may be crossed anywhere. Of bounded size.
Json distributions(const Input& input);
Json series(const Input& input);
Json gaps(const Input& input);
/// The same in numbers, for the template; false where there are none.
Json gaps_part(const Input& input, const Json& groups);

/// With as many digits as a picture can show.
double rounded(double value);

}  // namespace pedzone::study::report
