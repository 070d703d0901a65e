// A recorded clip walked again: the vehicle as it was, the people by a model.
#pragma once

#include <cstdint>
#include <vector>

#include "crowd/crowd.hpp"
#include "validation/clip.hpp"

namespace pedzone {

/// How people walk in a replay.
struct ReplayModel {
  enum class Kind { kModel, kStraight, kConstantVelocity };
  std::string name;  ///< for tables
  Kind kind = Kind::kModel;
  std::string model = "heuristic";  ///< of make_model()
  Parameters parameters;
};

/// The ways of all persons of the clip, in its order, one place for each recorded frame: in their
/// first second they follow the recording, then they walk to their last recorded place with the
/// speed of that second, varied by 3 % (of `seed`; straight and constant-velocity ways too).
/// Who walks together in the recording (companions.hpp) is a group here, too.
/// People walk in open space through Crowd::step, the vehicles follow the recording. Seed 0: no
/// variation of speeds.
std::vector<Polyline> replay(const Clip& clip, const ReplayModel& model, std::uint64_t seed);

}  // namespace pedzone
