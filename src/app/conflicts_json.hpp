// What `pedzone conflicts --json` prints.
#pragma once

#include <string>
#include <vector>

#include "conflict/conflict.hpp"

namespace pedzone {

/// Each with the measures and reactions that it has, by their names in the other files.
std::string conflicts_json(const std::vector<Conflict>& conflicts);

}  // namespace pedzone
