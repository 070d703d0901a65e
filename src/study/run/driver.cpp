#include "study/run/driver.hpp"

#include <fmt/format.h>

#include <chrono>
#include <deque>
#include <filesystem>
#include <list>

#include "core/child_process.hpp"
#include "core/error.hpp"
#include "study/plan/sumo_options.hpp"
#include "study/run/failure.hpp"
#include "study/run/signal_queue.hpp"

namespace pedzone::study {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kTick = 0.25;  // [s] between two looks at time limits
constexpr int kAttempts = 2;

struct Task {
  std::size_t run;  ///< index of Plan::runs
  int attempt = 1;
};

/// A run that is being made.
struct Active {
  Task task;
  std::string folder;
  Clock::time_point begin = Clock::now();
  Child child;

  Active(const Task& new_task, std::string new_folder, const std::function<int()>& work)
      : task(new_task), folder(std::move(new_folder)), child(work) {}

  double age() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
};

class Driver {
 public:
  Driver(RunContext& context, int jobs, const DriverEvents& events)
      : context_(context), jobs_(static_cast<std::size_t>(jobs)), events_(events) {}
  ~Driver() {
    for (Active& active : active_) {
      active.child.kill();
      remove(active.folder);
    }
  }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  DriverResult work(const std::vector<std::size_t>& runs) {
    for (const std::size_t run : runs) waiting_.push_back({run});
    try {
      loop();
    } catch (const std::exception&) {
      check_disk(context_.store.folder());  // says it better
      throw;
    }
    return result_;
  }

 private:
  void loop() {
    while (!waiting_.empty() || !active_.empty()) {
      while (!waiting_.empty() && active_.size() < jobs_) start_next();
      const int signal = signals_.wait(kTick);
      if (signal != 0 && signal != SIGCHLD) {
        result_.interrupted = true;
        break;
      }
      look();
      events_.tick();
    }
  }

  const PlannedRun& run_of(const Task& task) const { return context_.plan.runs[task.run]; }

  void start_next() {
    const Task task = waiting_.front();
    waiting_.pop_front();
    const PlannedRun& run = run_of(task);
    const std::string folder = context_.store.make_folder(run.id);
    active_.emplace_back(task, folder, [this, &run, task, folder] {
      return make_run(context_, run, task.attempt, folder);
    });
  }

  /// Deals with the runs that have ended or take too long.
  void look() {
    for (auto active = active_.begin(); active != active_.end();) {
      std::optional<Ending> ending = active->child.poll();
      const bool late = !ending && active->age() > context_.plan.study.time_limit;
      if (late) active->child.kill();
      if (late || ending) {
        over(*active, late, ending.value_or(Ending{}));
        active = active_.erase(active);
      } else {
        ++active;
      }
    }
  }

  void over(const Active& active, bool late, const Ending& ending) {
    const PlannedRun& run = run_of(active.task);
    if (!late && ending.good()) {
      context_.sums.learn(read_record(context_.store.run_folder(run.id) + "/record.json").inputs);
      ++result_.done;
      events_.over(run, RunStatus::kDone, "", active.age());
      return;
    }
    check_disk(context_.store.folder());  // while what the run has written is still there
    const std::string why =
        late ? fmt::format("took longer than {} s", context_.plan.study.time_limit)
             : failure_sentence(active.folder, ending);
    if (active.task.attempt < kAttempts) {
      remove(active.folder);
      events_.again(run, why);
      waiting_.push_front({active.task.run, active.task.attempt + 1});
      return;
    }
    const bool killed = !late && ending.from_outside();
    const RunStatus status = killed ? RunStatus::kKilled : RunStatus::kFailed;
    record_failure(context_, run, {status, why, active.task.attempt, active.age()}, active.folder);
    ++(killed ? result_.killed : result_.failed);
    events_.over(run, status, why, active.age());
  }

  static void remove(const std::string& folder) {
    std::error_code ignored;  // what cannot be removed now is rubbish for the next driver
    std::filesystem::remove_all(folder, ignored);
  }

  RunContext& context_;
  std::size_t jobs_;
  const DriverEvents& events_;
  DriverResult result_;
  SignalQueue signals_;
  std::deque<Task> waiting_;
  std::list<Active> active_;
};

}  // namespace

std::vector<std::size_t> missing_runs(const Records& records, bool retry_failed) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!records[i] || records[i]->status == RunStatus::kKilled ||
        (retry_failed && records[i]->status == RunStatus::kFailed)) {
      missing.push_back(i);
    }
  }
  return missing;
}

DriverResult make_runs(RunContext& context, const std::vector<std::size_t>& runs, int jobs,
                       const DriverEvents& events) {
  ask_sumo_options();
  return Driver(context, jobs, events).work(runs);
}

}  // namespace pedzone::study
