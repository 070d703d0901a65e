// A study's directory:
//   study.json      which study, format and versions; where its files are
//   study.xml       the study file as it was last given
//   lock            held by the driver
//   runs/ID/        one per run that is over, put there by one rename
//   runs/.ID.*/     runs that are being made; rubbish once nobody makes them
//   slurm/          what was submitted
//   report.html, summary.csv, summary.json, runs.csv
#pragma once

#include <memory>
#include <string>

#include "study/results.hpp"

namespace pedzone {

class Store {
 public:
  /// Opens a study's directory, or makes it where it is missing or empty.
  /// Throws InputError where it is another study's, of another version, or something else.
  static Store create(const std::string& folder, const Study& study);
  /// Opens one that is there. Throws InputError where it is none.
  static Store open(const std::string& folder);

  const std::string& folder() const { return folder_; }
  /// The plan of the study file in it.
  Plan plan() const;
  /// The record of each run that is over and whose inputs have not changed.
  Records records(const Plan& plan) const;
  std::string run_folder(const std::string& run) const;  ///< absolute

 private:
  explicit Store(std::string folder) : folder_(std::move(folder)) {}
  std::string folder_;
};

}  // namespace pedzone
