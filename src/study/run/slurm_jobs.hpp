// What Slurm says of a study's jobs.
#pragma once

#include <string>
#include <vector>

namespace pedzone::study {

/// A job, or a task of an array, that is queued or running.
struct SlurmJob {
  std::string id;      ///< 12, or 12_3 for a task
  std::string state;   ///< Slurm's word: RUNNING, PENDING, ...
  std::string reason;  ///< why it waits
  std::string job() const { return id.substr(0, id.find('_')); }
};

/// The name of all jobs of the study in the directory `results`; empty where none was submitted.
std::string slurm_name(const std::string& results);

/// The study's jobs, but for the one that this process belongs to. Empty where none was submitted
/// or Slurm is not there. Throws InputError, with Slurm's own words, where it does not answer.
std::vector<SlurmJob> slurm_jobs(const std::string& results);

/// One line a job, e.g. "job 12: 3 running, 5 pending (Priority)".
std::vector<std::string> slurm_summary(const std::vector<SlurmJob>& jobs);

/// Throws InputError, which says how to cancel them, where the study has jobs.
void refuse_beside_slurm(const std::string& results);

/// Slurm's words on an error, on one line.
std::string slurm_words(const std::string& printed);

}  // namespace pedzone::study
