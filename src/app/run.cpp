#include "app/run.hpp"

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "app/guarded.hpp"
#include "app/path_recorder.hpp"
#include "app/progress.hpp"
#include "app/summary.hpp"
#include "app/supervise.hpp"
#include "app/thread_limit.hpp"
#include "conflict/tracker.hpp"
#include "core/error.hpp"
#include "model/walking_model.hpp"
#include "results/complete_file.hpp"
#include "results/trajectories.hpp"
#include "sumo/simulation.hpp"
#include "view/debug_shapes.hpp"

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

SimulationOptions prepare(const RunOptions& options) {
  SimulationOptions prepared;
  prepared.scenario = read_scenario(options.config, options.sumo_options);
  ZoneFile file = read_zone_file(options.zone_file, options.panel);
  if (file.panels.empty()) require_persons(prepared.scenario);
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

/// Tells of people who are stuck among people, of the first ones by name.
class JamWarnings {
 public:
  void step(const std::vector<JamRecord>& jams) {
    for (; told_ < std::min(jams.size(), kNamed); ++told_) {
      const JamRecord& jam = jams[told_];
      fmt::print(stderr,
                 "Warning: person '{}' in zone '{}' is stuck among people at ({:.1f}, {:.1f}), "
                 "time {:.1f}: it squeezes through.\n",
                 jam.person, jam.zone, jam.position.x(), jam.position.y(), jam.time);
    }
  }
  void finish(const std::vector<JamRecord>& jams) const {
    if (jams.size() > kNamed) {
      fmt::print(stderr, "Warning: {} more were stuck.\n", jams.size() - kNamed);
    }
  }

 private:
  static constexpr std::size_t kNamed = 10;
  std::size_t told_ = 0;
};

/// The files of a run: all finished together, or none.
struct Outputs {
  std::unique_ptr<CompleteFile> summary;
  std::unique_ptr<TrajectoryWriter> trajectories;
  std::unique_ptr<CompleteFile> picture;
  PathRecorder paths;
  std::unique_ptr<CompleteFile> shapes;
  double shapes_time = std::numeric_limits<double>::infinity();  ///< [s]
  std::string shapes_text;                                       ///< empty: it is not yet that time
  std::unique_ptr<ConflictWriter> conflicts;
  std::unique_ptr<ConflictTracker> tracker;
  std::vector<Conflict> over;

  explicit Outputs(const RunOptions& options) {
    if (!options.summary.empty()) {
      summary = std::make_unique<CompleteFile>(options.summary, "--summary");
    }
    if (!options.trajectories.empty()) {
      trajectories = std::make_unique<TrajectoryWriter>(options.trajectories, "--trajectories");
    }
    if (!options.picture.empty()) {
      picture = std::make_unique<CompleteFile>(options.picture, "--paths-svg");
    }
    if (!options.debug_shapes.empty()) {
      shapes = std::make_unique<CompleteFile>(options.debug_shapes, "--debug-shapes");
      shapes_time = options.debug_time.value_or(shapes_time);
    }
    if (options.conflicts.wanted()) {
      conflicts = std::make_unique<ConflictWriter>(options.conflicts.paths());
      tracker = std::make_unique<ConflictTracker>(options.conflicts.limits);
    }
  }

  void observe(Simulation& simulation) {
    if (!tracker) return;
    simulation.observe([this](const Scene& scene) {
      tracker->step(scene.time, scene.persons, scene.vehicles, scene.aware, over);
    });
  }

  /// Where everybody is now and what it is about to do.
  void take_shapes(Simulation& simulation) {
    std::vector<Insight> insights = simulation.insights();
    std::vector<DebuggedPerson> persons;
    for (std::size_t k = 0; k < insights.size(); ++k) {
      persons.push_back({simulation.guests()[k].id, std::move(insights[k])});
    }
    shapes_text = debug_shapes(simulation.zones(), simulation.paths(), persons);
  }

  void write_conflicts() {
    for (const Conflict& conflict : over) conflicts->write(conflict);
    over.clear();
  }

  /// `time` [s] before the step, by which SUMO's own outputs name a step's result.
  void step(double time, Simulation& simulation) {
    if (shapes && shapes_text.empty() && time >= shapes_time) take_shapes(simulation);
    if (tracker) write_conflicts();
    if (picture) paths.observe(simulation);
    if (!trajectories) return;
    for (const Guest& guest : simulation.guests()) {
      trajectories->row(time, guest.id, simulation.view(guest));
    }
  }

  void finish(Simulation& simulation, const RunSummary& totals) {
    if (shapes && shapes_text.empty()) take_shapes(simulation);
    if (shapes) shapes->write(shapes_text);
    if (summary) summary->write(summary_json(totals));
    if (picture) picture->write(paths.picture(simulation));
    if (tracker) {
      tracker->finish(over);
      write_conflicts();
      conflicts->finish();
    }
    if (trajectories) trajectories->finish();
    if (picture) picture->finish();
    if (shapes) shapes->finish();
    if (summary) summary->finish();
  }
};

void simulate(const RunOptions& options) {
  const ThreadLimit limit(options.threads);
  const SimulationOptions prepared = prepare(options);
  Outputs outputs(options);
  Simulation simulation(prepared);
  outputs.observe(simulation);
  for (const Zone& zone : simulation.zones()) {
    if (!zone.warnings.empty()) {
      fmt::print(stderr, "Zone '{}': {} warnings about its shape; `pedzone inspect` lists them.\n",
                 zone.id, zone.warnings.size());
    }
  }
  JamWarnings jams;
  Progress progress(simulation.time(), simulation.end_time());
  while (!simulation.finished()) {
    const double time = simulation.time();
    simulation.step();
    outputs.step(time, simulation);
    jams.step(simulation.jams());
    progress.update(simulation.time(), simulation.guests().size());
  }
  progress.finish();
  jams.finish(simulation.jams());
  const RunSummary totals = simulation.summary();
  simulation.close();
  outputs.finish(simulation, totals);
  fmt::print("{}", summary_table(totals));
}

}  // namespace

int run(const RunOptions& options) {
  const auto work = [&options] { return guarded([&] { simulate(options); }); };
  return supervise(work, {options.summary, options.trajectories, options.picture,
                          options.debug_shapes, options.conflicts.xml, options.conflicts.csv});
}

}  // namespace pedzone
