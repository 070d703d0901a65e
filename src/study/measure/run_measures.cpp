#include "study/measure/run_measures.hpp"

#include <algorithm>
#include <unordered_set>

#include "conflict/tracker.hpp"
#include "results/complete_file.hpp"
#include "results/conflict_writer.hpp"
#include "results/density_grid.hpp"
#include "study/measure/attendance.hpp"
#include "study/measure/conflict_measures.hpp"
#include "study/measure/crowding.hpp"
#include "study/measure/demand_signature.hpp"
#include "study/measure/push_measures.hpp"
#include "study/measure/run_series.hpp"
#include "study/measure/street_crossings.hpp"
#include "study/measure/sumo_counts.hpp"
#include "study/measure/trip_measures.hpp"
#include "study/measure/vehicle_stops.hpp"
#include "study/measure/zone_stays.hpp"
#include "study/measure/zone_walks.hpp"
#include "sumo/files/fcd_reader.hpp"
#include "sumo/files/type_files.hpp"

namespace pedzone::study {
namespace {

/// For messages where a file cannot be written.
constexpr const char* kFolder = "the run's folder";

/// Striping takes a random share of up to `dawdling` off people's maximum speed in every step.
double free_share(const Scenario& scenario) {
  return 1.0 - 0.5 * std::clamp(read_numbers(scenario).dawdling, 0.0, 1.0);
}

void write_file(const std::string& path, const std::string& text) {
  write_complete_file(path, text, kFolder);
}

/// All that is measured step by step.
class Observer {
 public:
  Observer(const std::string& folder, const Trips& trips, const Place& place, double free_share)
      : folder_(folder),
        stays_(trips, place.network, place.zones),
        pedestrians_(trips),
        walks_(trips, place.zones, free_share),
        crossings_(place.zones),
        closeness_meter_(trips),
        series_(place.zones),
        writer_(
            {.xml = {}, .xml_option = {}, .csv = folder + "/conflicts.csv", .csv_option = kFolder}),
        tracker_(ConflictLimits{}) {}

  void step(double time, std::span<const PersonSample> persons,
            std::span<const VehicleSample> vehicles) {
    step_ = {step_.number + 1, time, step_.number > 0 ? time - step_.time : 0.0};
    attendance_.step(persons, vehicles);
    const std::span<const Pedestrian> pedestrians = pedestrians_.at(time, persons);
    series_.step(step_, vehicles);
    count_present(stays_.step(step_, pedestrians, closeness_meter_.of(step_.dt, pedestrians)));
    stops_.step(vehicles);
    crossings_.step(time, step_.dt, persons, vehicles);
    tracker_.step(time, persons, vehicles, {}, over_);
    take_conflicts();
  }

  /// [s] The last step that SUMO writes is the last before the end.
  double end() const { return step_.time + step_.dt; }
  std::size_t stops() const { return stops_.count(); }
  /// `trips`: not settled yet. Throws as Attendance::check().
  void check(const Trips& trips, const std::string& scenario) const {
    attendance_.check(trips, step_.dt, end(), scenario);
  }

  void finish(std::map<std::string, double>& values) {
    count_present(stays_.finish());
    tracker_.finish(over_);
    take_conflicts();
    writer_.finish();
    count_conflicts(values);
    walks_.finish(values);
    finish_crossings(values);
    crowding_.finish(values);
    series_.finish(values);
    write_file(folder_ + "/series.csv", series_.csv());
    write_file(folder_ + "/density.csv", grid_.csv());
  }

 private:
  void count_present(std::span<const Presence> present) {
    for (const Presence& presence : present) {
      if (presence.step.dt > 0.0) grid_.add(presence.pedestrian.at, presence.step.dt);
      walks_.add(presence);
      crowding_.add(presence);
      series_.add(presence);
    }
  }

  void take_conflicts() {
    for (Conflict& conflict : over_) {
      writer_.write(conflict);
      told_.push_back(std::move(conflict));
    }
    over_.clear();
  }

  /// Those of people in the zones: elsewhere SUMO walks everybody, with every model.
  void count_conflicts(std::map<std::string, double>& values) {
    ConflictMeasures conflicts;
    ConflictWriter writer({.xml = {},
                           .xml_option = {},
                           .csv = folder_ + "/" + kZoneConflicts,
                           .csv_option = kFolder});
    std::erase_if(told_, [&](const Conflict& conflict) {
      return !stays_.cover(conflict.person, moment_of(conflict).time);
    });
    for (const Conflict& conflict : told_) {
      conflicts.add(conflict);
      writer.write(conflict);
    }
    writer.finish();
    conflicts.finish(values);
  }

  void finish_crossings(std::map<std::string, double>& values) {
    if (!crossings_.watch_any()) return;
    crossings_.count_conflicts(told_);
    crossings_.finish(values);
    write_file(folder_ + "/" + kCrossings, crossings_csv(crossings_.all()));
  }

  std::string folder_;
  Attendance attendance_;
  ZoneStays stays_;
  Pedestrians pedestrians_;
  ZoneWalks walks_;
  StreetCrossings crossings_;
  ClosenessMeter closeness_meter_;
  Crowding crowding_;
  DensityGrid grid_;
  RunSeries series_;
  VehicleStops stops_;
  ConflictWriter writer_;
  ConflictTracker tracker_;
  std::vector<Conflict> over_, told_;  ///< told_: in the end those of people in the zones
  RunStep step_;                       ///< the latest
};

}  // namespace

RunMeasures measure_run(const RunOutputs& outputs, const Place& place) {
  const Scenario scenario = read_any_scenario(outputs.config, outputs.sumo_options);
  // Of a distribution's members SUMO says only there which one a person has got.
  std::vector<std::string> types = outputs.types;
  types.push_back(outputs.folder + "/tripinfo.xml");
  const auto sizes = read_type_files<BodySizes>(scenario, types);
  Trips trips = read_tripinfo(outputs.folder + "/tripinfo.xml");
  Observer observer(outputs.folder, trips, place, free_share(scenario));
  const std::unordered_set<std::string> as_persons;
  FcdReader(sizes, as_persons)
      .read(
          outputs.folder + "/fcd.xml.gz",
          [&](double time, auto persons, auto vehicles) { observer.step(time, persons, vehicles); },
          {});
  observer.check(trips, outputs.config);
  RunMeasures measures;
  observer.finish(measures.values);
  settle(trips, observer.end());
  measure_trips(trips, observer.end(), measures.values);
  take_sumo_counts(outputs.folder, measures.values);
  measure_pushes(outputs.folder, measures.values);
  if (!trips.vehicles.empty()) {
    measures.values["vehicle.stops"] =
        static_cast<double>(observer.stops()) / static_cast<double>(trips.vehicles.size());
  }
  measures.demand = demand_signature(trips);
  return measures;
}

}  // namespace pedzone::study
