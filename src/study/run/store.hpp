// A study's directory:
//   study.json      which study, format and versions; where its files are
//   study.xml       the study file as it was last given
//   lock            held by the driver
//   runs/ID/        one per run that is over, put there by one rename
//   runs/.ID.*/     runs that are being made (log.txt is locked); rubbish once nobody makes them
//   slurm/          what was submitted
//   report.html, summary.csv, summary.json, runs.csv
#pragma once

#include <map>
#include <memory>
#include <string>

#include "study/plan/plan.hpp"
#include "study/run/directory_lock.hpp"
#include "study/run/record.hpp"

namespace pedzone::study {

/// What the user names the directory with, for messages.
inline constexpr const char* kOutOption = "--out";

/// Runs that are done, but of other inputs than there are now.
struct OutdatedRuns {
  std::size_t count = 0;
  std::string file;  ///< an input that has changed, or is gone; empty: none
};

/// What a study's directory holds of its plan.
struct StoredRuns {
  Records records;  ///< of each run that is over and whose inputs have not changed
  OutdatedRuns outdated;
};

class Store {
 public:
  /// Opens a study's directory to write runs, or makes it where it is missing or empty; holds its
  /// lock as long as the store or a copy of it lives. `versions`: program_versions().
  /// Throws InputError where it is another study's, of another version, something else, in use, or
  /// cannot be written.
  static Store create(const std::string& folder, const Study& study,
                      const std::map<std::string, std::string>& versions);
  /// Opens one that is there, without its lock. Throws InputError where it is none.
  static Store open(const std::string& folder);

  const std::string& folder() const { return folder_; }  ///< absolute
  /// Of the programs that make its runs.
  const std::map<std::string, std::string>& versions() const { return versions_; }
  /// The plan of the study file in it.
  Plan plan() const;
  StoredRuns stored_runs(const Plan& plan) const;
  /// Only those.
  Records records(const Plan& plan) const { return stored_runs(plan).records; }
  std::string run_folder(const std::string& run) const;  ///< absolute

  /// A new folder to make a run in; absolute. Throws std::system_error.
  std::string make_folder(const std::string& run) const;
  /// Puts a folder into its place, complete, instead of what failed there or had other inputs. It
  /// is thrown away where somebody else has done the run by now. Throws std::system_error.
  void finish(const std::string& folder, const std::string& run) const;
  /// Takes away what is in a run's place.
  void discard(const std::string& run) const;
  /// Removes folders in which nobody makes a run any more.
  void clear_rubbish() const;

 private:
  Store(std::string folder, std::string study, std::string study_folder,
        std::map<std::string, std::string> versions)
      : folder_(std::move(folder)),
        study_(std::move(study)),
        study_folder_(std::move(study_folder)),
        versions_(std::move(versions)) {}

  std::string folder_;
  std::string study_;         ///< id
  std::string study_folder_;  ///< where the study file's relative paths begin
  std::map<std::string, std::string> versions_;
  std::shared_ptr<const DirectoryLock> lock_;
};

}  // namespace pedzone::study
