#include "app/study_results.hpp"

#include <fmt/format.h>

#include "output/complete_file.hpp"
#include "study/report.hpp"

namespace pedzone {
namespace {

void write(const Store& store, const std::string& name, const std::string& text) {
  CompleteFile file(store.folder() + "/" + name, "--out");
  file.write(text);
  file.finish();
}

}  // namespace

void write_results(const Store& store, const Plan& plan, const Records& records) {
  const std::vector<Comparison> comparisons = compare(plan, records);
  const std::vector<FreeSpeed> speeds = free_speeds(plan, records);
  write(store, "runs.csv", runs_csv(plan, records));
  write(store, "summary.csv", summary_csv(plan, comparisons));
  write(store, "summary.json", summary_json(plan, records, comparisons, speeds));
  write(store, "report.html", report_page(store, plan, records, comparisons, speeds));
  fmt::print(
      "Results in {}:\n"
      "  report.html    what differs, by how much, how sure; to be opened in a browser\n"
      "  summary.csv    each measure of each model against {}, also summary.json\n"
      "  runs.csv       the measures of each run\n",
      store.folder(), plan.study.reference);
}

RunCounts count_runs(const Records& records) {
  RunCounts counts;
  for (const auto& record : records) {
    if (!record) {
      ++counts.missing;
    } else if (record->status == RunStatus::kDone) {
      ++counts.done;
    } else {
      ++(record->status == RunStatus::kFailed ? counts.failed : counts.killed);
    }
  }
  return counts;
}

}  // namespace pedzone
