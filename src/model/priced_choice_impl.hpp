// The choice among directions whose costs are dear to know, for one kind of vector. Included by one
// source file for each instruction set (direction_kernel_impl.hpp).
//
// Best first: of all blocks of directions the one with the lowest bound is looked at more closely,
// until it holds a direction that has been tried and no bound is lower. Each look only raises the
// bound, so what is left out cannot be the answer.
#pragma once

#include <algorithm>
#include <cstddef>

#include "model/direction_kernel_impl.hpp"

namespace pedzone {

template <class Float>
struct PricedChoiceImpl {
  using Kernel = KernelImpl<Float>;
  using Directions = typename Kernel::Directions;
  static constexpr std::size_t kLanes = Float::kLanes;
  static constexpr std::size_t kBlocksInGroup = kDirectionGroup / kLanes;

  /// What the bound of a block knows.
  enum class Known : unsigned char { kGoal, kNear, kCost };

  struct Search {
    const DirectionTask& task;
    DirectionTask priced;  ///< the task with the costs asked for
    const DirectionPrices& prices;
    Directions dirs;
    typename Kernel::Blocks blocks;
    Known known[Kernel::Blocks::kMost] = {};
    bool asked[kMaxDirections / kDirectionGroup] = {};
  };

  /// Adds the costs to the bounds of a block.
  static void add_costs(Search& search, std::size_t block, float best_value) {
    const std::size_t k = block * kLanes, group = k / kDirectionGroup;
    float* const lowest = search.blocks.lowest;
    if (!search.asked[group]) {
      search.asked[group] = true;
      const float* const first = lowest + group * kBlocksInGroup;
      search.prices.ask(search.prices.asker, group * kDirectionGroup,
                        best_value - *std::min_element(first, first + kBlocksInGroup));
    }
    const Float bound = Float::load(search.dirs.bound + k) + Float::load(search.prices.cost + k);
    bound.store(search.dirs.bound + k);
    lowest[block] = smallest(bound);
  }

  static void look_closer(Search& search, std::size_t block, DirectionChoice& best) {
    const std::size_t k = block * kLanes;
    switch (search.known[block]) {
      case Known::kGoal:
        search.blocks.lowest[block] = Kernel::look_near(search.task, k, search.dirs);
        search.known[block] = Known::kNear;
        break;
      case Known::kNear:
        add_costs(search, block, best.value);
        search.known[block] = Known::kCost;
        break;
      case Known::kCost:
        Kernel::try_best_of(search.priced, search.dirs, k, search.blocks.lowest[block], best);
        break;
    }
  }

  static DirectionChoice choose(const DirectionTask& task, const DirectionPrices& prices,
                                DirectionChoice known) {
    Search search{task, task, prices, {}, {}};
    search.priced.cost = prices.cost;
    const std::size_t count = task.candidates.padded / kLanes;
    const Float horizon = Float::all(task.horizon);
    for (std::size_t b = 0; b < count; ++b) {
      const Float d = Kernel::weight(task, b * kLanes);
      d.store(search.dirs.weight + b * kLanes);
      search.blocks.lowest[b] = smallest(Kernel::bound_of(task, b * kLanes, horizon, d));
    }
    DirectionChoice best = known;
    best.weight = search.dirs.weight[known.index];
    best.value = known.time * (known.time - best.weight) + prices.cost[known.index];
    for (std::size_t b = search.blocks.best(count); Kernel::hopeful(search.blocks.lowest[b], best);
         b = search.blocks.best(count)) {
      look_closer(search, b, best);
    }
    return best;
  }
};

}  // namespace pedzone
