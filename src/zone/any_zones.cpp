#include "zone/any_zones.hpp"

#include <algorithm>

#include "zone/selection.hpp"

namespace pedzone {

bool has_shared_space(const Network& network) {
  for (int edge = 0; edge < static_cast<int>(network.edges.size()); ++edge) {
    const int walking = walking_lane(network, edge);
    if (walking >= 0 && is_shared_space(network, walking)) return true;
  }
  return false;
}

std::vector<Zone> build_any_zones(const Network& network, const std::vector<ZoneSpec>& specs) {
  const bool named =
      std::ranges::any_of(specs, [](const ZoneSpec& spec) { return !spec.file.empty(); });
  if (!named && !has_shared_space(network)) return {};
  return build_zones(network, specs);
}

}  // namespace pedzone
