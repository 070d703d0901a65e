// Who crosses a zone's streets where, as an observer beside the street would count it: from
// places alone, whoever walked the people.
//
//   waits at the kerb     steps out                reaches the other side
//   |--- vehicles pass ---|----- between the junctions -----|
//   gaps let pass          the gap that was taken: until the next vehicle passes there
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "conflict/gap_acceptance.hpp"
#include "conflict/tracker.hpp"
#include "results/crossing_table.hpp"
#include "zone/zone.hpp"

namespace pedzone::study {

/// Conflicts with moving vehicles, by person.
using ConflictsOf = std::unordered_multimap<std::string_view, const Conflict*>;

/// The crossings of one street.
class StreetWatch {
 public:
  /// `street` must outlive it.
  explicit StreetWatch(const Street& street) : street_(&street) {}

  /// A step at `time` [s], `dt` [s] after the one before.
  void step(double time, double dt, std::span<const PersonSample> persons,
            std::span<const VehicleSample> vehicles);
  /// Counts those of who crosses between the junctions. To be called once, after the last step.
  void count_conflicts(const ConflictsOf& conflicts);

  const std::vector<SeenCrossing>& all() const { return all_; }

 private:
  enum class Side { kUnknown, kLow, kHigh };
  /// Somebody who has been beside the street.
  struct Watched {
    Side side = Side::kUnknown;  ///< of the ground where it was last
    double since = 0.0;          ///< [s] on that side
    bool on_road = false;
    double s = 0.0;       ///< [m] where it is, or where it stepped out
    double ready = 0.0;   ///< [s] since when there is a gap: its arrival at the kerb, or the last
                          ///< vehicle's pass
    double waited = 0.0;  ///< [s]
    bool at_kerb = false;
    std::optional<double> gap;
    std::vector<double> let_pass;
  };

  void note_passes(double time, std::span<const VehicleSample> vehicles);
  void pass(double time, double from, double to);
  void stand_on(double time, Side side, Watched& pedestrian, const std::string& id);
  void count_conflict(const Conflict& conflict, Side from, SeenCrossing& crossing) const;

  const Street* street_;
  std::unordered_map<std::string, Watched> people_;
  std::unordered_map<std::string, double> fronts_;        ///< [m] s of vehicles in the last step
  std::unordered_map<std::string, std::size_t> awaited_;  ///< of who has crossed, in all_: whose
                                                          ///< next vehicle is still to come
  std::vector<SeenCrossing> all_;
  std::vector<Side> from_;  ///< which side, of each of them
};

/// Those of all streets.
class StreetCrossings {
 public:
  /// `zones` must outlive it.
  explicit StreetCrossings(const std::vector<Zone>& zones);

  void step(double time, double dt, std::span<const PersonSample> persons,
            std::span<const VehicleSample> vehicles);

  /// Those of people who cross between the junctions, on either half of the carriageway. To be
  /// called once, after the last step.
  void count_conflicts(std::span<const Conflict> conflicts);

  bool watch_any() const { return !streets_.empty(); }
  std::vector<SeenCrossing> all() const;
  /// Adds its measures, where there are streets that may be crossed anywhere.
  void finish(std::map<std::string, double>& values) const;

 private:
  std::vector<StreetWatch> streets_;
};

/// As a table (results/crossing_table.hpp).
std::string crossings_csv(std::span<const SeenCrossing> crossings);

/// Gaps that were taken and let pass between the junctions.
std::vector<GapChoice> gap_choices(std::span<const SeenCrossing> crossings);

}  // namespace pedzone::study
