#include <fmt/format.h>

#include "app/clock_text.hpp"
#include "app/guarded.hpp"
#include "app/study.hpp"
#include "app/study_results.hpp"

namespace pedzone {

using namespace study;

namespace {

/// [s] that the missing runs will take one after the other, by what the others took; 0: not known.
double time_left(const Records& records, const RunCounts& counts) {
  double wall_s = 0.0;
  for (const auto& record : records) {
    if (record && record->status == RunStatus::kDone) wall_s += record->wall_s;
  }
  if (counts.done == 0) return 0.0;
  return wall_s / static_cast<double>(counts.done) *
         static_cast<double>(counts.missing + counts.killed);
}

/// Runs that failed or were killed, and why; the end of each log is in its record.
void print_troubles(const Store& store, const Plan& plan, const Records& records) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!records[i] || records[i]->status == RunStatus::kDone) continue;
    const std::string& failure = records[i]->failure;
    fmt::print("\n{} {}: {}\n  {}/log.txt\n", plan.runs[i].id, status_name(records[i]->status),
               failure.substr(0, failure.find('\n')), store.run_folder(plan.runs[i].id));
  }
}

int status(const std::string& results) {
  const Store store = Store::open(results);
  const Plan plan = store.plan();
  const Records records = store.records(plan);
  const RunCounts counts = count_runs(records);
  fmt::print("{}: {} runs\n  done    {:6}\n  failed  {:6}\n  killed  {:6}\n  missing {:6}\n",
             plan.study.id, records.size(), counts.done, counts.failed, counts.killed,
             counts.missing);
  const double left = time_left(records, counts);
  if (left > 0.0) fmt::print("About {} of one core's time left.\n", clock_text(left));
  const std::string holder = lock_holder(store.folder());
  if (!holder.empty()) fmt::print("At work: {}.\n", holder);
  print_slurm_jobs(store);
  print_troubles(store, plan, records);
  return counts.failed > 0 ? kExitSomeFailed : 0;
}

int report(const std::string& results) {
  const Store store = Store::open(results);
  const Plan plan = store.plan();
  const Records records = store.records(plan);
  write_results(store, plan, records);
  return count_runs(records).failed > 0 ? kExitSomeFailed : 0;
}

int guarded_code(int (*work)(const std::string&), const std::string& results) {
  int code = 0;
  const int error = guarded([&] { code = work(results); });
  return error != 0 ? error : code;
}

}  // namespace

int study_status(const std::string& results) { return guarded_code(status, results); }

int study_report(const std::string& results) { return guarded_code(report, results); }

}  // namespace pedzone
