// Whether the walking models that zones name are there.
#pragma once

#include <vector>

#include "zone/zone_file.hpp"

namespace pedzone {

/// The specs themselves. Throws InputError for the first whose model is not known, or is a plug-in
/// that cannot be loaded.
const std::vector<ZoneSpec>& with_models(const std::vector<ZoneSpec>& specs);

}  // namespace pedzone
