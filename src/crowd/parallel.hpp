// The only place where the crowd uses threads: the same work for every block of persons.
#pragma once

#include <algorithm>
#include <cstddef>

#if defined(__SANITIZE_THREAD__)
#include <exception>
#include <thread>
#include <vector>
#else
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#endif

namespace pedzone {

/// Persons in one block. Numerical: a block of some 100 µs of decisions outweighs the cost of
/// handing it to a thread by a factor of ten or more; results do not depend on it. Small under the
/// thread sanitizer, so that small scenes use several threads too.
#if defined(__SANITIZE_THREAD__)
constexpr std::size_t kBlock = 8;
#else
constexpr std::size_t kBlock = 128;
#endif

inline std::size_t block_count(std::size_t persons) { return (persons + kBlock - 1) / kBlock; }

/// Calls work(block, first, last) for the blocks of `persons`, which together cover
/// [0, persons). Blocks may run at once and in any order: `work` writes only what belongs to its
/// own persons. A crowd of one block runs in the calling thread. Of what `work` throws in several
/// blocks, one is thrown on.
template <class Work>
void for_each_block(std::size_t persons, const Work& work) {
  const std::size_t blocks = block_count(persons);
  const auto run = [&](std::size_t block) {
    work(block, block * kBlock, std::min(persons, (block + 1) * kBlock));
  };
  if (blocks <= 1) {
    if (blocks == 1) run(0);
    return;
  }
#if defined(__SANITIZE_THREAD__)
  // Debian's oneTBB is not instrumented, so the thread sanitizer would not see its synchronisation
  // and report races where none are. Plain threads with fixed shares instead: nothing orders one
  // share before another, so a race between two is seen however the threads are scheduled.
  constexpr std::size_t kThreads = 4;
  std::exception_ptr thrown[kThreads];
  const auto share = [&](std::size_t thread) {
    try {
      for (std::size_t block = thread; block < blocks; block += kThreads) run(block);
    } catch (...) {
      thrown[thread] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < kThreads; ++i) threads.emplace_back(share, i);
  share(0);
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
#else
  using Range = oneapi::tbb::blocked_range<std::size_t>;
  oneapi::tbb::parallel_for(Range(0, blocks), [&](const Range& range) {
    for (std::size_t block = range.begin(); block != range.end(); ++block) run(block);
  });
#endif
}

}  // namespace pedzone
