// The only place where work is shared out to threads.
#pragma once

#include <algorithm>
#include <cstddef>

#if defined(__SANITIZE_THREAD__)
#include <exception>
#include <thread>
#include <vector>
#else
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

/// Calls work(k) for each k of [0, count), at once and in any order: `work` writes only what
/// belongs to its own k. A single one runs in the calling thread. Of what `work` throws for several
/// k, one is thrown on.
template <class Work>
void for_each_parallel(std::size_t count, const Work& work) {
  if (count <= 1) {
    if (count == 1) work(0);
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
      for (std::size_t k = thread; k < count; k += kThreads) work(k);
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
  oneapi::tbb::parallel_for(std::size_t{0}, count, work);
#endif
}

/// How much work a phase is for each person, which says from how many blocks on it is shared out.
/// Numerical: a thread that is woken and finds nothing to do spins for a while. With 600 persons in
/// a town that took a fifth of the processor's time and saved none. Always shared under the thread
/// sanitizer.
#if defined(__SANITIZE_THREAD__)
enum class Work : std::size_t { kDecision = 1, kLight = 1 };
#else
enum class Work : std::size_t { kDecision = 8, kLight = 64 };
#endif

/// Calls work(block, first, last) for the blocks of `persons`, which together cover
/// [0, persons), as for_each_parallel() does: `work` writes only what belongs to its own persons.
template <class Call>
void for_each_block(std::size_t persons, const Call& work, Work amount = Work::kLight) {
  const auto one = [&](std::size_t block) {
    work(block, block * kBlock, std::min(persons, (block + 1) * kBlock));
  };
  const std::size_t blocks = block_count(persons);
  if (blocks >= static_cast<std::size_t>(amount)) {
    for_each_parallel(blocks, one);
  } else {
    for (std::size_t block = 0; block < blocks; ++block) one(block);
  }
}

}  // namespace pedzone
