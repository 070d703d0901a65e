#include <fmt/format.h>

#include "app/clock_text.hpp"
#include "app/command_line/terminal.hpp"
#include "app/guarded.hpp"
#include "app/json_text.hpp"
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

/// Of a study, now.
struct StudyState {
  Store store;
  Plan plan;
  StoredRuns runs;
  RunCounts counts;
  double left_s = 0.0;  ///< [s] of one core's time; 0: not known
  std::string holder;   ///< who is at work; empty: nobody
  std::vector<std::string> slurm;
};

StudyState state_of(const std::string& results) {
  const Store store = Store::open(results);
  StudyState state{
      store, store.plan(), {}, {}, 0.0, lock_holder(store.folder()), slurm_lines(store)};
  state.runs = store.stored_runs(state.plan);
  state.counts = count_runs(state.runs.records);
  state.left_s = time_left(state.runs.records, state.counts);
  return state;
}

/// A run that failed or was killed; the end of its log is in its record.
struct RunTrouble {
  std::string run, status, failure, log;
};

std::vector<RunTrouble> troubles_of(const StudyState& state) {
  std::vector<RunTrouble> troubles;
  for (std::size_t i = 0; i < state.runs.records.size(); ++i) {
    const auto& record = state.runs.records[i];
    if (!record || record->status == RunStatus::kDone) continue;
    const std::string& run = state.plan.runs[i].id;
    troubles.push_back({run, status_name(record->status),
                        record->failure.substr(0, record->failure.find('\n')),
                        state.store.run_folder(run) + "/log.txt"});
  }
  return troubles;
}

/// Why runs that were done are missing.
std::string outdated_text(const OutdatedRuns& outdated) {
  return fmt::format("{} of those missing {} done, but {} has changed since, or is gone.",
                     outdated.count, outdated.count == 1 ? "was" : "were", outdated.file);
}

std::string state_text(const StudyState& state) {
  const RunCounts& counts = state.counts;
  std::string text =
      fmt::format("{}: {} runs\n  done    {:6}\n  failed  {:6}\n  killed  {:6}\n  missing {:6}\n",
                  state.plan.study.id, state.runs.records.size(), counts.done, counts.failed,
                  counts.killed, counts.missing);
  if (state.runs.outdated.count > 0) text += outdated_text(state.runs.outdated) + "\n";
  if (state.left_s > 0.0) {
    text += fmt::format("About {} of one core's time left.\n", clock_text(state.left_s));
  }
  if (!state.holder.empty()) text += fmt::format("At work: {}.\n", state.holder);
  for (const std::string& line : state.slurm) text += fmt::format("With Slurm: {}\n", line);
  for (const auto& [run, status, failure, log] : troubles_of(state)) {
    text += fmt::format("\n{} {}: {}\n  {}\n", run, status, failure, log);
  }
  return text;
}

std::string state_json(const StudyState& state) {
  const RunCounts& counts = state.counts;
  nlohmann::ordered_json json = {
      {"version", kJsonVersion},           {"study", state.plan.study.id},
      {"runs", state.runs.records.size()}, {"done", counts.done},
      {"failed", counts.failed},           {"killed", counts.killed},
      {"missing", counts.missing}};
  json["outdated"] = state.runs.outdated.count;
  json["left_s"] = state.left_s > 0.0 ? nlohmann::ordered_json(state.left_s) : nullptr;
  json["at_work"] =
      state.holder.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(state.holder);
  json["slurm"] = state.slurm;
  json["troubles"] = nlohmann::ordered_json::array();
  for (const auto& [run, status, failure, log] : troubles_of(state)) {
    json["troubles"].push_back(
        {{"run", run}, {"status", status}, {"failure", failure}, {"log", log}});
  }
  return json_text(json);
}

int status(const StudyStatusOptions& options) {
  const StudyState state = state_of(options.results);
  if (options.json) {
    print_text(state_json(state));
  } else {
    print_result(state_text(state));
  }
  return state.counts.failed > 0 ? kExitSomeFailed : 0;
}

int report(const std::string& results) {
  const Store store = Store::open(results);
  const Plan plan = store.plan();
  const auto [records, outdated] = store.stored_runs(plan);
  const RunCounts counts = count_runs(records);
  if (outdated.count > 0 && counts.done == 0) {
    throw InputError("has changed since all runs were made, or is gone",
                     {.file = outdated.file,
                      .allowed = "as it was; or pedzone study run, which makes them anew"});
  }
  if (outdated.count > 0) print_warning(outdated_text(outdated));
  write_results(store, plan, records);
  return counts.failed > 0 ? kExitSomeFailed : 0;
}

}  // namespace

int study_status(const StudyStatusOptions& options) {
  return guarded_code([&] { return status(options); });
}

int study_report(const std::string& results) {
  return guarded_code([&] { return report(results); });
}

}  // namespace pedzone
