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

struct ModelEntry {
  std::string_view name;
  std::unique_ptr<WalkingModel> (*make)();
};

constexpr ModelEntry kModels[] = {
    {"heuristic", make<HeuristicModel>},
    {"heuristic-original", make<OriginalHeuristicModel>},
    {"plain", make<PlainHeuristicModel>},
    {"social-force", make<SocialForceModel>},
    {"gradient-navigation", make<GradientNavigationModel>},
    {"optimal-steps", make<OptimalStepsModel>},
    {"orca", make<OrcaModel>},
    {"constant-velocity", make<ConstantVelocityModel>},
};

}  // namespace

std::unique_ptr<WalkingModel> make_model(const std::string& name) {
  if (names_plugin(name)) return load_plugin(name);
  const auto found = std::ranges::find(kModels, name, &ModelEntry::name);
  if (found != std::end(kModels)) return found->make();
  throw ModelError(name, "is not known", allowed_models());
}

}  // namespace pedzone
