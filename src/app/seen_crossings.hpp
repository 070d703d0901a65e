// What an observer beside the streets counts: who crosses where, and which gaps people take.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "conflict/tracker.hpp"
#include "results/complete_file.hpp"
#include "results/place.hpp"
#include "study/measure/street_crossings.hpp"

namespace pedzone {

struct SeenCrossingOptions {
  std::string zone_file;  ///< whose streets are watched; empty: none
  std::string csv, svg;   ///< files to write; empty: not
};

class SeenCrossings {
 public:
  /// Throws InputError where no zone has crossing="anywhere", or a file cannot be written.
  SeenCrossings(const std::string& scenario, const SeenCrossingOptions& options);

  void step(double time, std::span<const PersonSample> persons,
            std::span<const VehicleSample> vehicles);
  /// Conflicts that are told by lane.
  void add(const Conflict& conflict) { conflicts_.push_back(conflict); }

  /// Writes the files; what there is to tell.
  std::string finish();

 private:
  std::unique_ptr<Place> place_;
  study::StreetCrossings crossings_;
  std::vector<Conflict> conflicts_;
  std::unique_ptr<CompleteFile> csv_, svg_;
  double time_ = 0.0;
  bool begun_ = false;
};

}  // namespace pedzone
