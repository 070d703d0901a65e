// What goes into a crowd and what is read back of it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "model/walking_model.hpp"
#include "world/activities.hpp"
#include "world/profiles.hpp"
#include "zone/crosswalks.hpp"
#include "zone/paths.hpp"

namespace pedzone {

/// A walked person's number: stable while it is in the crowd, given out again afterwards.
using PersonHandle = std::uint32_t;

/// Where a person's walk through the zone ends: anywhere on the segment a–b (a portal as wide as
/// the street; a = b is one point). Reached by crossing the segment or coming within 0.3 m of it
/// (0.5 m of a single point), or of the nearest place inside the walls where it lies outside.
struct Destination {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();  ///< [m]
};

/// [m] Where there is none.
constexpr double kNoWay = std::numeric_limits<double>::infinity();

struct NewPerson {
  std::uint64_t key = 0;          ///< person_key(id)
  Vec2 position = Vec2::Zero();   ///< [m]
  Vec2 velocity = Vec2::Zero();   ///< [m/s]
  double heading = 0.0;           ///< [rad]
  double radius = 0.24;           ///< [m]
  double preferred_speed = 1.34;  ///< [m/s]
  Destination destination;
  const Profile* profile = nullptr;         ///< must outlive the crowd; null: as the zone's
                                            ///< parameters say, without activities
  std::optional<bool> aware;                ///< of vehicles; unset: by the profile's share
  std::uint64_t group = 0;                  ///< persons of the same number keep together; 0: alone
  std::vector<Waypoint> path;               ///< come by these in turn, then to the destination;
                                            ///< one that cannot be reached is passed over when
                                            ///< patience runs out, at once where there is no way
  std::array<double, kActivities> rates{};  ///< [1/min] at which each activity begins
  double by_junctions = kNoWay;             ///< [m] to the destination by SUMO's junctions, where
                                            ///< some of that way lies outside the zone
  bool place_freely = false;                ///< departs here: moved to the nearest free place if
                                            ///< somebody or something stands there
};

/// Somebody near the zone whom SUMO still walks: seen, not moved. Who stands turns and steps back
/// for who passes, by as much as it takes and at most half a metre; then it is taken to be there.
struct SeenPerson {
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
  double radius = 0.24;
  std::uint64_t key = 0;  ///< person_key(id), by which it is known again; 0: stands like a post
  double heading = 0.0;   ///< [rad] where it faces; of who moves the velocity counts
  bool turns = true;      ///< its shoulders; false: is as wide all round
};

/// Waiting: for a vehicle. Standing: slower than 0.1 m/s for at least a second for another reason.
enum class Motion : std::uint8_t { kWalking, kWaiting, kStanding };
const char* name_of(Motion motion);  ///< "walking", "waiting", "standing"

/// One person, read back.
struct PersonView {
  Vec2 position, velocity;
  double heading;
  Motion motion;
  Activity activity;
  bool arrived;          ///< on its destination (or gave up there after its patience)
  bool gave_up;          ///< arrived only since patience ran out near a blocked destination
  bool waits_for_group;  ///< is too far ahead of the last of its group
  bool makes_way;        ///< goes out of the room that a vehicle claims
  bool holds_hand;       ///< a child whom an adult leads by the hand
  bool crosses;          ///< a street, between the junctions
  std::optional<Crosswalk> crosswalk;  ///< that it is on or about to enter, from where it comes
  bool stays_outside;  ///< would rather go by SUMO's junctions (NewPerson::by_junctions)
  double radius;       ///< [m] of the body as it holds its shoulders now
};

/// What a person is about to do, for pictures.
struct Insight {
  Vec2 position = Vec2::Zero(), aim = Vec2::Zero();  ///< [m] what it heads for now
  std::optional<Waypoint> waypoint;                  ///< of its path, that it is on the way to
  double direction = 0.0, speed = 0.0;               ///< [rad], [m/s] as it chooses them
  std::vector<Ray> rays;                             ///< how far it finds each direction free
};

/// What one vehicle that drives did to one person in one step.
struct VehiclePush {
  std::uint64_t person = 0, vehicle = 0;  ///< their keys
  double way = 0.0;                       ///< [m] by which it moved the person from where the
                                          ///< person's own moves led, summed over the substeps
  double carried = 0.0;                   ///< [m] of those the part along which the vehicle drives,
                                          ///< while the person was before its bumper
  double speed = 0.0;                     ///< [m/s] of the fastest of those
  bool run_into = false;                  ///< the bodies overlap: it would have had to move the
                                          ///< person faster than people step, or no room was left
  double contact_speed = 0.0;             ///< [m/s] of the vehicle when that began; else as it
                                          ///< drove last
  Vec2 position = Vec2::Zero();           ///< [m] of the person then; else after the step
};

/// Somebody who stepped out to cross a street between the junctions.
struct CrossingBegun {
  PersonHandle handle = 0;
  std::uint32_t street = 0;      ///< index in Zone::streets
  double s = 0.0;                ///< [m] place along the street
  Vec2 position = Vec2::Zero();  ///< [m]
  double time = 0.0;             ///< [s] on the crowd's clock
  double waited = 0.0;           ///< [s] at the kerb
  double gap = 0.0;              ///< [s] until the next vehicle came; infinity: none was seen
  double needed = 0.0;           ///< [s] critical gap
  double width = 0.0;            ///< [m] of the carriageway
  bool looked = true;            ///< false: stepped out without looking
  std::vector<float> rejected;   ///< [s] gaps that it had let pass
};

/// Somebody who is stuck among people and squeezes through from now on.
struct JamNotice {
  PersonHandle handle = 0;
  Vec2 position = Vec2::Zero();  ///< [m]
};

}  // namespace pedzone
