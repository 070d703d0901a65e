// Deliberate faults, one a run, to prove that this build's sanitizer sees them: a sanitizer that
// reports nothing may be one that is blind.
#include <cstdio>
#include <cstring>
#include <limits>
#include <vector>

#include "crowd/state/parallel.hpp"

namespace {

/// Reads past the end of an array.
int read_outside(int n) {
  const std::vector<int> values(static_cast<std::size_t>(n), 1);
  const int* data = values.data();
  return data[n];
}

/// Overflows a signed integer.
int overflow(int n) { return std::numeric_limits<int>::max() - 1 + n; }

/// Persons' blocks that all count in one place, as a step that forgets that blocks run at once.
long race(int n) {
  long steps = 0;
  pedzone::for_each_block(static_cast<std::size_t>(n) * 4 * pedzone::kBlock,
                          [&](std::size_t, std::size_t first, std::size_t last) {
                            for (std::size_t i = first; i < last; ++i) ++steps;
                          });
  return steps;
}

/// The same work done right: each block writes its own persons only.
long no_race(int n) {
  std::vector<long> steps(static_cast<std::size_t>(n) * 4 * pedzone::kBlock, 0);
  for (int round = 0; round < 50; ++round) {
    pedzone::for_each_block(steps.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) ++steps[i];
    });
    for (long& step : steps) step *= 2;
  }
  return steps.front();
}

}  // namespace

int main(int argc, char** argv) {
  const char* fault = argc > 1 ? argv[1] : "";
  // The number of arguments is unknown to the compiler, so that it cannot foresee the fault.
  const int n = argc * 8;
  if (std::strcmp(fault, "address") == 0) return std::printf("%d\n", read_outside(n)) < 0;
  if (std::strcmp(fault, "undefined") == 0) return std::printf("%d\n", overflow(n)) < 0;
  if (std::strcmp(fault, "thread") == 0) return std::printf("%ld\n", race(n)) < 0;
  if (std::strcmp(fault, "none") == 0) return std::printf("%ld\n", no_race(n)) < 0;
  std::fprintf(stderr, "usage: faults address|undefined|thread|none\n");
  return 2;
}
