// A vehicle in or near a zone, as plain values.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/polyline.hpp"
#include "geometry/rectangle.hpp"
#include "world/speed_gain.hpp"
#include "world/vehicle_parts.hpp"

namespace pedzone {

inline constexpr double kShortMove = 0.01;  ///< [m] numerical: so little gives no direction

/// What does not change during a vehicle's life.
struct VehicleTraits {
  double length = 5.0, width = 1.8;                        ///< [m]
  VehicleParts parts;                                      ///< where it bends
  double decel = 4.5, emergency_decel = 9.0, accel = 2.6;  ///< [m/s²] > 0
  double min_gap = 2.5;    ///< [m] ≥ 0 to the one before it, as it likes to keep
  bool yields = true;      ///< vType or vehicle parameter pedzone.yield
  bool external = false;   ///< another program drives it: perceived, never touched
  bool electric = false;   ///< parameter pedzone.electric: no engine is heard
  bool ballistic = false;  ///< within a step its speed changes evenly (SUMO's
                           ///< step-method.ballistic); else it has the new one from the beginning
  bool drifts = false;     ///< it changes lanes bit by bit (SUMO's lanechange.duration)
  bool sublanes = false;   ///< it drives anywhere on its lane (SUMO's lateral-resolution)
};

/// What SUMO tells of a vehicle at present.
struct VehicleSeen {
  std::string id;
  VehicleTraits traits;
  Vec2 front = Vec2::Zero();   ///< [m] middle of the front bumper
  double heading = 0.0;        ///< [rad]
  double speed = 0.0;          ///< [m/s] ≥ 0
  double own_speed = 0.0;      ///< [m/s] ≥ 0 if no client of SUMO's had told it anything
  double allowed_speed = 0.0;  ///< [m/s] what it may drive here
  double time_loss = 0.0;      ///< [s] SUMO's timeLoss so far
  bool stopped = false;        ///< at a stop of its own (also parking)
  bool parks = false;          ///< ... beside the road
  bool horn = false;           ///< parameter pedzone.horn of it or its vType is true at present
  bool invites = false;        ///< pedzone.signal is after-you at present
  int lane = -1;               ///< index into Network::lanes; -1: on none of them
  double lateral = 0.0;        ///< [m] on its lane, positive to the left
  bool overtakes = false;      ///< on the lane beside that, for the other direction
  std::span<const int> route;  ///< indices into Network::edges; -1: not in the network
  int route_index = 0;         ///< of the edge of its route that it reached last
  std::span<const int> means;  ///< lanes that SUMO means it to take; empty: there is one way only
};

/// The junction that a vehicle is in, or comes to first on its way.
struct JunctionAhead {
  int junction = -1;   ///< index into Network::junctions; -1: none
  double begin = 0.0;  ///< [m] from the front to its stop line; ≤ 0: it is so far in the junction
  double end = 0.0;    ///< [m] from the front to where its way leaves the junction
  bool shared = false;     ///< another vehicle is in it or comes to it from elsewhere
  bool signalled = false;  ///< lights, or barriers of a railway, say who goes
};

/// The vehicle that one drives behind.
struct LeaderAhead {
  std::size_t index = 0;  ///< among all vehicles near zones
  double gap = 0.0;       ///< [m] > 0 from the front to its body, along the way
};

/// A vehicle near a zone.
struct FleetVehicle : VehicleSeen {
  Vec2 velocity = Vec2::Zero();  ///< [m/s] from its last two places: reversing and side-slip too
  double yaw_rate = 0.0;         ///< [rad/s] of a steered one (steering.hpp)
  SpeedGain gain;                ///< as people see it
  double drift = 0.0;            ///< [m/s] sideways, to the left, while it changes lanes so
  std::vector<int> behind;       ///< lanes that it came by to its present one, the last first
  Polyline way;                  ///< [m] from its rear along its own last and next lanes
  bool leaves = false;           ///< where its way ends its trip does, or
                                 ///< before; or it goes on above or below the zones
  std::vector<int> yields_at;    ///< crossings on its way, as of Lane::yields_at
  JunctionAhead junction;
  double tight_end =
      std::numeric_limits<double>::infinity();  ///< [m] from the front to the end of
                                                ///< its lane of a zone, if it fills that
  double follows_at = std::numeric_limits<double>::infinity();  ///< [m/s] for the one before it
  std::optional<LeaderAhead> leader;  ///< the nearest on its way, as far as it needs to stop
  double seen_for = 0.0;  ///< [s] since it is near a zone: SUMO put it there, or it drove there
  double new_loss = 0.0;  ///< [s] of time_loss, since the last step, if it was near a zone then
  int zone = 0;           ///< index of the zone it is in or comes to first
  double left_alone = std::numeric_limits<double>::infinity();  ///< [s] since it was told a speed
  double commanded = -1.0;    ///< [m/s] speed set by us for the next step; -1: SUMO's own
  double pull = 0.0;          ///< [m/s²] that this speed asks for; of use while it is commanded
  double blocked_time = 0.0;  ///< [s] ≥ 0 for which people have made it stand
  double slowed = 0.0;        ///< [s] people have made it slower without a break
  double claim = 0.0;         ///< [m] see VehicleState
  double gave_way = 0.0;      ///< [s] it has stood for people on a crossing since it drove last
  bool creeping = false;
  bool reverses = false;  ///< its front went backwards along its way
  bool lets_go = false;   ///< it is told to stand, so that people beside it go first
  bool waits = false;     ///< it stands, as it did before, and not since we told it to

