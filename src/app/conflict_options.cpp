#include "app/conflict_options.hpp"

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
  add(kXml, options.xml, "Write them as XML, in the manner of SUMO's SSM device");
  add(kCsv, options.csv, "Write them as a table");
  const auto limit = [&](const char* name, double& value, double least, double most,
                         const char* what) {
    add(name, value, what)->check(CLI::Range(least, most))->capture_default_str();
  };
  ConflictLimits& limits = options.limits;
  limit("--conflict-ttc", limits.ttc, 0, 60, "Told where the TTC falls below this [s] ...");
  limit("--conflict-pet", limits.pet, 0, 60, "... or the PET [s] ...");
  limit("--conflict-drac", limits.drac, 0, 100, "... or the DRAC rises above this [m/s2]");
  limit("--conflict-range", limits.range, 1, 1000, "Nobody farther away is detected [m]");
  limit("--conflict-horizon", limits.horizon, 0, 60, "A longer TTC is none [s]");
}

}  // namespace pedzone
