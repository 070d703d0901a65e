// Where a person and a vehicle are at one moment, and how a vehicle gets from one pose to the next.
#pragma once

#include "core/vec.hpp"

namespace pedzone {

/// In single precision what may be: there is one for every person and step of the memory.
struct PersonPose {
  Vec2 at = Vec2::Zero();  ///< [m] centre of the disc
  double time = 0.0;       ///< [s]
  float travelled = 0.0F;  ///< [m] so far
  float direction = 0.0F;  ///< [rad] in which it moves
};

struct VehiclePose {
  double time = 0.0;           ///< [s]
  Vec2 centre = Vec2::Zero();  ///< [m] of the rectangle
  Vec2 axis = Vec2::UnitX();   ///< unit vector, forward
  double travelled = 0.0;      ///< [m] by its farthest corner
  float direction = 0.0F;      ///< [rad] in which it moves
};

/// [rad] in [-pi, pi] by which the vehicle turns between two poses; to the left: positive.
double turn_between(const VehiclePose& v0, const VehiclePose& v1);

/// After a share [0, 1] of the time between them: it turns evenly, and its centre goes along an
/// arc.
VehiclePose pose_between(const VehiclePose& v0, const VehiclePose& v1, double share);

/// [m] by which its body leaves the straight line between two poses, at most: of its centre's arc,
/// and of a corner `body` [m] from the centre.
double bulge_between(const VehiclePose& v0, const VehiclePose& v1, double body);

/// [m] along the arc, and of such a corner.
double way_between(const VehiclePose& v0, const VehiclePose& v1, double body);

/// Into so many pieces the way between two poses is cut, that in each it turns little enough to be
/// taken as straight: at least 1.
int pieces_between(const VehiclePose& v0, const VehiclePose& v1);
/// The same, so that in each a body of which a corner is `body` [m] from the centre may be taken to
/// keep the mean of its axes: to 2 cm.
int pieces_that_keep_axis(const VehiclePose& v0, const VehiclePose& v1, double body);

}  // namespace pedzone
