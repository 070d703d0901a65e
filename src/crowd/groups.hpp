// Who belongs together, indexed anew in every substep.
#pragma once

#include <cstdint>

namespace pedzone {

/// A person of a group that is still under way.
struct GroupMember {
  std::uint64_t group = 0, key = 0;  ///< what members are sorted by
  std::uint32_t row = 0;
  double left = 0.0;         ///< [m] D: way left to its destination
  bool steps_aside = false;  ///< waits, but is in the way of a member behind it
};

}  // namespace pedzone
