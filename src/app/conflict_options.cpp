#include "app/conflict_options.hpp"

#include "app/command_line/values.hpp"

namespace pedzone {
namespace {

constexpr const char* kXml = "--conflict-output";
constexpr const char* kCsv = "--conflict-csv";

}  // namespace

ConflictWriter::Paths ConflictOptions::paths() const { return {xml, kXml, csv, kCsv}; }

void add_conflict_options(CLI::App& command, ConflictOptions& options) {
  const char* group = "Conflicts of persons and vehicles";
  const auto add = [&](const char* name, auto& value, const std::string& what) {
    return command.add_option(name, value, what)->group(group);
  };
  add(kXml, options.xml, "Write them as XML, in the manner of SUMO's SSM device")->type_name(kFile);
  add(kCsv, options.csv, "Write them as a table")->type_name(kFile);
  add("--conflicts-of", options.of,
      "Which people count. zones: those that pedzone walks, if known; all: everybody")
      ->check(one_of({"zones", "all"}))
      ->type_name(kNames)
      ->capture_default_str();
  const auto limit = [&](const char* name, double& value, double most, const char* unit,
                         const char* what, double least = 0.0) {
    add(name, value, what)->check(number_in(least, most))->type_name(unit)->capture_default_str();
  };
  ConflictLimits& limits = options.limits;
  limit("--conflict-ttc", limits.ttc, 60, kSeconds, "Report a conflict if TTC falls below this");
  limit("--conflict-pet", limits.pet, 60, kSeconds, "... or PET falls below this");
  limit("--conflict-drac", limits.drac, 100, "M/S2", "... or DRAC rises above this");
  limit("--conflict-range", limits.range, 1000, kMetres, "Ignore vehicles farther away than this",
        1.0);
  limit("--conflict-horizon", limits.horizon, 60, kSeconds, "Look so far ahead for a TTC");
}

}  // namespace pedzone
