#include "app/validation_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "validation/tuned_clips.hpp"

namespace pedzone {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kName = 24;

std::string printed(double value, const FigureInfo& info) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value * info.scale, info.digits) : "-";
}

std::string header() {
  std::string text = fmt::format("{:<{}}{:>5}", "", kName, "n");
  for (const FigureInfo& info : figure_list()) text += fmt::format("{:>7}", info.title);
  return text + "\n";
}

std::string line(const ValidationRow& row) {
  std::string text = fmt::format("  {:<{}}{:>5}", row.model, kName - 2, row.persons);
  for (std::size_t f = 0; f < kFigures; ++f) {
    text += fmt::format("{:>7}", printed(row.value[f], figure_list()[f]));
  }
  return text + "\n";
}

/// JSON has no infinity and no NaN.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json row_json(const ValidationRow& row) {
  Json figures;
  for (std::size_t f = 0; f < kFigures; ++f) {
    figures[std::string(figure_list()[f].key)] = {{"value", number(row.value[f])},
                                                  {"low", number(row.low[f])},
                                                  {"high", number(row.high[f])}};
  }
  return {{"set", name_of(row.set)}, {"group", row.group}, {"model", row.model},
          {"persons", row.persons},  {"clips", row.clips}, {"figures", figures}};
}

Json clip_names(const std::vector<ClipName>& clips) {
  Json names = Json::array();
  for (const auto& [site, name] : clips) names.push_back(site + "/" + name);
  return names;
}

/// Of what the default was tuned on: there its figures show how well it fits.
std::string tuned_line(const ValidationResult& result) {
  const ShownClips shown = shown_clips(scored_clips(result.data));
  return fmt::format("The default was tuned on {} clips: on {} of the {} that are scored here\n",
                     tuned_clips().size(), shown.tuned.size(),
                     shown.tuned.size() + shown.held_back.size());
}

Json parameters_json(const Parameters& parameters) {
  Json json;
  for (const Searched& searched : searched_parameters()) {
    json[std::string(searched.key)] = parameters.*find_parameter(searched.key)->member;
  }
  return json;
}

}  // namespace

std::string validation_table(const ValidationResult& result) {
  std::string text =
      fmt::format("{} clips, {} persons ({} of at least 3 s and 2 m), means over {} seeds\n",
                  result.clips, result.persons, result.scored, result.seeds);
  text += tuned_line(result);
  for (const PersonSet set : {PersonSet::kRecorded, PersonSet::kStraight}) {
    text += set == PersonSet::kRecorded
                ? "\nPersons whose recorded clearance to a moving vehicle is under 3 m\n"
                : "\nPersons who would come within 3 m of one, walking straight\n";
    text += header();
    std::string group;
    for (const ValidationRow& row : result.rows) {
      if (row.set != set) continue;
      if (row.group != group) text += row.group + "\n";
      group = row.group;
      text += line(row);
    }
  }
  text += "\n";
  for (const FigureInfo& info : figure_list()) {
    const std::string unit = info.unit.empty() ? "" : fmt::format(" [{}]", info.unit);
    text += fmt::format("  {:<7} {}{}\n", info.title, info.meaning, unit);
  }
  return text;
}

