// `pedzone study` on a Slurm cluster: what the user says, and the commands that jobs are.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "study/run/slurm.hpp"
#include "study/run/store.hpp"

namespace pedzone {

struct StudySlurmOptions {
  bool wanted = false;  ///< --slurm
  study::SlurmOptions sbatch;
};

/// Adds --slurm and what goes with it to `study run`.
void add_slurm_options(CLI::App& run, StudySlurmOptions& options);

/// Adds the commands of jobs to `study`; help does not list them.
void add_slurm_jobs(CLI::App& study, int& code);

/// Submits runs of a study, whose lock is held, and says so. `idle`: how many arrays in a row have
/// finished none of them. Throws InputError.
void submit_runs(const study::Store& store, const std::vector<std::string>& runs,
                 const study::SlurmOptions& options, int idle);

/// Submits what is missing of a study, whose lock is held, and says how to follow and to cancel it;
/// false where nothing is missing. Throws InputError.
bool submit_study(const study::Store& store, const study::Plan& plan, bool retry_failed,
                  const study::SlurmOptions& options);

/// A line for each job that a study has with Slurm, or why that is not known.
std::vector<std::string> slurm_lines(const study::Store& store);

}  // namespace pedzone
