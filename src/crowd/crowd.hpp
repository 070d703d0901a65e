// The people of one zone, and the step that moves them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/walking_model.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// Where a person's walk through the zone ends: anywhere on the segment a–b (a portal as wide as
/// the street; a = b is one point).
struct Destination {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();   ///< [m]
};

struct NewPerson {
  std::uint64_t key = 0;                ///< person_key(id)
  Vec2 position = Vec2::Zero();         ///< [m]
  Vec2 velocity = Vec2::Zero();         ///< [m/s]
  double heading = 0.0;                 ///< [rad]
  double radius = 0.24;                 ///< [m]
  double preferred_speed = 1.34;        ///< [m/s]
  Destination destination;
  bool place_freely = false;            ///< departs here: moved to the nearest free place if
                                        ///< somebody or something stands there
};

/// Somebody near the zone whom SUMO still walks: seen, not moved.
struct SeenPerson {
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
  double radius = 0.24;
};

enum class Activity : std::uint8_t { kWalking, kWaiting, kStanding };
const char* name_of(Activity activity);   ///< "walking", "waiting", "standing"

/// One person, read back.
struct PersonView {
  Vec2 position, velocity;
  double heading;
  Activity activity;
  bool arrived;             ///< on its destination (or gave up there after its patience)
  bool gave_up;             ///< arrived only since patience ran out near a blocked destination
};

class Crowd {
 public:
  using Handle = std::uint32_t;   ///< stable while the person is in the crowd; reused afterwards

  /// `zone` must outlive the crowd.
  Crowd(const Zone& zone, std::uint64_t seed);
  ~Crowd();

  Handle add(const NewPerson& person);
  void remove(Handle handle);
  void set_destination(Handle handle, const Destination& destination);
  void set_preferred_speed(Handle handle, double speed);
  void see(std::span<const SeenPerson> others);

  /// Walks everybody for `dt` [s] in equal substeps of at most 0.1 s. `vehicles` are where they
  /// are now; between substeps they move on with their velocity and yaw rate.
  void step(double dt, std::span<const VehicleState> vehicles);

  PersonView view(Handle handle) const;
  std::size_t size() const;
  std::uint64_t person_steps() const;   ///< person-substeps so far

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pedzone
