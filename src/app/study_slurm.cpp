#include "app/study_slurm.hpp"

#include <fmt/format.h>

#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "core/error.hpp"
#include "study/run/driver.hpp"
#include "study/run/slurm_jobs.hpp"
#include "study/run/versions.hpp"

namespace pedzone {

using namespace study;

namespace {

/// For the aggregate job, that it can submit what is missing in the same way.
std::vector<std::string> aggregate_command(const std::string& results, std::size_t runs,
                                           const SlurmOptions& options, int idle) {
  std::vector<std::string> words = {this_program(), "study", "aggregate", results, "--slurm"};
  const auto add = [&](const char* option, auto value) {
    words.push_back(fmt::format("{}={}", option, value));
  };
  add("--submitted", runs);
  add("--idle", idle);
  add("--per-task", options.per_task);
  if (!options.partition.empty()) add("--partition", options.partition);
  if (!options.time.empty()) add("--time", options.time);
  for (const std::string& option : options.sbatch) add("--sbatch", option);
  return words;
}

}  // namespace

void add_slurm_options(CLI::App& run, StudySlurmOptions& options) {
  const std::string group = "On a Slurm cluster";
  CLI::Option* slurm = run.add_flag("--slurm", options.wanted,
                                    "Make the runs as Slurm jobs. Start it on the login node, in a "
                                    "folder that all nodes share");
  SlurmOptions& sbatch = options.sbatch;
  for (CLI::Option* option :
       {run.add_option("--partition", sbatch.partition, "Partition")
            ->type_name(kNames)
            ->default_str("Slurm's"),
        run.add_option("--time", sbatch.time, "Time limit of a task, as for sbatch")
            ->type_name("TIME")
            ->default_str("the partition's"),
        run.add_option("--per-task", sbatch.per_task, "Runs in each task, one after the other")
            ->check(whole_number_in(1, 1000000))
            ->type_name(kNumber)
            ->capture_default_str(),
        run.add_option("--sbatch", sbatch.sbatch,
                       "An option of sbatch, e.g. --sbatch=--account=traffic; may be repeated")
            ->type_name(kOption)
            ->allow_extra_args(false)}) {
    option->needs(slurm)->group(group);
  }
  slurm->group(group);
}

void submit_runs(const Store& store, const std::vector<std::string>& runs,
                 const SlurmOptions& options, int idle) {
  const SlurmArray array =
      submit_array(store.folder(), runs, options, {this_program(), "study", "task", store.folder()},
                   aggregate_command(store.folder(), runs.size(), options, idle));
  print_result(fmt::format(
      "Submitted {} runs to Slurm: job {} with {} tasks, up to {} runs each, then job {}\n"
      "(tables and report). What they print: {}/*.log\n",
      runs.size(), array.job, array.tasks, array.per_task, array.aggregate, array.folder));
}

bool submit_study(const Store& store, const Plan& plan, bool retry_failed,
                  const SlurmOptions& options) {
  const Records records = store.records(plan);
  std::vector<std::string> runs;
  for (const std::size_t run : missing_runs(records, retry_failed)) {
    runs.push_back(plan.runs[run].id);
    if (records[run]) store.discard(runs.back());  // tasks leave alone what has failed
  }
  if (runs.empty()) return false;
  submit_runs(store, runs, options, 0);
  print_result(fmt::format("To follow: pedzone study status {}\nTo cancel: scancel --name={}\n",
                           store.folder(), slurm_name(store.folder())));
  return true;
}

std::vector<std::string> slurm_lines(const Store& store) {
  try {
    return slurm_summary(slurm_jobs(store.folder()));
  } catch (const InputError& error) {
    return {error.what()};
  }
}

}  // namespace pedzone
