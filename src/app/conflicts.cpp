#include "app/conflicts.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "app/command_line/common_options.hpp"
#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/conflict_options.hpp"
#include "app/conflicts_json.hpp"
#include "app/guarded.hpp"
#include "app/seen_crossings.hpp"
#include "app/share_bar.hpp"
#include "conflict/tracker.hpp"
#include "core/error.hpp"
#include "sumo/files/fcd_reader.hpp"
#include "sumo/files/scenario.hpp"
#include "sumo/files/walked_by_pedzone.hpp"

namespace pedzone {
namespace {

struct ConflictsOptions {
  std::string fcd;                      ///< fcd-output
  std::string scenario;                 ///< .sumocfg whose files tell sizes; empty: none
  std::string trajectories;             ///< of pedzone, which tell whom it walked; empty: none
  std::vector<std::string> types;       ///< more files that do
  std::vector<std::string> as_persons;  ///< vehicle types that count as persons
  bool json = false;                    ///< all of them are printed, too
  ConflictOptions conflicts;
  SeenCrossingOptions crossings;
};

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

/// How many were told, and whose they are: another scope would give another number.
std::string scope_text(std::size_t told, std::size_t others, bool known, const std::string& of) {
  if (!known) return fmt::format("{} conflicts of everybody in the file\n", told);
  if (of == "all") return fmt::format("{} conflicts of everybody\n", told);
  return fmt::format(
      "{} conflicts of people whom pedzone walked; {} of others (--conflicts-of all)\n", told,
      others);
}

void measure(const ConflictsOptions& options) {
  if (!options.conflicts.wanted() && !options.json && options.crossings.zone_file.empty()) {
    throw InputError("is missing", {.element = "option --conflict-output, --conflict-csv or --json",
                                    .allowed = "one of them or more"});
  }
  const BodySizes sizes = read_sizes(options);
  require_types(sizes, options.as_persons);
  ConflictWriter writer(options.conflicts.paths());
  ConflictTracker tracker(options.conflicts.limits);
  const std::optional<WalkedByPedzone> walked = read_walked(options.trajectories);
  std::vector<Conflict> over, printed;
  std::size_t others = 0;
  std::unique_ptr<SeenCrossings> crossings;
  if (!options.crossings.zone_file.empty()) {
    crossings = std::make_unique<SeenCrossings>(options.scenario, options.crossings);
  }
  const auto write = [&] {
    for (const Conflict& conflict : over) {
      if (!options.conflicts.takes(conflict)) {
        ++others;
        continue;
      }
      writer.write(conflict);
      if (crossings) crossings->add(conflict);
      if (options.json) printed.push_back(conflict);
    }
    over.clear();
  };
  std::vector<PersonSample> told;
  ShareBar bar("measuring conflicts");
  const std::unordered_set<std::string> as_persons(options.as_persons.begin(),
                                                   options.as_persons.end());
  FcdReader(sizes, as_persons)
      .read(
          options.fcd,
          [&](double time, std::span<const PersonSample> persons,
              std::span<const VehicleSample> vehicles) {
            if (walked) {
              told.assign(persons.begin(), persons.end());
              for (PersonSample& one : told) one.by_pedzone = walked->at(one.id, time);
              persons = told;
            }
            if (crossings) crossings->step(time, persons, vehicles);
            tracker.step(time, persons, vehicles, {}, over);
            write();
          },
          [&](double share) { bar.update(share); });
  tracker.finish(over);
  write();
  bar.finish();
  writer.finish();
  const std::string crossed = crossings ? crossings->finish() : "";
  if (options.json) {
    print_text(conflicts_json(printed));
  } else {
    print_result(scope_text(writer.written(), others, walked.has_value(), options.conflicts.of) +
                 crossed);
  }
}

constexpr const char* kFooter =
    "Examples:\n"
    "  sumo -c town.sumocfg --fcd-output fcd.xml.gz\n"
    "  pedzone conflicts fcd.xml.gz --scenario town.sumocfg --conflict-output conflicts.xml\n\n"
    "  pedzone conflicts fcd.xml.gz --scenario street.sumocfg --zone street.zone.xml \\\n"
    "          --crossing-svg gaps.svg\n\n"
    "The same measures as `pedzone run --conflict-output`, whoever walked the persons: with\n"
    "--trajectories those of people whom pedzone walked, else everybody's. SUMO\n"
    "writes positions to 0.01 m; its option --precision 4 makes the measures smoother.\n"
    "Exit codes: 0 done, 2 input at fault.";

}  // namespace

void add_conflicts(CLI::App& app, int& code) {
  const auto options = std::make_shared<ConflictsOptions>();
  CLI::App* command = app.add_subcommand(
      "conflicts", "Measure conflicts of persons and vehicles in SUMO's floating-car data");
  command->footer(kFooter);
  command->add_option("fcd", options->fcd, "SUMO's fcd-output, gzipped or not")->required();
  command
      ->add_option("--scenario", options->scenario,
                   "SUMO configuration whose files tell how large vehicles and persons are")
      ->type_name(kFile);
  command->add_option("--vtypes", options->types, "More route or additional files that tell it")
      ->type_name(kFile)
      ->allow_extra_args(false);
  command
      ->add_option("--treat-as-person", options->as_persons,
                   "Types of vehicles that count as persons, e.g. wheelchairs")
      ->type_name("TYPE")
      ->allow_extra_args(false);
  command
      ->add_option("--trajectories", options->trajectories,
                   "pedzone's --trajectories (table) of the same run, which tell whom it walked")
      ->type_name(kFile);
  auto* zone = command
                   ->add_option("--zone", options->crossings.zone_file,
                                "Zone file with crossing=\"anywhere\": who crosses its streets "
                                "where, conflicts on their near and far half, and the gaps that "
                                "people take (with --scenario)")
                   ->type_name(kFile);
  command->add_option("--crossing-csv", options->crossings.csv, "Write these crossings as a table")
      ->type_name(kFile)
      ->needs(zone);
  command
      ->add_option("--crossing-svg", options->crossings.svg,
                   "Draw the share of gaps taken, by their length")
      ->type_name(kFile)
      ->needs(zone);
  add_json_flag(*command, options->json);
  add_conflict_options(*command, options->conflicts);
  command->callback([options, &code] { code = guarded([&] { measure(*options); }); });
}

}  // namespace pedzone
