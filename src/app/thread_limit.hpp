// How many threads a command uses.
#pragma once

#include <tbb/global_control.h>

#include <algorithm>
#include <thread>

namespace pedzone {

/// While it lives, at most `threads` work; 0: as many as there are cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads)
      : control_(tbb::global_control::max_allowed_parallelism, count(threads)) {}

 private:
  static std::size_t count(int threads) {
    const int wanted =
        threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    return static_cast<std::size_t>(std::max(1, wanted));
  }

  tbb::global_control control_;
};

}  // namespace pedzone
