// Vehicles give way to the people that pedzone walks: what each is told, and when it is given back.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "sumo/plan/people_near.hpp"
#include "sumo/plan/vehicle_order.hpp"
#include "sumo/plan/yield_plan.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// A vehicle that braked harder than it likes to, for somebody who stepped in late, or behind one
/// that did.
struct LateBraking {
  double time = 0.0;  ///< [s] when it began
  std::string vehicle;
  Vec2 front = Vec2::Zero();  ///< [m] then
  double deceleration = 0.0;  ///< [m/s²] that it began with
};

class Yielding {
 public:
  explicit Yielding(const std::vector<Zone>& zones) : zones_(zones) {}

  /// The speed that each vehicle takes in the next step of `dt` [s], by its plan (yield_plan.hpp);
  /// those that no longer need one are given back. `people`: whom it gives way to; `outside`: whom
  /// SUMO walks. `time` [s]: at the step's begin.
  std::vector<SpeedOrder> plan(std::span<FleetVehicle> vehicles, const PeopleNear& people,
                               std::span<const PersonAhead> outside, const SafeSpeeds& safe_speeds,
                               double time, double dt);

  /// The vehicle has run into somebody, or still overlaps whom it did. Whether it gives way to
  /// people or not, it brakes as hard as it can until it stands, and stands for 5 s. Those that
  /// others drive and those on a path of the zone file are not touched.
  void stop(const std::string& vehicle) { stopping_[vehicle] = 0.0; }

  /// That id stands for another vehicle from now on, or for none.
  void forget(const std::string& vehicle);

  /// Ids of all vehicles that ever gave way.
  const std::unordered_set<std::string>& yielded() const { return yielded_; }
  /// In time. Of a vehicle that does so again within a second, only the first.
  const std::vector<LateBraking>& late_brakings() const { return late_brakings_; }

 private:
  /// A vehicle that leaves room at its lane's end.
  struct StandsAtEnd {
    double stood = 0.0;  ///< [s]
    double alone = 0.0;  ///< [s] since somebody was there who may want in
  };

  std::optional<YieldOrder> plan_start(FleetVehicle& vehicle, const PeopleNear& near,
                                       double dt) const;
  std::optional<YieldOrder> plan_for_people(FleetVehicle& vehicle, const PeopleNear& near,
                                            const SafeSpeeds& safe_speeds, double time, double dt);
  static void keep_junctions_clear(std::span<FleetVehicle> vehicles, const SafeSpeeds& safe_speeds,
                                   double dt, std::vector<std::optional<YieldOrder>>& planned);
  bool leaves_room(const FleetVehicle& vehicle, std::span<const PersonAhead> people,
                   std::span<const PersonAhead> outside, double dt);
  void keep_lane_ends_free(std::span<FleetVehicle> vehicles, std::span<const PersonAhead> people,
                           std::span<const PersonAhead> outside, const SafeSpeeds& safe_speeds,
                           double dt, std::vector<std::optional<YieldOrder>>& planned);
  bool braked_just_now(const FleetVehicle& vehicle, double time) const;
  void keep_behind_late_brakers(std::span<FleetVehicle> vehicles, const SafeSpeeds& safe_speeds,
                                double time, double dt,
                                std::vector<std::optional<YieldOrder>>& planned);
  void command(FleetVehicle& vehicle, const YieldOrder& order, std::vector<SpeedOrder>& out);
  std::optional<YieldOrder> plan_stop(FleetVehicle& vehicle, double dt);
  void give_back(FleetVehicle& vehicle, std::vector<SpeedOrder>& out);
  void note(const FleetVehicle& vehicle, double time);

  const std::vector<Zone>& zones_;
  std::unordered_set<std::string> commanded_, yielded_, in_emergency_;
  std::unordered_map<std::string, double> stopping_;     ///< [s] for which it stands already
  std::unordered_map<std::string, double> braked_late_;  ///< [s] when last
  std::unordered_map<std::string, StandsAtEnd> at_end_;
  std::vector<LateBraking> late_brakings_;
};

}  // namespace pedzone
