// Who travels in a study: people by profile, which says their age, and vehicles by type.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "study/measure/tripinfo_reader.hpp"
#include "study/report/report_numbers.hpp"
#include "study/report/report_parts.hpp"
#include "study/report/run_recording.hpp"

namespace pedzone::study::report {
namespace {

constexpr std::size_t kMostKinds = 8;  // named; a zoo of types says nothing

using Kinds = std::map<std::string, std::size_t>;

/// "150 (120 adult, 30 child)".
std::string kinds_text(const Kinds& kinds) {
  std::vector<std::pair<std::string, std::size_t>> sorted(kinds.begin(), kinds.end());
  std::ranges::stable_sort(sorted, std::greater<>(), [](const auto& kind) { return kind.second; });
  std::size_t all = 0, named = 0;
  std::vector<std::string> parts;
  for (const auto& [kind, count] : sorted) {
    all += count;
    if (parts.size() == kMostKinds) continue;
    named += count;
    parts.push_back(fmt::format("{} {}", count, kind));
  }
  if (named < all) parts.push_back(fmt::format("{} others", all - named));
  return fmt::format("{} ({})", all, fmt::join(parts, ", "));
}

/// SUMO's own name of a type's kind: what flows append to it says nothing.
std::string plain_type(const std::string& type) { return type.substr(0, type.find('@')); }

/// Where the profile is not said, the type.
std::string kind_of(const PersonTrip& person, const TraitReader& traits) {
  const std::string profile = traits.of_person(person.id).profile;
  return profile.empty() ? plain_type(person.type) : profile;
}

Json demand_of(const Input& input, const PlannedRun& run) {
  const std::string folder = input.store.run_folder(run.id);
  Trips trips = read_tripinfo(folder + "/tripinfo.xml");
  if (input.plan.study.end) settle(trips, *input.plan.study.end);
  const RecordingCast cast = run_cast(input.plan, run, folder);
  Kinds people, vehicles;
  for (const PersonTrip& one : trips.persons) ++people[kind_of(one, cast.traits)];
  for (const VehicleTrip& one : trips.vehicles) ++vehicles[plain_type(one.type)];
  return {{"name", input.plan.conditions[run.condition].name},
          {"people", kinds_text(people)},
          {"seed", run.seed},
          {"vehicles", vehicles.empty() ? "none" : kinds_text(vehicles)}};
}

/// "striping 1.2, heuristic 0.4", means of the seeds.
std::string peak_text(const Input& input, std::size_t condition) {
  std::vector<std::string> parts;
  for (const Comparison& one : input.comparisons) {
    if (one.condition != condition || one.measure != "space.peak" || !one.reference.mean) continue;
    if (parts.empty()) {
      parts.push_back(input.plan.study.reference + " " + digits_text(one.reference.mean));
    }
    parts.push_back(one.model + " " + digits_text(one.sample.mean));
  }
  return joined(parts);
}

}  // namespace

Json demand_part(const Input& input) {
  Json all = Json::array();
  for (std::size_t i = 0; i < pictured(input.plan); ++i) {
    const auto run = first_done_run(input, i);
    if (!run) continue;
    try {
      Json demand = demand_of(input, input.plan.runs[*run]);
      demand["peak"] = peak_text(input, i);
      all.push_back(std::move(demand));
    } catch (const InputError&) {
      continue;  // outputs were removed to save room: the tables stand without them
    }
  }
  return all;
}

}  // namespace pedzone::study::report
