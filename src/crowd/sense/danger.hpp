// Where vehicles are about to drive, for those who would stand there for somebody else's sake.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// Whether the vehicle drives (kDrivingSpeed).
bool drives(const VehicleState& vehicle);

/// Whether a vehicle claims a place within `margin` [m] of the body of row i.
bool is_claimed(const CrowdState& crowd, std::size_t i, double margin);

/// Whether a vehicle that drives comes within `margin` [m] of the body of row i in the next `time`
/// [s], the body staying where it is.
bool is_swept(const CrowdState& crowd, std::size_t i, double margin, double time);

/// Whether row i may stand where it is for somebody else's sake: no vehicle claims the place or
/// comes there soon.
bool may_stand(const CrowdState& crowd, std::size_t i);

/// The nearest of the vehicles that drive and are, or within `time` [s] will be, nearer than
/// `reach` [m] to the point; null: none.
const VehicleState* moving_near(const CrowdState& crowd, const Vec2& point, double reach,
                                double time);

}  // namespace pedzone
