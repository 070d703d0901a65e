#include "app/run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/guarded.hpp"
#include "app/interrupts.hpp"
#include "app/output_files.hpp"
#include "app/progress.hpp"
#include "app/summary.hpp"
#include "app/supervise.hpp"
#include "app/thread_limit.hpp"
#include "app/warnings.hpp"
#include "core/error.hpp"
#include "model/walking_model.hpp"
#include "sumo/simulation.hpp"

namespace pedzone {
namespace {

/// Has every zone walked by the model; the zone that is found by itself, too.
void set_model(const std::string& model, std::vector<ZoneSpec>& zones) {
  try {
    (void)make_model(model);
  } catch (const ModelError& error) {
    throw InputError(error.problem, {"", 0, "option --model", model, error.allowed});
  }
  if (zones.empty()) zones.emplace_back();
  for (ZoneSpec& zone : zones) zone.model = model;
}

/// A study of many towns goes on.
void tell_of_nobody(const RunOptions& options, const Scenario& scenario) {
  if (names_person(scenario)) return;
  const InputError error = no_person(scenario);
  if (options.strict) throw error;
  fmt::print(stderr, "Warning: {}. Nobody is walked.\n", error.what());
}

void tell_of_no_zone(const RunOptions& options, const Simulation& simulation) {
  if (!simulation.zones().empty()) return;
  fmt::print(stderr,
             "Warning: {} has no shared space: SUMO walks everybody. `pedzone inspect {}` shows "
             "edges that could be a zone, and what a zone file (--zone) has to say of them. With "
             "--strict this is an error.\n",
             simulation.network().file, options.config);
}

SimulationOptions prepare(const RunOptions& options) {
  SimulationOptions prepared;
  prepared.scenario = read_scenario(options.config, options.sumo_options);
  ZoneFile file = read_zone_file(options.zone_file, options.panel);
  if (file.panels.empty()) tell_of_nobody(options, prepared.scenario);
  prepared.needs_zone = options.strict || !file.panels.empty();
  if (options.model) set_model(*options.model, file.zones);
  prepared.zones = std::move(file.zones);
  prepared.profiles = std::move(file.profiles);
  prepared.paths = std::move(file.paths);
  prepared.panels = std::move(file.panels);
  if (!options.zone_file.empty()) prepared.vehicle_paths = read_vehicle_paths(options.zone_file);
  prepared.seed = options.seed;
  prepared.end = options.end;
  return prepared;
}

/// Tells of a run that was ended early.
void warn_of_interrupt(const RunSummary& totals) {
  fmt::print(
      stderr,
      "Interrupted at {:.1f} s (signal {}): the outputs hold what was simulated until then.\n",
      totals.time.simulated_s, totals.interrupted_by);
}

/// Farther out people decide otherwise by rounding; measured: nearer they do as at the origin, to
/// 1 nm (cli.any_scenario).
void warn_of_far_places(const Network& network) {
  constexpr double kFar = 8388608.0;  // [m] 2^23
  const bool far = std::ranges::any_of(network.lanes, [](const Lane& lane) {
    return std::ranges::any_of(
        lane.shape, [](const Vec2& point) { return point.cwiseAbs().maxCoeff() > kFar; });
  });
  if (!far) return;
  fmt::print(stderr,
             "Warning: {} has coordinates beyond {:.0f} m: people walk a little differently there "
             "than near the origin. netconvert's --offset.x and --offset.y move a network.\n",
             network.file, kFar);
}

void warn_of_shapes(const Simulation& simulation) {
  for (const Zone& zone : simulation.zones()) {
    if (zone.warnings.empty()) continue;
    fmt::print(stderr, "Zone '{}': {} warnings about its shape; `pedzone inspect` lists them.\n",
               zone.id, zone.warnings.size());
  }
}

/// To its end, or until it is interrupted.
void walk(Simulation& simulation, OutputFiles& outputs, Progress& progress) {
  JamWarnings jams;
  StuckWarning stuck;
  progress.start(simulation.time(), simulation.end_time());
  note_interrupts();
  while (!simulation.finished() && noted_interrupt() == 0) {
    const double time = simulation.time();
    simulation.step();
    outputs.step(time, simulation);
    jams.step(simulation, progress);
    stuck.step(simulation, progress);
    progress.update(simulation.time(), simulation.guests().size());
  }
  progress.finish();
  jams.finish(simulation, progress);
}

/// Its exit code: 0, or 128 + the signal that ended it early.
int simulate(const RunOptions& options) {
  const ThreadLimit limit(options.threads);
  const SimulationOptions prepared = prepare(options);
  OutputFiles outputs(options);
  Progress progress(!options.quiet && !has_step_log(prepared.scenario));
  Simulation simulation(prepared);
  outputs.begin(simulation);
  tell_of_no_zone(options, simulation);
  warn_of_far_places(simulation.network());
  warn_of_shapes(simulation);
  walk(simulation, outputs, progress);
  RunSummary totals = simulation.summary();
  totals.interrupted_by = noted_interrupt();
  const bool warns = simulation.warns();
  simulation.close();
  if (warns) totals.sumo.warnings = progress.warnings();
  outputs.finish(simulation, totals);
  if (!options.quiet) fmt::print("{}", summary_table(totals));
  if (totals.interrupted_by == 0) return 0;
  warn_of_interrupt(totals);
  return 128 + totals.interrupted_by;
}

}  // namespace

int run(const RunOptions& options) {
  const auto work = [options = options]() mutable {
    keep_standard_output_clean(options);
    int ended = 0;
    const int code = guarded([&] { ended = simulate(options); });
    return code != 0 ? code : ended;
  };
  return supervise(work, outputs_of(options));
}

}  // namespace pedzone
