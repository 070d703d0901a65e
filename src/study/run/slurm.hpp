// A study's runs as jobs of a Slurm cluster (22.05): an array whose tasks each make a chunk of runs
// with `pedzone study task`, and after it, however its tasks end, one job of `pedzone study
// aggregate`. (After they end well would be for ever where one is requeued.) In the study's
// directory:
//   slurm/name     the name of all of its jobs
//   slurm/N/I      chunk I of the N-th array: ids of runs, one a line
//   slurm/N/*.sh   what Slurm was given
//   slurm/N/*.log  what the tasks and the aggregate job printed
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pedzone::study {

struct SlurmOptions {
  std::string partition;            ///< empty: Slurm's default
  std::string time;                 ///< limit of a task as sbatch takes it; empty: the partition's
  std::size_t per_task = 20;        ///< runs, one after the other; more where the array would have
                                    ///< more tasks than Slurm allows
  std::vector<std::string> sbatch;  ///< more options of sbatch
};

/// Throws InputError where Slurm is not there or refuses such jobs, with its own words, or cannot
/// have its files in the study's directory `results`.
void check_slurm(const SlurmOptions& options, const std::string& results);

struct SlurmArray {
  std::string job, aggregate;  ///< their ids
  std::size_t tasks = 0, per_task = 0;
  std::string folder;  ///< slurm/N, absolute
};

/// Submits an array for these runs, and the aggregate job. `results`: the study's directory,
/// absolute, its lock held; `task`: command that gets a chunk's file as last word; `aggregate`:
/// command. Throws InputError where Slurm refuses; nothing is queued then.
SlurmArray submit_array(const std::string& results, const std::vector<std::string>& runs,
                        const SlurmOptions& options, const std::vector<std::string>& task,
                        const std::vector<std::string>& aggregate);

/// Submits the last aggregate job again, after these jobs; returns its id. Throws InputError.
std::string submit_aggregate(const std::string& results, const std::vector<std::string>& after,
                             const SlurmOptions& options);

}  // namespace pedzone::study
