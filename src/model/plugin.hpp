// Walking models of users: one class in a shared library of its own, loaded by its path.
//
//   #include "model/perceiving_model.hpp"
//   #include "model/plugin.hpp"
//   class Mine : public pedzone::PerceivingModel { ... };
//   PEDZONE_WALKING_MODEL(Mine)
//
// built with find_package(pedzone), add_library(mine MODULE mine.cpp) and
// target_link_libraries(mine PRIVATE pedzone::model); tests/package/plugin is a worked example.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "model/walking_model.hpp"

namespace pedzone {

/// Version of WalkingModel, Snapshot and what they hold: to be raised with every change of meaning.
inline constexpr std::uint32_t kModelInterface = 3;

/// What changes where somebody changes them and forgets to raise it.
inline constexpr std::uint32_t kModelLayout = static_cast<std::uint32_t>(
    sizeof(Snapshot) + 31 * sizeof(Persons) + 31 * 31 * sizeof(Parameters) +
    37 * sizeof(VehicleState) + 41 * sizeof(Attention) + 43 * sizeof(WallIndex) +
    47 * sizeof(Decision));

/// What a plug-in exports as `pedzone_walking_model`. The first two members stay for ever.
struct PluginEntry {
  std::uint32_t interface, layout;
  WalkingModel* (*make)();
};

/// Loads the shared library at that path (from the folder of the process where it is not absolute)
/// for good and makes its model. Whatever that throws later becomes an InputError that names the
/// library, as does a decision outside of Decision's ranges. Throws ModelError where the file is
/// missing, no library, has no model or one of another interface, or its constructor throws.
std::unique_ptr<WalkingModel> load_plugin(const std::string& path);

}  // namespace pedzone

/// Makes the class (derived from pedzone::WalkingModel, default-constructible) the plug-in's model.
#define PEDZONE_WALKING_MODEL(Class)                                                      \
  extern "C" {                                                                            \
  [[gnu::visibility("default")]] extern const pedzone::PluginEntry pedzone_walking_model; \
  const pedzone::PluginEntry pedzone_walking_model = {                                    \
      pedzone::kModelInterface, pedzone::kModelLayout,                                    \
      []() -> pedzone::WalkingModel* { return new Class; }};                              \
  }
