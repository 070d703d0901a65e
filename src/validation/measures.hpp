// What one person's way past vehicles was like: the same measures for recorded and walked ways.
#pragma once

#include <optional>

#include "validation/passing_order.hpp"
#include "validation/replay.hpp"

namespace pedzone {

struct Measures {
  double clearance = 0.0;    ///< [m] least distance from the person's centre to the rectangle of a
                             ///< moving vehicle; infinity without one
  double unpushed = 0.0;     ///< [m] the same where nobody is kept out of vehicles; negative: the
                             ///< centre was so deep inside
  double deviation = 0.0;    ///< [m] greatest distance from the line from start to goal
  double mean_speed = 0.0;   ///< [m/s] of the way walked until within 0.5 m of the goal
  double least_speed = 0.0;  ///< [m/s] least over half a second, until then
  double least_ttc = 0.0;    ///< [s] least time to collision with a moving vehicle if both keep
                             ///< their velocity; infinity without any
  std::optional<PassingOrder> passing;  ///< with the vehicle that came closest in time; none where
                                        ///< their ways do not cross
  std::optional<PushedPerson> push;     ///< by moving vehicles; none where no crowd walked
  double ade = 0.0, fde = 0.0;  ///< [m] mean and last distance to the recorded person, from the
                                ///< first second's end on
};

/// Measures of a way with the frames of `track` (one place for each), which nobody was pushed on,
/// past the vehicles of `clip`, of which `ways` is. Start and goal are taken from the track.
Measures measure(const Clip& clip, const VehicleWays& ways, const PersonTrack& track,
                 const Polyline& way);
/// Measures of the clip's person as it was walked again.
Measures measure(const Clip& clip, const VehicleWays& ways, std::size_t person,
                 const Replayed& replayed);

}  // namespace pedzone
