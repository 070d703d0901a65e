// Who walks together in a recording.
#pragma once

#include <cstdint>
#include <vector>

#include "validation/clip.hpp"

namespace pedzone {

/// Group numbers of the clip's persons, 0: alone. Two belong together who are recorded for 2 s or
/// more at once and within 1.5 m of each other for more than half of the longer of their tracks,
/// and walk there in directions less than 45 degrees apart. A person belongs to the one whom it is
/// nearest to (mean distance) and who is not nearer to somebody else: pairs, since in a crowd
/// everybody has a neighbour, and a chain of neighbours is no group.
std::vector<std::uint64_t> companions(const Clip& clip);

}  // namespace pedzone
