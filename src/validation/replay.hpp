// A recorded clip walked again: the vehicle as it was, the people by a model.
#pragma once

#include <cstdint>
#include <vector>

#include "crowd/push_log.hpp"
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

/// A clip walked again: of all its persons, in its order.
struct Replayed {
  std::vector<Polyline> ways;  ///< [m] one place for each recorded frame
  /// [m] The same from a replay that keeps nobody out of vehicles: what the model does by itself.
  /// Equal to `ways` where nobody had to be kept out.
  std::vector<Polyline> unpushed;
  /// What vehicles that drive did to each. Empty where no crowd walks: straight and
  /// constant-velocity ways run through vehicles.
  std::vector<PushedPerson> pushes;
};

/// In their first second people follow the recording, then they walk to their last recorded place
/// with the speed of that second, varied by 3 % (of `seed`; straight and constant-velocity ways
/// too). Who walks together in the recording (companions.hpp) is a group here, too. People walk in
/// open space through Crowd::step. The vehicles follow the recording, whomever they run into.
/// Seed 0: no variation of speeds.
Replayed replay(const Clip& clip, const ReplayModel& model, std::uint64_t seed);

}  // namespace pedzone
