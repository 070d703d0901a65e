#include "app/recorded_conflicts.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "app/command_line/terminal.hpp"
#include "study/measure/conflict_measures.hpp"
#include "sumo/files/fcd_reader.hpp"
#include "sumo/files/type_files.hpp"
#include "sumo/files/walked_by_pedzone.hpp"

namespace pedzone {
namespace {

bool is_told(const Conflict& conflict) {
  return conflict.by_pedzone.value_or(true) && study::with_moving_vehicle(conflict) &&
         !study::is_insertion(conflict);
}

}  // namespace

void warn_of_long_steps(const ConflictTracker& tracker) {
  // [s] measured: the plaza's run has no contact with steps of up to 2 s, and four with 5 s.
  constexpr double kLong = 2.0;
  if (tracker.longest_step() <= kLong) return;
  print_warning(
      fmt::format("the fcd-output has a step of {:g} s: conflicts and contacts that there were not "
                  "can be among "
                  "these. Steps of up to {:g} s are short enough (--device.fcd.period).",
                  tracker.longest_step(), kLong));
}

std::optional<std::vector<Conflict>> recorded_conflicts(const RecordingOptions& options) {
  const RecordingSource& source = options.source;
  const bool table = is_trajectory_table(source.file);
  if (table && source.fcd.empty()) return std::nullopt;
  const std::optional<WalkedByPedzone> walked = read_walked(table ? source.file : "");
  const std::unordered_set<std::string> wanted(source.persons.begin(), source.persons.end());
  ConflictTracker tracker(ConflictLimits{});
  std::vector<Conflict> over, told;
  const auto take = [&] {
    for (Conflict& conflict : over) {
      if (is_told(conflict)) told.push_back(std::move(conflict));
    }
    over.clear();
  };
  std::vector<PersonSample> shown;
  const auto sizes =
      read_type_files<BodySizes>(options.scenario, options.sumo_options, options.types);
  const std::unordered_set<std::string> none;
  FcdReader(sizes, none)
      .read(table ? source.fcd : source.file,
            [&](double time, std::span<const PersonSample> persons,
                std::span<const VehicleSample> vehicles) {
              if (time < source.begin || time > source.end) return;
              shown.clear();
              for (PersonSample one : persons) {
                if (!wanted.empty() && !wanted.contains(std::string(one.id))) continue;
                if (walked) one.by_pedzone = walked->at(one.id, time);
                shown.push_back(one);
              }
              tracker.step(time, shown, vehicles, {}, over);
              take();
            },
            {});
  tracker.finish(over);
  take();
  warn_of_long_steps(tracker);
  return told;
}

}  // namespace pedzone
