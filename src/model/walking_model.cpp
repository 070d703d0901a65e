#include "model/walking_model.hpp"

#include <algorithm>

#include "model/constant_velocity.hpp"
#include "model/gradient_navigation.hpp"
#include "model/heuristic_model.hpp"
#include "model/optimal_steps.hpp"
#include "model/orca.hpp"
#include "model/plugin.hpp"
#include "model/social_force.hpp"
#include "world/model_names.hpp"

namespace pedzone {
namespace {

template <class Model>
std::unique_ptr<WalkingModel> make() {
  return std::make_unique<Model>();
}

using Maker = std::unique_ptr<WalkingModel> (*)();

struct ModelEntry {
  std::string_view name;
  Maker make;
};

constexpr ModelEntry kModels[] = {
    {"heuristic", make<HeuristicModel>},
    {"heuristic-original", make<OriginalHeuristicModel>},
    {"plain", make<PlainHeuristicModel>},
    {"orca", make<OrcaModel>},
    {"social-force", make<SocialForceModel>},
    {"gradient-navigation", make<GradientNavigationModel>},
    {"optimal-steps", make<OptimalStepsModel>},
    {"constant-velocity", make<ConstantVelocityModel>},
};
static_assert(std::ranges::equal(kModels, kModelNames, {}, &ModelEntry::name),
              "the same models in the same order as in world/model_names.hpp");

/// Throws ModelError where there is no such model.
Maker maker_of(const std::string& name) {
  const auto found = std::ranges::find(kModels, name, &ModelEntry::name);
  if (found == std::end(kModels)) throw ModelError(name, "is not known", allowed_models());
  return found->make;
}

}  // namespace

std::unique_ptr<WalkingModel> make_model(const std::string& name) {
  return names_plugin(name) ? load_plugin(name) : maker_of(name)();
}

void check_model(const std::string& name) {
  if (names_plugin(name)) {
    (void)load_plugin(name);
  } else {
    (void)maker_of(name);
  }
}

}  // namespace pedzone
