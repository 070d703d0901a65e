#include "app/output_files.hpp"

#include <unistd.h>

#include <filesystem>
#include <map>

#include "app/summary.hpp"
#include "core/error.hpp"
#include "results/crossing_table.hpp"
#include "view/debug_shapes.hpp"

namespace pedzone {
namespace {

struct NamedOutput {
  std::string option, path;
};

std::vector<NamedOutput> named_outputs(const RunOptions& options) {
  std::vector<NamedOutput> wanted;
  const ConflictWriter::Paths conflicts = options.conflicts.paths();
  for (const NamedOutput& output :
       {NamedOutput{"--summary", options.summary},
        {"--trajectories", options.trajectories},
        {"--trajectories", TrajectoryWriter::side_file(options.trajectories)},
        {"--crossing-output", options.crossings},
        {"--edge-data", options.edge_data},
        {"--paths-svg", options.picture},
        {"--animate", options.animation},
        {"--debug-shapes", options.debug_shapes},
        {conflicts.xml_option, conflicts.xml},
        {conflicts.csv_option, conflicts.csv}}) {
    if (!output.path.empty()) wanted.push_back(output);
  }
  return wanted;
}

/// Those of SUMO that are named after `--`.
std::vector<NamedOutput> sumo_outputs(const std::vector<std::string>& words) {
  constexpr std::string_view kEnding = "-output";
  std::vector<NamedOutput> outputs;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    const std::string option = words[i].substr(0, equals);
    if (!option.starts_with("--") || !option.ends_with(kEnding)) continue;
    if (equals != std::string::npos) outputs.push_back({option, words[i].substr(equals + 1)});
    if (equals == std::string::npos && i + 1 < words.size())
      outputs.push_back({option, words[i + 1]});
  }
  return outputs;
}

/// Of people whom SUMO walks the table would have to make up what they are doing.
bool wants_everybody(const RunOptions& options) {
  if (options.trajectories_of != "all") return false;
  if (!TrajectoryWriter::is_table(options.trajectories)) return true;
  throw InputError("cannot be had in a table",
                   {.element = "option --trajectories-of",
                    .value = options.trajectories_of,
                    .allowed = "zones; or --trajectories NAME.sqlite or NAME.txt; SUMO's "
                               "--fcd-output has everybody, too"});
}

std::string text_of(const std::vector<StreetCrossed>& crossings) {
  std::string text = crossing_table().header();
  for (const StreetCrossed& row : crossings) crossing_table().append(text, row);
  return text;
}

}  // namespace

std::vector<std::string> outputs_of(const RunOptions& options) {
  std::vector<std::string> paths;
  for (const NamedOutput& output : named_outputs(options)) paths.push_back(output.path);
  return paths;
}

void require_different_outputs(const RunOptions& options) {
  std::map<std::string, std::string> option_of;
  const auto claim = [&](const NamedOutput& output) {
    const auto [other, is_new] = option_of.emplace(CompleteFile::place(output.path), output.option);
    return is_new ? "" : other->second;
  };
  for (const NamedOutput& output : sumo_outputs(options.sumo_options)) {
    if (!CompleteFile::partial(output.path).empty()) claim(output);
  }
  for (const NamedOutput& output : named_outputs(options)) {
    if (CompleteFile::place(output.path).empty()) continue;
    const std::string other = claim(output);
    if (other.empty()) continue;
    throw InputError("names the same file as " + other,
                     {"", 0, "option " + output.option, output.path, "a file for each output"});
  }
}

void keep_standard_output_clean(RunOptions& options) {
  std::string clean;
  for (std::string* path :
       {&options.summary, &options.trajectories, &options.crossings, &options.edge_data,
        &options.picture, &options.animation, &options.debug_shapes, &options.conflicts.xml,
        &options.conflicts.csv}) {
    if (!CompleteFile::is_standard_output(*path)) continue;
    if (clean.empty()) {
      clean = "/dev/fd/" + std::to_string(dup(STDOUT_FILENO));
      dup2(STDERR_FILENO, STDOUT_FILENO);
    }
    *path = clean;
  }
}

