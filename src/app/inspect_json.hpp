// What `pedzone inspect --json` prints.
#pragma once

#include <string>
#include <vector>

#include "zone/zone.hpp"

namespace pedzone {

/// The same as zone_report(), for programs.
std::string inspect_json(const Network& network, const std::vector<Zone>& zones);

}  // namespace pedzone
