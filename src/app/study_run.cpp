#include <fmt/format.h>

#include <thread>

#include "app/command_line/terminal.hpp"
#include "app/guarded.hpp"
#include "app/study.hpp"
#include "app/study_progress.hpp"
#include "app/study_results.hpp"
#include "study/run/driver.hpp"
#include "study/run/failure.hpp"
#include "study/run/slurm_jobs.hpp"
#include "study/run/versions.hpp"

namespace pedzone {

using namespace study;

namespace {

int jobs_of(const StudyRunOptions& options) {
  if (options.jobs > 0) return options.jobs;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

DriverResult make_missing(const StudyRunOptions& options, RunContext& context) {
  const Records records = context.store.records(context.plan);
  const std::vector<std::size_t> missing = missing_runs(records, options.retry_failed);
  const int jobs = jobs_of(options);
  StudyProgress progress(records.size(), records.size() - missing.size(), jobs);
  DriverEvents events;
  events.again = [&](const PlannedRun& run, const std::string& why) {
    progress.note(run.id, why + "; tried again");
  };
  events.over = [&](const PlannedRun& run, RunStatus status, const std::string& why,
                    double wall_s) {
    const bool done = status == RunStatus::kDone;
    progress.over(run.id,
                  done ? fmt::format("done in {:.1f} s", wall_s)
                       : fmt::format("{}: {}", status_name(status), why),
                  !done, wall_s);
  };
  events.tick = [&] { progress.update(); };
  const DriverResult result = make_runs(context, missing, jobs, events);
  progress.finish();
  return result;
}

int work(const StudyRunOptions& options) {
  const Study study = read_study(options.file);
  const Plan plan = make_plan(study);
  const std::string pedzone = this_program();
  if (options.slurm.wanted) check_slurm(options.slurm.sbatch, options.results);
  refuse_beside_slurm(options.results);
  const Store store =
      Store::create(options.results, study, program_versions(PEDZONE_VERSION, pedzone));
  refuse_beside_slurm(store.folder());  // submitted since, by somebody who had the lock
  store.clear_rubbish();
  if (options.slurm.wanted &&
      submit_study(store, plan, options.retry_failed, options.slurm.sbatch)) {
    return 0;
  }
  RunContext context{store, plan, pedzone, {}};
  const DriverResult result = make_missing(options, context);
  const Records records = store.records(plan);
  const RunCounts counts = count_runs(records);
  print_result(fmt::format("{} runs: {} done, {} failed, {} killed, {} missing\n", records.size(),
                           counts.done, counts.failed, counts.killed, counts.missing));
  if (result.interrupted) {
    fmt::print(stderr, "Interrupted. What is done is kept; the same command goes on from there.\n");
    return kExitInterrupted;
  }
  write_results(store, plan, records);
  return counts.done == records.size() ? 0 : kExitSomeFailed;
}

}  // namespace

int study_run(const StudyRunOptions& options) {
  return guarded_code([&] {
    try {
      return work(options);
    } catch (const std::exception&) {
      check_disk(options.results);  // says it better
      throw;
    }
  });
}

}  // namespace pedzone
