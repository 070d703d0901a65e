#include "study/run/slurm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <random>
#include <regex>
#include <span>

#include "core/command_output.hpp"
#include "core/error.hpp"
#include "core/shell_word.hpp"
#include "results/complete_file.hpp"
#include "study/run/slurm_jobs.hpp"
#include "study/run/store.hpp"

namespace pedzone::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxArraySize = 1001;  // Slurm's default

InputError refused(const std::string& words) {
  return {
      "Slurm refuses the study's jobs: " + words,
      {.element = "option --slurm", .allowed = "options that sbatch takes (partitions: `sinfo`)"}};
}

std::string sbatch(std::vector<std::string> words) {
  words.insert(words.begin(), "sbatch");
  const auto said = command_output(words);
  if (!said) {
    throw InputError("Slurm is not there: no program 'sbatch' is found",
                     {.element = "option --slurm",
                      .allowed = "on a machine from which jobs of a cluster are submitted; without "
                                 "--slurm the study runs on this one (--jobs)"});
  }
  if (said->code != 0) throw refused(slurm_words(said->error));
  return said->out;
}

/// An id as `sbatch --parsable` prints it: "12", or "12;cluster".
std::string job_id(const std::string& printed) {
  return printed.substr(0, printed.find_first_of(";\n"));
}

std::vector<std::string> sbatch_words(const SlurmOptions& options) {
  std::vector<std::string> words;
  if (!options.partition.empty()) words.push_back("--partition=" + options.partition);
  if (!options.time.empty()) words.push_back("--time=" + options.time);
  words.insert(words.end(), options.sbatch.begin(), options.sbatch.end());
  return words;
}

void write(const std::string& path, const std::string& text) {
  write_complete_file(path, text, kOutOption);
}

/// A script that becomes the command, so that Slurm's signals reach it. `more` goes to its end as
/// it is.
std::string script(const std::vector<std::string>& command, const std::string& more = "") {
  return "#!/bin/sh\nexec " + shell_command(command) + more + "\n";
}

/// sbatch puts values for %a and the like into the whole path.
std::string output_pattern(const std::string& folder, const std::string& name) {
  std::string pattern = "--output=";
  for (const char c : folder) pattern += c == '%' ? "%%" : std::string(1, c);
  return pattern + "/" + name;
}

std::string submit(const std::string& results, const std::string& folder, const std::string& name,
                   const std::string& log, const SlurmOptions& options,
                   const std::vector<std::string>& more) {
  std::vector<std::string> words = {"--parsable",
                                    "--job-name=" + slurm_name(results),
                                    "--ntasks=1",
                                    "--requeue",
                                    "--open-mode=append",
                                    "--chdir=" + results,
                                    output_pattern(folder, log)};
  std::ranges::copy(more, std::back_inserter(words));
  std::ranges::copy(sbatch_words(options), std::back_inserter(words));
  words.push_back(folder + "/" + name);
  return job_id(sbatch(words));
}

/// How many tasks an array may have.
std::size_t max_array_size() {
  const auto said = command_output({"scontrol", "show", "config"});
  std::smatch found;
  if (said &&
      std::regex_search(said->out, found, std::regex("MaxArraySize *= *([1-9][0-9]{0,8})"))) {
    return std::stoul(found[1]);
  }
  return kMaxArraySize;
}

void name_jobs(const std::string& results) {
  if (!slurm_name(results).empty()) return;
  std::random_device random;
  write(results + "/slurm/name", fmt::format("pedzone-{:08x}{:08x}\n", random(), random()));
}

/// slurm/N of the last array; 0: none.
int last_number(const std::string& results) {
  int last = 0;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(results + "/slurm", none)) {
    const std::string name = entry.path().filename().string();
    int number = 0;
    std::from_chars(name.data(), name.data() + name.size(), number);
    last = std::max(last, number);
  }
  return last;
}

std::string array_folder(const std::string& results, int number) {
  return fmt::format("{}/slurm/{}", results, number);
}

std::size_t write_chunks(const std::string& folder, std::span<const std::string> runs,
                         std::size_t per_task) {
  std::size_t chunk = 0;
  for (; !runs.empty(); ++chunk) {
    const auto some = runs.first(std::min(per_task, runs.size()));
    write(fmt::format("{}/{}", folder, chunk), fmt::format("{}\n", fmt::join(some, "\n")));
    runs = runs.subspan(some.size());
  }
  return chunk;
}

std::string after(const std::vector<std::string>& jobs) {
  return fmt::format("--dependency=afterany:{}", fmt::join(jobs, ":"));
}

void submit_both(const std::string& results, const SlurmOptions& options, SlurmArray& array) {
  array.job = submit(results, array.folder, "task.sh", "%a.log", options,
                     {fmt::format("--array=0-{}", array.tasks - 1)});
  try {
    array.aggregate = submit_aggregate(results, {array.job}, options);
  } catch (const InputError&) {
    command_output({"scancel", array.job});
    throw;
  }
}

}  // namespace

void check_slurm(const SlurmOptions& options, const std::string& results) {
  const std::string path = fs::absolute(results).string();
  if (path.find('\\') != std::string::npos) {  // sbatch drops it from paths
    throw InputError("cannot be used with Slurm",
                     {.element = "option --out", .value = path, .allowed = "no backslash"});
  }
  std::vector<std::string> words = {"--test-only", "--ntasks=1"};
  std::ranges::copy(sbatch_words(options), std::back_inserter(words));
  words.push_back("--wrap=true");
  sbatch(words);
}

SlurmArray submit_array(const std::string& results, const std::vector<std::string>& runs,
                        const SlurmOptions& options, const std::vector<std::string>& task,
                        const std::vector<std::string>& aggregate) {
  name_jobs(results);
  SlurmArray array;
  array.folder = array_folder(results, last_number(results) + 1);
  const std::size_t most = max_array_size();
  array.per_task = std::max(options.per_task, (runs.size() + most - 1) / most);
  array.tasks = write_chunks(array.folder, runs, array.per_task);
  write(array.folder + "/task.sh",
        script(task, " " + shell_word(array.folder + "/") + "\"$SLURM_ARRAY_TASK_ID\""));
  write(array.folder + "/aggregate.sh", script(aggregate));
  try {
    submit_both(results, options, array);
  } catch (const InputError&) {
    fs::remove_all(array.folder);
    throw;
  }
  return array;
}

std::string submit_aggregate(const std::string& results, const std::vector<std::string>& jobs,
                             const SlurmOptions& options) {
  return submit(results, array_folder(results, last_number(results)), "aggregate.sh",
                "aggregate.log", options, {after(jobs)});
}

}  // namespace pedzone::study
