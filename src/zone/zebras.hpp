// Crossings at which vehicles give way to people.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "zone/network.hpp"

namespace pedzone {

/// A zebra crossing: from kerb to kerb.
struct Zebra {
  Vec2 begin = Vec2::Zero(), end = Vec2::Zero();  ///< [m] middle of the crossing at either kerb
  double width = 4.0;                             ///< [m]
};

/// Those of the lanes that are crossings with priority, in their order.
std::vector<Zebra> find_zebras(const Network& network, std::span<const int> lanes);

/// The zebra crossing on which somebody at `here` [m] who heads for `aim` [m] is, or that it is
/// about to enter: it looks across at the kerb. It begins where that person comes from. Nothing:
/// none.
std::optional<Zebra> zebra_of(std::span<const Zebra> zebras, const Vec2& here, const Vec2& aim);

}  // namespace pedzone
