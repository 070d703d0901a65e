#include "study/run/unit.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <system_error>

#include "core/child_process.hpp"
#include "core/error.hpp"
#include "core/shell_word.hpp"
#include "results/complete_file.hpp"
#include "study/measure/free_walk_measure.hpp"
#include "study/measure/run_measures.hpp"
#include "sumo/files/place_reader.hpp"
#include "sumo/files/sumo_home.hpp"

namespace pedzone::study {
namespace {

/// From here on whatever this process and those that it starts print goes to the folder's log. Its
/// lock says that the folder is in use.
void print_to_log(const std::string& folder) {
  const std::string path = folder + "/" + kLogFile;
  const int log = open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (log < 0) throw std::system_error(errno, std::generic_category(), "cannot write " + path);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  close(log);  // before it is locked: closing a file unlocks it
  lock_file(STDOUT_FILENO);
}

/// Why a run failed.
struct Failure {
  std::string sentence;
  int code;
};

void simulate(const RunCommands& commands, const std::string& where, const std::string& folder) {
  for (const RunCommands::File& file : commands.files) {
    write_complete_file(folder + "/" + file.name, file.text, kOutOption);
  }
  for (const std::vector<std::string>& command : commands.commands) {
    fmt::print("$ {}\n", shell_command(command));  // as one would type it
    const Ending ending = run_program(command, where);
    if (ending.good()) continue;
    const std::string program = command.front().substr(command.front().rfind('/') + 1);
    throw Failure{program + " " + ending.text(), ending.from_outside() ? ending.exit_code() : 1};
  }
}

/// The place where it was, with the zones that it had.
Place place_of(const RunOutputs& outputs) {
  const std::string zone_file = outputs.folder + "/" + kZoneFile;
  return read_place(read_any_scenario(outputs.config, outputs.sumo_options),
                    std::filesystem::exists(zone_file) ? zone_file : "");
}

void measure(const RunOutputs& outputs, RunKind kind, RunRecord& record) {
  if (kind == RunKind::kFreeSpeed) {
    const std::string trajectories = outputs.folder + "/trajectories.csv";  // pedzone's only
    record.measures = free_walk_values(free_walks_of(
        outputs.folder + "/fcd.xml.gz", std::filesystem::exists(trajectories) ? trajectories : ""));
    return;
  }
  RunMeasures measures = measure_run(outputs, place_of(outputs));
  record.measures = std::move(measures.values);
  record.demand = std::move(measures.demand);
}

RunOutputs outputs_of(const RunContext& context, const PlannedRun& run, const RunCommands& commands,
                      const std::string& folder) {
  const Study& study = context.plan.study;
  const std::size_t scenario = context.plan.conditions[run.condition].scenario;
  const std::string people = folder + "/" + kPeopleFile;
  RunOutputs outputs{
      folder, study.resolve(study.scenarios[scenario].file), commands.sumo_options, {}};
  if (std::filesystem::exists(people)) outputs.types.push_back(people);
  return outputs;
}

/// The commands as one would repeat them: with outputs in the run's place, not where they were
/// made.
std::vector<std::vector<std::string>> in_place(std::vector<std::vector<std::string>> commands,
                                               const std::string& folder,
                                               const std::string& place) {
  for (std::vector<std::string>& command : commands) {
    for (std::string& word : command) {
      for (std::size_t at = 0; (at = word.find(folder, at)) != std::string::npos;) {
        word.replace(at, folder.size(), place);
        at += place.size();
      }
    }
  }
  return commands;
}

void make(RunContext& context, const PlannedRun& run, int attempt, const std::string& folder) {
  const auto begin = std::chrono::steady_clock::now();
  RunRecord record = blank_record(context, run);  // inputs as they are before anybody reads them
  const RunCommands commands = run_commands(context.plan, run, context.pedzone, folder);
  record.commands = in_place(commands.commands, folder, context.store.run_folder(run.id));
  simulate(commands, context.plan.study.folder, folder);
  measure(outputs_of(context, run, commands, folder), run.kind, record);
  record.attempts = attempt;
  record.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  write_complete_file(folder + "/record.json", record_text(record), kOutOption);
  context.store.finish(folder, run.id);
}

int fail(const Failure& failure, const std::string& folder) {
  fmt::print(stderr, "Error: {}\n", failure.sentence);
  write_complete_file(folder + "/" + kFailureFile, failure.sentence, kOutOption);
  return failure.code;
}

}  // namespace

RunRecord blank_record(RunContext& context, const PlannedRun& run) {
  RunRecord record;
  record.id = run.id;
  record.definition = run.definition;
  record.versions = context.store.versions();
  for (const std::string& input : run_inputs(context.plan, run)) {
    record.inputs[input] = context.sums.of(input);
  }
  return record;
}

int make_run(RunContext& context, const PlannedRun& run, int attempt, const std::string& folder) {
  print_to_log(folder);
  find_sumo_data();
  try {
    make(context, run, attempt, folder);
    return 0;
  } catch (const Failure& failure) {
    return fail(failure, folder);
  } catch (const std::exception& error) {
    return fail({error.what(), 1}, folder);
  }
}

}  // namespace pedzone::study
