// `pedzone study`: models compared over many runs.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/study_slurm.hpp"

namespace pedzone {

constexpr int kExitSomeFailed = 4;     ///< some runs of a study failed
constexpr int kExitInterrupted = 130;  ///< as shells have it for SIGINT

struct StudyRunOptions {
  std::string file;     ///< study file
  std::string results;  ///< the study's directory
  int jobs = 0;         ///< at a time; 0: as many as there are cores
  bool retry_failed = false;
  StudySlurmOptions slurm;
};

struct StudyStatusOptions {
  std::string results;  ///< the study's directory
  bool json = false;    ///< instead of text
};

/// All of them return the exit code, with the error on standard error.
int study_run(const StudyRunOptions& options);
int study_status(const StudyStatusOptions& options);
int study_report(const std::string& results);

void add_study(CLI::App& app, int& code);

}  // namespace pedzone