  Vec2 centre() const { return front - unit(heading) * (0.5 * traits.length); }
};

/// Whether it is told anything for people on its way: neither another program's, nor at a stop of
/// its own.
bool gives_way(const FleetVehicle& vehicle);

/// [m] in which it stops as it likes to brake.
double braking_distance(const FleetVehicle& vehicle);
/// [m] the same in SUMO's steps of `dt` [s]: but for ballistic ones it drives each as fast as it is
/// at its end. One that stops as SUMO's do needs all of that, and no more, until it stands.
double stopping_distance(const FleetVehicle& vehicle, double dt);

/// [m/s] after a step of `dt` [s] in which it brakes as it likes to.
double speed_if_braked(const FleetVehicle& vehicle, double dt);

/// [m/s] after that share [0, 1] of a step of SUMO's that changes its speed from `before` to
/// `after` [m/s]; after half of it: the mean of the step.
double speed_within(const VehicleTraits& traits, double before, double after, double share);

/// Whether its front is inside a junction.
bool is_in_junction(const FleetVehicle& vehicle);

/// Whether its way goes on ahead of its front.
bool goes_on(const FleetVehicle& vehicle);

/// Whether its front has come to where it is from a place farther on along its way. Its heading
/// does not tell: that of one that turns round in little room points elsewhere than it drives.
bool came_from_ahead(const FleetVehicle& vehicle, const Vec2& front_before);

/// The part of the plane that a vehicle covers: a rectangle, or one of each of its parts.
class VehicleBody {
 public:
  void add(const Rectangle& part) { parts_.push_back(part); }

  std::span<const Rectangle> parts() const& { return {parts_.data(), parts_.size()}; }
  std::span<const Rectangle> parts() const&& = delete;  // they would be gone
  /// That with the front bumper.
  const Rectangle& first() const { return parts_.front(); }
  /// Distance [m] from the point to the body, negative inside.
  double signed_distance(const Vec2& point) const {
    double least = first().signed_distance(point);
    for (const Rectangle& part : parts().subspan(1)) {
      least = std::min(least, part.signed_distance(point));
    }
    return least;
  }

 private:
  boost::container::small_vector<Rectangle, 1> parts_;  ///< the first first
};

VehicleBody body_of(const FleetVehicle& vehicle);

/// The body after the front has gone `travelled` [m] along the way. Each part is a chord of the way
/// from its rear to its front, so that corners are cut as SUMO draws them.
VehicleBody body_after(const FleetVehicle& vehicle, double travelled);

}  // namespace pedzone