OutputFiles::OutputFiles(const RunOptions& options) {
  if (!options.summary.empty()) {
    summary_ = std::make_unique<CompleteFile>(options.summary, "--summary");
  }
  if (!options.trajectories.empty()) {
    trajectories_ = std::make_unique<TrajectoryWriter>(options.trajectories, "--trajectories");
    everybody_ = wants_everybody(options);
  }
  if (!options.crossings.empty()) {
    crossings_ = std::make_unique<CompleteFile>(options.crossings, "--crossing-output");
  }
  if (!options.edge_data.empty()) {
    edge_data_ = std::make_unique<EdgeDataWriter>(options.edge_data, "--edge-data",
                                                  options.edge_data_period);
  }
  if (!options.picture.empty()) {
    picture_ = std::make_unique<CompleteFile>(options.picture, "--paths-svg");
  }
  if (!options.animation.empty()) animation_ = std::make_unique<RunAnimation>(options);
  if (!options.debug_shapes.empty()) {
    shapes_ = std::make_unique<CompleteFile>(options.debug_shapes, "--debug-shapes");
    shapes_time_ = options.debug_time.value_or(shapes_time_);
  }
  if (options.conflicts.wanted()) {
    conflict_options_ = options.conflicts;
    conflicts_ = std::make_unique<ConflictWriter>(options.conflicts.paths());
    tracker_ = std::make_unique<ConflictTracker>(options.conflicts.limits);
  }
}

void OutputFiles::begin(Simulation& simulation) {
  if (trajectories_) {
    trajectories_->begin(
        {simulation.time(), simulation.step_length(), simulation.ground(everybody_)});
  }
  if (edge_data_) {
    edge_data_->begin(simulation.network(), simulation.zones(), simulation.time());
  }
  if (!tracker_) return;
  simulation.observe([this](const Observation& observation) {
    tracker_->step(observation.time, observation.persons, observation.vehicles, observation.aware,
                   over_);
  });
}

/// Where everybody is now and what it is about to do.
void OutputFiles::take_shapes(Simulation& simulation) {
  std::vector<Insight> insights = simulation.insights();
  std::vector<DebuggedPerson> persons;
  for (std::size_t k = 0; k < insights.size(); ++k) {
    persons.push_back({simulation.guests()[k].id, std::move(insights[k])});
  }
  shapes_text_ = debug_shapes(simulation.zones(), simulation.paths(), persons);
}

void OutputFiles::write_conflicts() {
  for (const Conflict& conflict : over_) {
    if (conflict_options_.takes(conflict)) conflicts_->write(conflict);
  }
  over_.clear();
}

void OutputFiles::step(double time, Simulation& simulation) {
  if (shapes_ && shapes_text_.empty() && time >= shapes_time_) take_shapes(simulation);
  if (tracker_) write_conflicts();
  if (picture_) paths_.observe(simulation);
  if (trajectories_) write_places(time, simulation);
  if (animation_) {
    for (const Guest& guest : simulation.guests()) {
      animation_->row(time, guest.id, simulation.view(guest));
    }
  }
  if (edge_data_) write_edges(time, simulation);
}

void OutputFiles::write_edges(double time, Simulation& simulation) {
  std::vector<PersonOnEdge> persons;
  for (const Guest& guest : simulation.guests()) {
    const PersonView view = simulation.view(guest);
    persons.push_back(
        {guest.id, guest.zone, view.position, view.velocity.norm(), guest.preferred_speed});
  }
  edge_data_->step(time, simulation.step_length(), persons);
}

void OutputFiles::write_places(double time, Simulation& simulation) {
  for (const Guest& guest : simulation.guests()) {
    trajectories_->row(time, guest.id, simulation.view(guest));
  }
  if (!everybody_) return;
  for (const Passer& person : simulation.passers()) {
    trajectories_->row({.time = time,
                        .id = person.id,
                        .x = person.position.x(),
                        .y = person.position.y(),
                        .heading = person.heading});
  }
}

void OutputFiles::finish(Simulation& simulation, const RunSummary& totals) {
  if (shapes_ && shapes_text_.empty()) take_shapes(simulation);
  if (shapes_) shapes_->write(shapes_text_);
  if (summary_) summary_->write(summary_json(totals));
  if (crossings_) crossings_->write(text_of(simulation.crossings()));
  if (picture_) picture_->write(paths_.picture(simulation));
  if (tracker_) {
    tracker_->finish(over_);
    write_conflicts();
    conflicts_->finish();
  }
  if (trajectories_) trajectories_->finish();
  if (edge_data_) edge_data_->finish();
  if (crossings_) crossings_->finish();
  if (picture_) picture_->finish();
  if (shapes_) shapes_->finish();
  if (summary_) summary_->finish();
  if (!animation_) return;
  animation_->write(simulation);  // reads what SUMO wrote: if that fails, the others are there
  animation_->finish();
}

}  // namespace pedzone
