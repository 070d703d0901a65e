#include "crowd/behaviour/pace.hpp"

#include <algorithm>

#include "crowd/state/parallel.hpp"

namespace pedzone {

void set_paces(const CrowdState& crowd, std::vector<double>& preferred_speed) {
  for_each_block(crowd.persons.walking, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const WalkState& walker = crowd.walkers[i];
      const ActivityMemory& memory = crowd.activities[walker.handle];
      const double share = info_of(memory.activity).speed;
      preferred_speed[i] =
          walker.own_speed * crowd.zone.weather->speed * (share > 0.0 ? share : 1.0);
      if (const StreetCrossing* crossing = crowd.crossing(i)) {
        preferred_speed[i] = std::min(preferred_speed[i] * crossing->hurry, kMostSpeed);
      }
      if (memory.dash > 0.0) preferred_speed[i] = walker.profile->top_speed;
    }
  });
}

}  // namespace pedzone
