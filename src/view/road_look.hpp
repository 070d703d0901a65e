// How pictures show the lanes that no zone has.
#pragma once

#include "zone/network.hpp"

namespace pedzone {

enum class RoadLook {
  kHidden,    ///< inside a junction, whose shape shows it
  kRoad,      ///< a line
  kFootway,   ///< a line
  kCrossing,  ///< a line
  kFootArea,  ///< an outline: a walking area
};

RoadLook look_of(const Network& network, const Lane& lane);

}  // namespace pedzone
