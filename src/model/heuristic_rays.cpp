// f(α) of all candidate directions, for pictures: the same lists and the same kernel as deciding,
// one direction after the other.
#include <algorithm>
#include <limits>

#include "core/vec.hpp"
#include "model/heuristic_scratch.hpp"
#include "model/trigonometry.hpp"

namespace pedzone {

void HeuristicModel::rays(std::size_t person, std::vector<Ray>& out) const {
  out.clear();
  const Walker self = scenery_.walker(person);
  Scratch scratch;
  DirectionTask task = look_around(person, self, scratch.surroundings);
  // As it sees others once it has turned its shoulders, where it does.
  choose(person, self, wrapped(snapshot_.persons->goal_direction[person] - self.heading), task,
         scratch);
  // The kernel tells the time until contact of the best direction only: let there be just one.
  std::vector<float> cost(candidates_.padded(), std::numeric_limits<float>::infinity());
  task.cost = cost.data();
  DirectionChoice none;
  none.index = kNoDirection;
  for (std::size_t k = 0; k < candidates_.padded(); ++k) {
    if (candidates_.excluded()[k] > 0.0F) continue;
    cost[k] = 0.0F;
    const std::size_t group = k / kDirectionGroup * kDirectionGroup;
    const DirectionChoice only = kernel_.choose(task, group, kDirectionGroup, none);
    cost[k] = std::numeric_limits<float>::infinity();
    out.push_back({wrap_angle(self.heading + candidates_.offset(k)),
                   std::min(static_cast<double>(only.time) * static_cast<double>(self.speed),
                            snapshot_.parameters->sight)});
  }
  // Once round, counter-clockwise from behind.
  std::ranges::sort(out, {},
                    [&](const Ray& ray) { return wrap_angle(ray.direction - self.heading); });
}

}  // namespace pedzone
