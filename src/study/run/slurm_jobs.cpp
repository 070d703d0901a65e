#include "study/run/slurm_jobs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "core/command_output.hpp"
#include "core/error.hpp"

namespace pedzone::study {
namespace {

/// The job that this process belongs to; empty outside of jobs.
std::string own_job() {
  const char* id = std::getenv("SLURM_JOB_ID");
  return id == nullptr ? "" : id;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace

std::string slurm_name(const std::string& results) {
  std::ifstream in(results + "/slurm/name");
  std::string name;
  std::getline(in, name);
  return name;
}

std::vector<SlurmJob> slurm_jobs(const std::string& results) {
  const std::string name = slurm_name(results);
  if (name.empty()) return {};
  const auto listed =
      command_output({"squeue", "--noheader", "--array", "--name=" + name, "--format=%i|%T|%r"});
  if (!listed) return {};
  if (listed->code != 0) {
    throw InputError("Slurm does not say whether the study has jobs: " + slurm_words(listed->error),
                     {.file = results,
                      .allowed = "try again when squeue answers; where its jobs are known to "
                                 "be over, remove the folder slurm in it"});
  }
  std::vector<SlurmJob> jobs;
  for (const std::string& line : split(listed->out, '\n')) {
    const std::vector<std::string> words = split(line, '|');
    if (words.size() < 2 || words[0] == own_job()) continue;
    if (words[1] == "COMPLETING") continue;  // its processes have ended
    jobs.push_back({words[0], words[1], words.size() > 2 ? words[2] : ""});
  }
  return jobs;
}

std::vector<std::string> slurm_summary(const std::vector<SlurmJob>& jobs) {
  struct State {
    std::size_t tasks = 0;
    std::set<std::string> reasons;
  };
  std::map<std::string, std::map<std::string, State>> by_job;
  for (const SlurmJob& job : jobs) {
    State& state = by_job[job.job()][job.state];
    ++state.tasks;
    if (job.state == "PENDING") state.reasons.insert(job.reason);
  }
  std::vector<std::string> lines;
  for (const auto& [job, states] : by_job) {
    std::vector<std::string> parts;
    for (const auto& [state, of] : states) {
      parts.push_back(fmt::format("{} {}", of.tasks, lower(state)));
      if (!of.reasons.empty()) parts.back() += fmt::format(" ({})", fmt::join(of.reasons, ", "));
    }
    lines.push_back(fmt::format("job {}: {}", job, fmt::join(parts, ", ")));
  }
  return lines;
}

void refuse_beside_slurm(const std::string& results) {
  const std::vector<SlurmJob> jobs = slurm_jobs(results);
  if (jobs.empty()) return;
  throw InputError(
      fmt::format("the study has jobs with Slurm ({})", fmt::join(slurm_summary(jobs), "; ")),
      {.file = results,
       .allowed = fmt::format("wait for them (`pedzone study status`), or cancel them with "
                              "`scancel --name={}`",
                              slurm_name(results))});
}

std::string slurm_words(const std::string& printed) {
  std::vector<std::string> lines = split(printed, '\n');
  std::erase(lines, "");
  return lines.empty() ? "(it says nothing)" : fmt::format("{}", fmt::join(lines, "; "));
}

}  // namespace pedzone::study
