// The walking models that a zone or the command line may name.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "core/text.hpp"

namespace pedzone {

/// Names that make_model() knows.
inline constexpr std::string_view kModelNames[] = {
    "heuristic",    "heuristic-original",  "plain",         "orca",
    "social-force", "gradient-navigation", "optimal-steps", "constant-velocity"};

/// How the path of a plug-in ends (model/plugin.hpp).
inline constexpr std::string_view kPluginEnding = ".so";

/// Whether the name is the path of a plug-in.
inline bool names_plugin(std::string_view name) { return name.ends_with(kPluginEnding); }

/// Whether a zone may name it: one of the models above or the path of a plug-in.
inline bool may_be_model(std::string_view name) {
  return names_plugin(name) || std::ranges::find(kModelNames, name) != std::end(kModelNames);
}

/// What may_be_model() allows, for messages.
inline std::string allowed_models() {
  return comma_list(kModelNames) + ", or the path of a plug-in (*" + std::string(kPluginEnding) +
         ")";
}

}  // namespace pedzone