std::string validation_json(const ValidationResult& result) {
  Json json;
  json["clips"] = result.clips;
  json["persons"] = result.persons;
  json["scored"] = result.scored;
  json["seeds"] = result.seeds;
  const ShownClips shown = shown_clips(scored_clips(result.data));
  json["tuned_clips"] = clip_names(shown.tuned);
  json["held_back_clips"] = clip_names(shown.held_back);
  json["models"] = result.models;
  for (const FigureInfo& info : figure_list()) {
    json["figures"].push_back({{"key", info.key},
                               {"title", info.title},
                               {"unit", info.scale == 100.0 ? "share" : std::string(info.unit)},
                               {"meaning", info.meaning}});
  }
  for (const ValidationRow& row : result.rows) json["rows"].push_back(row_json(row));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The good points of all clips, the best first.
static std::string valley_table(const CalibrationResult& result) {
  std::string text =
      "Good points, scored with other seeds. Columns: misfit; standard error of how much worse\n"
      "that is than the best; the worst such difference in any fold. v: no worse than the best by\n"
      "more than its standard error (the valley). *: taken: of the valley, the folds agree most\n"
      "on it.\n";
  for (const Finalist& finalist : result.finalists) {
    text +=
        fmt::format("  {:.3f} {:.3f} {:.3f} {}{}", finalist.misfit, finalist.error, finalist.regret,
                    finalist.in_valley ? 'v' : ' ', finalist.chosen ? '*' : ' ');
    for (const Searched& searched : searched_parameters()) {
      text += fmt::format(" {}={}", searched.key,
                          finalist.parameters.*find_parameter(searched.key)->member);
    }
    text += "\n";
  }
  return text + "\n";
}

std::string calibration_table(const CalibrationResult& result) {
  std::string text = valley_table(result);
  for (const FoldResult& fold : result.folds) {
    text += fmt::format("Tuned on {}, misfit {:.3f}:", fold.fold.name, fold.misfit);
    for (const Searched& searched : searched_parameters()) {
      text += fmt::format(" {}={}", searched.key,
                          fold.parameters.*find_parameter(searched.key)->member);
    }
    text += "\n" + header();
    std::string group;
    for (const ValidationRow& row : fold.rows) {
      if (row.group != group) text += row.group + "\n";
      group = row.group;
      text += line(row);
    }
    text += "\n";
  }
  return text + fmt::format("{} evaluations, {} of them known from before\n", result.evaluations,
                            result.reused);
}

std::string calibration_json(const CalibrationResult& result) {
  Json json;
  for (const FoldResult& fold : result.folds) {
    Json rows;
    for (const ValidationRow& row : fold.rows) rows.push_back(row_json(row));
    json["folds"].push_back({{"tuned_on", fold.fold.name},
                             {"misfit", fold.misfit},
                             {"parameters", parameters_json(fold.parameters)},
                             {"scored_on", rows}});
  }
  for (const Finalist& finalist : result.finalists) {
    json["finalists"].push_back({{"misfit", finalist.misfit},
                                 {"error", finalist.error},
                                 {"regret", finalist.regret},
                                 {"in_valley", finalist.in_valley},
                                 {"chosen", finalist.chosen},
                                 {"parameters", parameters_json(finalist.parameters)}});
  }
  json["evaluations"] = result.evaluations;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string calibrated_include(const CalibrationResult& result, const CalibrationOptions& options) {
  const FoldResult& all = result.folds.front();
  std::string text = fmt::format(
      "// Written by `pedzone calibrate` ({} seeds, {} points, {} rounds of {}); not by hand.\n"
      "// Misfit {:.3f}. Scores, the recording (CITR and DUT) and these parameters:\n//\n",
      options.seeds, options.first, options.rounds, options.points, all.misfit);
  const Figure shown[] = {Figure::kClearance,   Figure::kClearanceKs, Figure::kDeviation,
                          Figure::kDeviationKs, Figure::kSpeed,       Figure::kLeastSpeedKs,
                          Figure::kFirst,       Figure::kAde};
  text += fmt::format("// {:<24}{:>12}{:>5}", "", "", "n");
  for (const Figure f : shown) {
    text += fmt::format("{:>7}", figure_list()[static_cast<std::size_t>(f)].title);
  }
  text += "\n";
  for (const ValidationRow& row : all.rows) {
    text += fmt::format("// {:<24}{:>12}{:>5}", row.group, row.model, row.persons);
    for (const Figure f : shown) {
      const auto k = static_cast<std::size_t>(f);
      text += fmt::format("{:>7}", printed(row.value[k], figure_list()[k]));
    }
    text += "\n";
  }
  text += "// The valley: from and to of each parameter, among points within noise of the best.\n";
  for (const Searched& searched : searched_parameters()) {
    double least = searched.most, most = searched.least;
    for (const Finalist& finalist : result.finalists) {
      if (!finalist.in_valley) continue;
      const double value = finalist.parameters.*find_parameter(searched.key)->member;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    text += fmt::format("// {:<24}{:>8} to {}\n", searched.key, least, most);
  }
  for (const Searched& searched : searched_parameters()) {
    text += fmt::format("calibrated({}, {})\n", searched.key,
                        all.parameters.*find_parameter(searched.key)->member);
  }
  return text;
}

std::string tuned_include(const std::vector<Clip>& data) {
  std::string text = "// Written by `pedzone calibrate`, with calibrated.inc; not by hand.\n";
  for (const auto& [site, name] : scored_clips(data)) {
    text += fmt::format("tuned_clip(\"{}\", \"{}\")\n", site, name);
  }
  return text;
}

std::string calibrated_zone(const CalibrationResult& result) {
  std::string text = "<zones>\n    <zone id=\"calibrated\">\n";
  for (const Searched& searched : searched_parameters()) {
    text += fmt::format("        <param key=\"{}\" value=\"{}\"/>\n", searched.key,
                        result.folds.front().parameters.*find_parameter(searched.key)->member);
  }
  return text + "    </zone>\n</zones>\n";
}

}  // namespace pedzone
