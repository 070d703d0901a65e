// What an observer beside the streets counts: who crosses where, and which gaps people take.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conflict/gap_acceptance.hpp"
#include "conflict/tracker.hpp"
#include "results/complete_file.hpp"
#include "results/place.hpp"
#include "study/measure/street_crossings.hpp"

namespace pedzone {

/// What an observer has counted.
struct CrossingNumbers {
  std::size_t all = 0, between = 0;   ///< crossings; of them between the junctions
  double waited = 0.0;                ///< [s] at the kerb, mean of those; 0: none
  double near = 0.0, far = 0.0;       ///< conflicts of those with moving vehicles, by the half of
                                      ///< the carriageway, seen from the kerb they come from
  std::optional<GapAcceptance> gaps;  ///< which gaps are taken; nothing: too few are known
};

/// A few sentences.
std::string text_of(const CrossingNumbers& numbers);

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

  /// Writes the files.
  CrossingNumbers finish();

 private:
  std::unique_ptr<Place> place_;
  study::StreetCrossings crossings_;
  std::vector<Conflict> conflicts_;
  std::unique_ptr<CompleteFile> csv_, svg_;
  double time_ = 0.0;
  bool begun_ = false;
};

}  // namespace pedzone
