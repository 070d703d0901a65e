// What who crosses a street sees of it.
#pragma once

#include <cstdint>
#include <vector>

#include "crowd/state/state.hpp"

namespace pedzone {

/// Who sees which vehicles, in one substep. Vehicles that stand or are longer than 6 m, and
/// buildings, hide others.
class Lookout {
 public:
  explicit Lookout(const CrowdState& crowd);

  /// Whether row i sees the front or the middle of vehicle v of the crowd's list.
  bool sees(std::size_t i, std::uint32_t v) const;

  /// [m] from s, t to the next lane that row i does not see 30 m along, upstream, on its way to
  /// the left (t grows) or to the right; infinite where it sees them all.
  double room_unseen(std::size_t i, const Street& street, const Vec2& from, bool leftwards) const;

 private:
  bool in_view(std::size_t i, const Vec2& point, std::uint32_t v) const;

  const CrowdState& crowd_;
  std::vector<std::uint32_t> hiding_;
};

}  // namespace pedzone
