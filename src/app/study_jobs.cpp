// What runs inside Slurm's jobs of a study: tasks, which make a chunk of its runs, and the
// aggregate job, which submits what is missing after them or writes the results.
#include <fmt/format.h>

#include <csignal>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include "app/command_line/terminal.hpp"
#include "app/guarded.hpp"
#include "app/study.hpp"
#include "app/study_results.hpp"
#include "app/study_slurm.hpp"
#include "core/error.hpp"
#include "study/run/directory_lock.hpp"
#include "study/run/driver.hpp"
#include "study/run/slurm_jobs.hpp"
#include "study/run/versions.hpp"

namespace pedzone {

using namespace study;

namespace {

constexpr int kIdleArrays = 3;  // assumed: after so many that finish nothing in a row, none will

struct TaskOptions {
  std::string results, chunk;
};

struct AggregateOptions {
  std::string results;
  std::size_t submitted = 0;  ///< runs of the array before
  int idle = 0;               ///< arrays in a row, before that one, that finished nothing
  StudySlurmOptions slurm;
};

std::vector<std::string> read_chunk(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw InputError("cannot be read", {.file = file, .allowed = "ids of runs, one a line"});
  std::vector<std::string> ids;
  for (std::string id; std::getline(in, id);) ids.push_back(id);
  return ids;
}

/// Results of different programs are not mixed: a node may have others than the one that submitted.
void check_versions(const Store& store) {
  const auto change =
      version_change(store.versions(), program_versions(PEDZONE_VERSION, this_program()));
  if (!change) return;
  throw InputError("is another version than the study's",
                   {.element = change->program, .value = change->now, .allowed = change->then});
}

/// One line for each run, for the task's log.
DriverEvents log_lines() {
  DriverEvents events;
  events.again = [](const PlannedRun& run, const std::string& why) {
    fmt::print("{}: {}; tried again\n", run.id, why);
  };
  events.over = [](const PlannedRun& run, RunStatus, const std::string& why, double wall_s) {
    fmt::print("{}: {} ({:.1f} s)\n", run.id, why.empty() ? "done" : why, wall_s);
  };
  events.tick = [] { std::fflush(stdout); };
  return events;
}

/// Makes a run unless it has been made by now, perhaps by a copy of this task on a node that was
/// given up; false where a signal asks to end.
bool make_missing(const Store& store, const Plan& plan, const PlannedRun& run) {
  const Plan alone{plan.study, plan.conditions, {run}, {}};
  RunContext context{store, alone, this_program(), {}};
  const std::vector<std::size_t> missing = missing_runs(store.records(alone), false);
  return missing.empty() || !make_runs(context, missing, 1, log_lines()).interrupted;
}

int task(const TaskOptions& options) {
  const Store store = Store::open(options.results);
  check_versions(store);
  const Plan plan = store.plan();
  std::map<std::string, const PlannedRun*> runs;
  for (const PlannedRun& run : plan.runs) runs[run.id] = &run;
  for (const std::string& id : read_chunk(options.chunk)) {
    const auto run = runs.find(id);
    if (run == runs.end()) continue;  // the study has changed since
    if (make_missing(store, plan, *run->second)) continue;
    fmt::print("Asked to end; the aggregate job has the rest made.\n");
    return kExitInterrupted;
  }
  return 0;
}

/// Where jobs of the study are still there, e.g. a task that was requeued by hand.
void wait_for_others(const std::string& results, const std::vector<SlurmJob>& others,
                     const SlurmOptions& options) {
  std::set<std::string> jobs;
  for (const SlurmJob& other : others) jobs.insert(other.job());
  fmt::print("There are others; job {} comes after them.\n",
             submit_aggregate(results, {jobs.begin(), jobs.end()}, options));
}

int aggregate(const AggregateOptions& options) {
  const Store store = Store::open(options.results);
  check_versions(store);
  const DirectoryLock lock(store.folder(), "pedzone study aggregate");
  const std::vector<SlurmJob> others = slurm_jobs(store.folder());
  if (!others.empty()) {
    wait_for_others(store.folder(), others, options.slurm.sbatch);
    return 0;
  }
  const Plan plan = store.plan();
  const Records records = store.records(plan);
  std::vector<std::string> missing;
  for (const std::size_t run : missing_runs(records, false)) missing.push_back(plan.runs[run].id);
  const int idle = missing.size() < options.submitted ? 0 : options.idle + 1;
  if (!missing.empty() && idle < kIdleArrays) {
    submit_runs(store, missing, options.slurm.sbatch, idle);
    return 0;
  }
  store.clear_rubbish();
  write_results(store, plan, records);
  if (missing.empty()) return count_runs(records).failed > 0 ? kExitSomeFailed : 0;
  print_error(
      fmt::format("{} runs are missing, and {} arrays in a row have finished none; see the logs in "
                  "{}/slurm. `pedzone study run` goes on from there.",
                  missing.size(), idle, store.folder()));
  return kExitSomeFailed;
}

}  // namespace

void add_slurm_jobs(CLI::App& study, int& code) {
  const std::string hidden;
  auto task_options = std::make_shared<TaskOptions>();
  CLI::App* command = study.add_subcommand("task", "Make a chunk of a study's runs")->group(hidden);
  command->add_option("results", task_options->results)->required();
  command->add_option("chunk", task_options->chunk, "File of ids of runs")->required();
  command->callback(
      [task_options, &code] { code = guarded_code([&] { return task(*task_options); }); });

  auto aggregate_options = std::make_shared<AggregateOptions>();
  command = study.add_subcommand("aggregate", "Submit what is missing, or write the results")
                ->group(hidden);
  command->add_option("results", aggregate_options->results)->required();
  command->add_option("--submitted", aggregate_options->submitted);
  command->add_option("--idle", aggregate_options->idle);
  add_slurm_options(*command, aggregate_options->slurm);
  command->callback([aggregate_options, &code] {
    code = guarded_code([&] { return aggregate(*aggregate_options); });
  });
}

}  // namespace pedzone
