// Vehicles as one person meets them: which of them it is aware of, where their sides are, whether
// they will cross its way, and whether they would run into it.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "model/fixed_point.hpp"
#include "model/obstacle_lists.hpp"
#include "model/walker.hpp"
#include "world/snapshot.hpp"
#include "world/speeds.hpp"

namespace pedzone {

/// [m] room that people leave between their body and a moving vehicle's sides in any contact that
/// they foresee. Calibrated: vehicle.md, the rectangle inflated by 0.25 m, on the recordings of
/// vehicles and pedestrians.
inline constexpr float kVehicleRoom = 0.25F;
/// [m] the same for a parked vehicle: people pass it close. Assumed: a person whose velocity lags
/// behind its decision rounds a corner that much tighter than it meant to.
inline constexpr float kParkedRoom = 0.1F;

/// A vehicle, prepared once a step. The rectangle keeps its heading and velocity: extrapolating
/// the yaw rate fitted the recordings no better (vehicle.md).
struct VehicleShape {
  LatticePoint centre;
  float cos = 1.0F, sin = 0.0F;                 ///< of its heading
  float half_length = 2.5F, half_width = 0.9F;  ///< [m]
  float vx = 0.0F, vy = 0.0F;                   ///< [m/s]
  float speed = 0.0F;                           ///< [m/s]
  float reach = 2.66F;                          ///< [m] centre to corner
  float loudness = 1.0F;                        ///< how much farther than a slow car it is heard
  bool horn = false;
  bool invites = false;  ///< nobody need give way to it
  bool moving() const { return speed >= kStaticSpeed; }
};

VehicleShape shape_of(const VehicleState& vehicle, const LatticeOrigin& origin);

/// Makes it faster by `gain` [m/s] ≥ 0, unless it stands: people expect a vehicle that speeds up to
/// go on so. Measured on recordings: src/validation/README.md.
void expect_gain(VehicleShape& shape, double gain);

/// [m] how far a horn is heard, by anybody. Assumed.
inline constexpr float kHornReach = 60.0F;

/// How much farther than a slow car a vehicle is heard: the sound of tyres grows by 30 dB for ten
/// times the speed (the usual rule for tyre noise), so its reach with speed to the power of 1.5;
/// below 4.2 m/s (15 km/h) an engine covers that. An electric vehicle has none, and is heard half
/// as far when it drives slowly (assumed: tyres and its warning sound).
float loudness_of(float speed, bool electric);

enum class Awareness { kNone, kSeen, kHeard };

/// A vehicle relative to one person: everything in the vehicle's frame, x ahead, y left.
struct VehicleView {
  const VehicleShape* shape = nullptr;
  float x = 0.0F, y = 0.0F;  ///< [m] the person
  float distance = 0.0F;     ///< [m] from the person's centre to the rectangle, 0 inside
  float contact = 0.0F;      ///< [m] distance from the rectangle that counts as a contact
};

/// The view, whatever the person is aware of.
VehicleView view_of(const VehicleShape& shape, const Walker& person);

/// Whether its sound reaches the person, wherever that looks.
bool heard(const VehicleView& view, const Senses& senses);

/// Seen: some part of the rectangle lies in the field of view and its nearest point within sight.
/// A parked vehicle within sight counts as seen all round: like a wall it is remembered. Heard:
/// not seen, moving, its nearest point within hearing times its loudness; or it sounds its horn
/// within kHornReach.
Awareness awareness(const VehicleView& view, const Walker& person, const Senses& senses);

/// Whether a person walking at its preferred speed could touch the vehicle within `horizon` [s].
/// May say yes where it could not.
bool touchable(const VehicleView& view, const Walker& person, float horizon);

/// Adds the vehicle's sides and corners to what the person must not walk into.
void add_vehicle(const VehicleView& view, const Walker& person, DiscList& discs, FaceList& faces);

/// A person who walks with velocity (vx, vy) [m/s] from a place (dx, dy) [m] from where it is now.
struct AssumedWalk {
  float dx = 0.0F, dy = 0.0F;
  float vx = 0.0F, vy = 0.0F;
};

/// When [s], not before `from` [s], the vehicle touches the person, were it there now and walked
/// so; infinity when it never does.
float time_to_touch(const VehicleView& view, const Walker& person, const AssumedWalk& walk,
                    float from);

/// Time [s] in which a person that walks with velocity (vx, vy) [m/s] is beside the vehicle's way;
/// infinity when it never is.
float time_to_leave_its_way(const VehicleView& view, float vx, float vy);

/// Cosine of the angle between a moving vehicle's way and the person's heading: 1 where it comes
/// from behind, -1 where they meet.
float cosine_to(const VehicleShape& vehicle, const Walker& person);

/// Whether it has driven past the person, its rear included.
bool has_passed(const VehicleView& view);

inline constexpr float kNotInItsWay = std::numeric_limits<float>::infinity();

/// How far [m] ahead of the vehicle the person stands in its way, the band that it sweeps, its own
/// body and `margin` [m] included: 0 beside or at its front, kNotInItsWay outside of the band.
float distance_in_its_way(const VehicleView& view, const Walker& person, float margin);

/// Whether the vehicle's front reaches the first `distance` [m] of the person's way in direction
/// (ex, ey) within `time` [s]. A way that meets the vehicle where it is now is not crossed by it.
bool crosses_way(const VehicleView& view, const Walker& person, float ex, float ey, float distance,
                 float time);

}  // namespace pedzone
