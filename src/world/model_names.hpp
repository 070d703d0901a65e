// The walking models that a zone may name.
#pragma once

#include <string_view>

namespace pedzone {

/// Names that make_model() knows and that a zone file's `model` attribute may take.
inline constexpr std::string_view kModelNames[] = {"heuristic", "plain"};

}  // namespace pedzone
