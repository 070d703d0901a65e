// Who walks together in a recording.
#pragma once

#include <cstdint>
#include <vector>

#include "validation/clip.hpp"

namespace pedzone {

/// Group numbers of the clip's persons, 0: alone. Two persons may belong together if
/// - both are recorded at the same time for 2 s or more,
/// - they are within 1.5 m of each other for more than half of the longer of their tracks,
/// - and there they walk in directions less than 45 degrees apart.
/// Groups are pairs. The nearest two (by mean distance) become one first, and nobody is in two
/// pairs. Larger groups are not looked for: in a crowd everybody has a neighbour, and a chain of
/// neighbours is no group.
std::vector<std::uint64_t> companions(const Clip& clip);

}  // namespace pedzone
