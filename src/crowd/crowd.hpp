// The people of one zone, and the step that moves them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "crowd/state/person.hpp"
#include "zone/zone.hpp"

namespace pedzone {

class Crowd {
 public:
  using Handle = PersonHandle;

  /// Walks by the zone's model. `zone` must outlive the crowd.
  Crowd(const Zone& zone, std::uint64_t seed);
  /// Walks by any model.
  Crowd(const Zone& zone, std::uint64_t seed, std::unique_ptr<WalkingModel> model);
  ~Crowd();
  Crowd(Crowd&&) noexcept;
  Crowd& operator=(Crowd&&) noexcept;

  /// Puts a person in the zone, at the place inside its walls that is nearest to the one given,
  /// and plans its way. A radius or speed out of the range of Persons is clamped, a velocity
  /// faster than the preferred speed shortened. Throws std::invalid_argument for a number that is
  /// not finite.
  Handle add(const NewPerson& person);
  void remove(Handle handle);
  /// Plans the way anew from where the person is; it has not arrived any more. Waypoints of its
  /// path that are left still come first.
  void set_destination(Handle handle, const Destination& destination);
  void set_preferred_speed(Handle handle, double speed);  ///< [m/s]
  /// Replaces those who are seen. They move on with their velocity until the next call.
  void see(std::span<const SeenPerson> others);

  /// Walks everybody for `dt` [s] in equal substeps of at most 0.1 s. `vehicles` are where they
  /// are now; between substeps they move on with their velocity and yaw rate. Results depend on
  /// the persons' keys, not on the order in which they were added nor on the number of threads.
  /// Never throws for what persons and vehicles do; allocates nothing once sizes have settled,
  /// except for the ways of those who have to plan again.
  void step(double dt, std::span<const VehicleState> vehicles);

  /// From now on nobody is kept out of vehicles: for measures of what a model does by itself.
  void let_vehicles_through();

  PersonView view(Handle handle) const;
  /// Who in the last step() had not got on among people for `jamTime`, and began to squeeze.
  std::span<const JamNotice> jams() const;
  /// Whether anybody was ever moved by a vehicle, one that stands included.
  bool kept_anybody_out() const;
  /// Who in the last step() stepped out to cross a street between the junctions.
  std::span<const CrossingBegun> crossings() const;
  /// Whom vehicles that drive pushed or ran into in the last step(), by person and vehicle.
  std::span<const VehiclePush> pushes() const;
  /// Whether the person sees or hears the vehicle.
  bool aware_of(Handle handle, const VehicleState& vehicle) const;
  /// Of those persons, in that order. Slow; changes nothing that a later step depends on.
  std::vector<Insight> insights(std::span<const Handle> handles);
  /// [m] Where the crowd takes somebody it sees to be now; nothing where it does not know the key.
  std::optional<Vec2> seen_at(std::uint64_t key) const;
  std::size_t size() const;
  std::uint64_t person_steps() const;  ///< person-substeps so far

  /// Whether somebody has that handle.
  bool has(Handle handle) const;
  /// All of them as they are stored, to be read without a copy: until the next call that is not
  /// const, which may put others in a row.
  const Persons& persons() const;
  Handle handle_in(std::size_t row) const;  ///< row < size()
  /// Gives persons() away with its memory and goes on with a copy: for those who read on.
  Persons give_away_persons();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pedzone
