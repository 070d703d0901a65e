#include "app/conflicts.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "app/command_line/common_options.hpp"
#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/conflict_options.hpp"
#include "app/conflicts_json.hpp"
#include "app/guarded.hpp"
#include "app/recorded_conflicts.hpp"
#include "app/recording_options.hpp"
#include "app/seen_crossings.hpp"
#include "app/share_bar.hpp"
#include "conflict/tracker.hpp"
#include "core/error.hpp"
#include "results/complete_file.hpp"
#include "sumo/files/fcd_reader.hpp"
#include "sumo/files/type_files.hpp"
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

/// Where conflicts go that are over: files, the crossings of a street, the terminal.
class ConflictOutputs {
 public:
  explicit ConflictOutputs(const ConflictsOptions& options)
      : options_(options), writer_(options.conflicts.paths()) {
    if (options.crossings.zone_file.empty()) return;
    crossings_ = std::make_unique<SeenCrossings>(options.scenario, options.crossings);
  }

  void step(double time, std::span<const PersonSample> persons,
            std::span<const VehicleSample> vehicles) {
    if (crossings_) crossings_->step(time, persons, vehicles);
  }

  /// Takes and empties `over`.
  void take(std::vector<Conflict>& over) {
    for (const Conflict& conflict : over) {
      if (!options_.conflicts.takes(conflict)) {
        ++others_;
        continue;
      }
      writer_.write(conflict);
      if (crossings_) crossings_->add(conflict);
      if (options_.json) printed_.push_back(conflict);
    }
    over.clear();
  }

  /// `known`: whom pedzone walked.
  void finish(bool known) {
    writer_.finish();
    std::optional<CrossingNumbers> crossed;
    if (crossings_) crossed = crossings_->finish();
    if (options_.json) return print_text(conflicts_json(printed_, crossed));
    print_result(scope_text(writer_.written(), others_, known, options_.conflicts.of) +
                 (crossed ? text_of(*crossed) : ""));
  }

 private:
  const ConflictsOptions& options_;
  ConflictWriter writer_;
  std::unique_ptr<SeenCrossings> crossings_;
  std::vector<Conflict> printed_;
  std::size_t others_ = 0;
};

void require_output(const ConflictsOptions& options) {
  const ConflictWriter::Paths paths = options.conflicts.paths();
  for (const auto& [option, path] :
       {std::pair(paths.csv_option, paths.csv), std::pair(paths.xml_option, paths.xml)}) {
    if (!options.json || !CompleteFile::is_standard_output(path)) continue;
    throw InputError("is standard output, where --json prints",
                     {.element = "option " + option, .value = path, .allowed = "a file"});
  }
  if (options.conflicts.wanted() || options.json || !options.crossings.zone_file.empty()) return;
  throw InputError("is missing", {.element = "option --conflict-output, --conflict-csv or --json",
                                  .allowed = "one of them or more"});
}

void measure(const ConflictsOptions& options) {
  require_output(options);
  const auto sizes = read_type_files<BodySizes>(options.scenario, {}, options.types);
  require_types(sizes, options.as_persons);
  warn_of_guessed_sizes(sizes);
  const std::unordered_set<std::string> as_persons(options.as_persons.begin(),
                                                   options.as_persons.end());
  ConflictOutputs outputs(options);
  const std::optional<WalkedByPedzone> walked = read_walked(options.trajectories);
  ConflictTracker tracker(options.conflicts.limits);
  std::vector<Conflict> over;
  std::vector<PersonSample> known;
  const auto step = [&](double time, std::span<const PersonSample> persons,
                        std::span<const VehicleSample> vehicles) {
    if (walked) {
      known.assign(persons.begin(), persons.end());
      for (PersonSample& one : known) one.by_pedzone = walked->at(one.id, time);
      persons = known;
    }
    outputs.step(time, persons, vehicles);
    tracker.step(time, persons, vehicles, {}, over);
    outputs.take(over);
  };
  ShareBar bar("measuring conflicts");
  FcdReader(sizes, as_persons).read(options.fcd, step, [&](double share) { bar.update(share); });
  tracker.finish(over);
  outputs.take(over);
  bar.finish();
  warn_of_long_steps(tracker);
  outputs.finish(walked.has_value());
}

constexpr const char* kFooter =
    "Examples:\n"
    "  sumo -c town.sumocfg --fcd-output fcd.xml.gz\n"
    "  pedzone conflicts fcd.xml.gz --scenario town.sumocfg --conflict-output conflicts.xml\n\n"
    "  pedzone conflicts fcd.xml.gz --scenario street.sumocfg --zone street.zone.xml \\\n"
    "          --crossing-svg gaps.svg\n\n"
    "The same measures as `pedzone run --conflict-output`. It does not matter who walked the\n"
    "people. With --trajectories, only people whom pedzone walked count. SUMO writes positions to\n"
    "0.01 m; its option --precision 4 makes the measures smoother.\n"
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
                   "SUMO configuration: its files have the sizes of vehicles and persons")
      ->type_name(kFile);
  command->add_option("--vtypes", options->types, "More route or additional files with sizes")
      ->type_name(kFile)
      ->allow_extra_args(false);
  command
      ->add_option("--treat-as-person", options->as_persons,
                   "Types of vehicles that count as persons, e.g. wheelchairs")
      ->type_name("TYPE")
      ->allow_extra_args(false);
  command
      ->add_option("--trajectories", options->trajectories,
                   "pedzone's --trajectories (table) of the same run: whom pedzone walked")
      ->type_name(kFile);
  auto* zone = command
                   ->add_option("--zone", options->crossings.zone_file,
                                "Zone file with crossing=\"anywhere\" (needs --scenario). Adds: "
                                "where people cross, conflicts on the near and far half of the "
                                "street, gaps taken")
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
