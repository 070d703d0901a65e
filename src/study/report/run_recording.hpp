// What runs' outputs are drawn with: the place they were in, and how large everybody is.
#pragma once

#include <map>
#include <string>

#include "results/place.hpp"
#include "study/plan/plan.hpp"
#include "sumo/files/recording_reader.hpp"

namespace pedzone::study {

/// Floating-car data of a run, in its folder.
inline constexpr const char* kFcdName = "fcd.xml.gz";

/// Places of runs, each built once.
class RunPlaces {
 public:
  explicit RunPlaces(const Plan& plan) : plan_(plan) {}

  /// The place of a run, whose folder has its zone file (zone.zone.xml) where it has one. Valid as
  /// long as this is. Throws InputError.
  const Place& of(const PlannedRun& run, const std::string& folder);

 private:
  const Plan& plan_;
  std::map<std::string, Place> places_;  ///< by the files that make it
};

/// What the files of a run say of everybody: those of its scenario, and the panel's people.
/// Throws InputError.
RecordingCast run_cast(const Plan& plan, const PlannedRun& run, const std::string& folder);

}  // namespace pedzone::study
