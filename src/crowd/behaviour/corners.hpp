// How far from a corner people pass it when others are there, too.
#pragma once

#include "crowd/state/state.hpp"

namespace pedzone {

/// [m] from the corner that row i heads for to where it should head for instead, on the outside of
/// the bend. Zero where nobody else is near, and beyond it. To be called after the contacts of a
/// substep.
///
/// All ways round a corner lead by its inside, and the crowd would meet in that one point while
/// the rest of the width stays empty. So each takes the part of the way across that the people
/// there need, those who turn left beyond those who come towards them, as right-hand traffic does:
///
///            | after
///            |
///     corner .===========.....  outer wall
///            [a][ opposed ]
///   ------>
Vec2 beside_corner(const CrowdState& crowd, std::size_t i);

}  // namespace pedzone
