// Follows pairs of a person and a vehicle through a run, and tells their conflicts.
//
// A step:   take everybody in  ->  per vehicle, persons that may matter  ->  measure  ->  close
//
// A pair matters in a step if
// - its TTC is within the horizon, and the bodies are within the range of each other,
// - or it has come as near as kNear since the step before,
// - or one has entered a place that the other left less than the PET's memory ago.
// An encounter begins when its pair matters. It is over when the pair has not mattered for as long
// as that memory, or when one of the two is gone.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "conflict/cast.hpp"
#include "conflict/encounter.hpp"
#include "conflict/search.hpp"
#include "geometry/rectangle.hpp"

namespace pedzone {

/// A person as it is in a step.
struct PersonSample {
  std::string_view id;
  Vec2 position = Vec2::Zero();    ///< [m] centre of the disc
  Vec2 velocity = Vec2::Zero();    ///< [m/s]
  double heading = 0.0;            ///< [rad] where it faces
  double radius = 0.24;            ///< [m] (0, 5]
  std::string_view rides_in = {};  ///< vehicle that it is inside of: not measured while it rides,
                                   ///< and never against that vehicle
  std::string_view edge = {};      ///< of SUMO, where it is known: not for conflicts
  std::optional<bool> by_pedzone = {};  ///< pedzone walks it; nothing: not known
};

/// A vehicle as it is in a step. One that bends is there part by part.
struct VehicleSample {
  std::string_view id;
  Vec2 centre = Vec2::Zero();        ///< [m] of the rectangle
  double heading = 0.0;              ///< [rad]
  Vec2 velocity = Vec2::Zero();      ///< [m/s]
  double length = 5.0, width = 1.8;  ///< [m] > 0
  int part = 0;                      ///< of the vehicle of that id; 0: the first, or all of it
};

/// Adds a vehicle that bends, its first part first, of which each drives at `speed` [m/s] along its
/// own axis; < 0: backwards.
void add_parts(std::string_view id, std::span<const Rectangle> parts, double speed,
               std::vector<VehicleSample>& samples);

/// Whether person i is aware of vehicle j (indices into the step's samples); nothing: not known.
using AwareOf = std::function<std::optional<bool>(std::size_t person, std::size_t vehicle)>;

/// [s] a PET is looked for at least so far back, also where only a smaller one makes a conflict.
/// Assumed: beyond this nobody would tell that one had to do with the other.
inline constexpr double kMemory = 5.0;
/// [m/s²] a vehicle that slows down harder is braking. Assumed: more than rolling out, or than the
/// rounding of speeds in a file, makes of it.
inline constexpr double kBraking = 0.5;

class ConflictTracker {
 public:
  explicit ConflictTracker(const ConflictLimits& limits);

  /// Takes in a step at `time` [s], later than the one before. Who was in the step before and is in
  /// this one has moved evenly in between, vehicles on an arc; who has moved farther than its
  /// speeds explain (a teleport) begins anew. Appends conflicts that are over to `over`, by begin,
  /// person, vehicle. A sample with a number that is not finite is left out. A vehicle's first part
  /// comes before its others.
  void step(double time, std::span<const PersonSample> persons,
            std::span<const VehicleSample> vehicles, const AwareOf& aware,
            std::vector<Conflict>& over);

  /// Closes all encounters.
  void finish(std::vector<Conflict>& over);

  /// [s] the longest step so far. Who is followed has moved evenly in it: with steps of more than
  /// some 2 s people and vehicles that passed each other meet.
  double longest_step() const { return longest_; }

  /// Pairs that are followed at present.
  std::size_t encounters() const { return encounters_.size(); }

 private:
  struct Person : CastMember {
    Vec2 velocity = Vec2::Zero();
    double radius = 0.0;
    std::optional<bool> by_pedzone;
    std::uint32_t encounters = 0;   ///< of it, that are not over
    std::uint64_t own_vehicle = 0;  ///< serial number of the one it rides or rode in; 0: none
    Trail<PersonPose> trail;
  };
  struct Vehicle : CastMember {
    Vec2 velocity = Vec2::Zero();
    double half_length = 0.0, half_width = 0.0;
    bool braking = false;
    std::uint32_t whole = 0;  ///< place of the vehicle's first part
    Trail<VehiclePose> trail;
  };

  void take(const PersonSample& sample, std::size_t index);
  void take(const VehicleSample& sample, std::size_t index);
  void board(Person& person, std::uint32_t place, std::string_view vehicle);
  void sort_persons();
  void meet_persons(std::uint32_t vehicle, const AwareOf& aware);
  bool is_followed(const PersonRow& person, const Vehicle& vehicle) const;
  void meet(const PersonRow& person, std::uint32_t vehicle, const Search::Reasons& reasons,
            const AwareOf& aware);
  void measure(const Trail<PersonPose>& person, const Trail<VehiclePose>& vehicle,
               const Search::Reasons& reasons, Meeting& meeting) const;
  void close(bool all, std::vector<Conflict>& over);

  ConflictLimits limits_;
  double memory_;                     ///< [s]
  double time_ = 0.0, before_ = 0.0;  ///< [s] of this step and the one before
  double longest_ = 0.0;              ///< [s]
  bool begun_ = false;
  Cast<Person> persons_;
  Cast<Vehicle> vehicles_;
  std::vector<PersonRow> unsorted_, rows_;               ///< this step's; rows_: by ascending x
  std::vector<std::pair<double, std::uint32_t>> order_;  ///< x [m] and index in unsorted_
  PersonExtremes most_;
  std::unordered_map<std::uint64_t, Encounter> encounters_;  ///< by the places of the person
                                                             ///< and of the vehicle's first part
};

}  // namespace pedzone
