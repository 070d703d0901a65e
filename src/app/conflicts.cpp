#include "app/conflicts.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "app/guarded.hpp"
#include "app/share_bar.hpp"
#include "conflict/tracker.hpp"
#include "core/error.hpp"
#include "sumo/files/fcd_reader.hpp"
#include "sumo/files/scenario.hpp"

namespace pedzone {
namespace {

BodySizes read_sizes(const ConflictsOptions& options) {
  BodySizes sizes;
  if (!options.scenario.empty()) {
    const Scenario scenario = read_any_scenario(options.scenario, {});
    for (const std::string& file : scenario.additional_files) sizes.read(file);
    for (const std::string& file : scenario.route_files) sizes.read(file);
  }
  for (const std::string& file : options.types) sizes.read(file);
  return sizes;
}

void require_types(const BodySizes& sizes, const std::vector<std::string>& types) {
  for (const std::string& type : types) {
    if (sizes.of_type(type)) continue;
    throw InputError("is not a known vehicle type",
                     {.element = "option --treat-as-person",
                      .value = type,
                      .allowed = "types of the files given with --scenario and --vtypes"});
  }
}

void measure(const ConflictsOptions& options) {
  if (!options.conflicts.wanted()) {
    throw InputError("is missing", {.element = "option --conflict-output or --conflict-csv",
                                    .allowed = "a file to write"});
  }
  const BodySizes sizes = read_sizes(options);
  require_types(sizes, options.as_persons);
  ConflictWriter writer(options.conflicts.paths());
  ConflictTracker tracker(options.conflicts.limits);
  std::vector<Conflict> over;
  const auto write = [&] {
    for (const Conflict& conflict : over) writer.write(conflict);
    over.clear();
  };
  ShareBar bar("measuring conflicts");
  const std::unordered_set<std::string> as_persons(options.as_persons.begin(),
                                                   options.as_persons.end());
  FcdReader(sizes, as_persons)
      .read(
          options.fcd,
          [&](double time, std::span<const PersonSample> persons,
              std::span<const VehicleSample> vehicles) {
            tracker.step(time, persons, vehicles, {}, over);
            write();
          },
          [&](double share) { bar.update(share); });
  tracker.finish(over);
  write();
  bar.finish();
  writer.finish();
  fmt::print("{} conflicts\n", writer.written());
}

}  // namespace

int conflicts(const ConflictsOptions& options) {
  return guarded([&options] { measure(options); });
}

}  // namespace pedzone
