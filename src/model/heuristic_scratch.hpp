#pragma once

#include "model/giving_way.hpp"
#include "model/heuristic_model.hpp"
#include "model/making_way.hpp"
#include "model/surroundings.hpp"

namespace pedzone {

/// What one thread needs while it decides; reused from person to person and step to step.
struct HeuristicModel::Scratch {
  Surroundings surroundings;
  MakingWay making_way;
  GivingWay giving_way;
  bool turned = false;  ///< sees people as one who has turned its shoulders
};

}  // namespace pedzone
