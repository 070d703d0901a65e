// What `pedzone conflicts --json` prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/seen_crossings.hpp"
#include "conflict/conflict.hpp"

namespace pedzone {

/// Each with the measures and reactions that it has, by their names in the other files; and what
/// was seen of crossings, where a street was watched.
std::string conflicts_json(const std::vector<Conflict>& conflicts,
                           const std::optional<CrossingNumbers>& crossings);

}  // namespace pedzone
