// What a crowd costs in memory. Alone in its program, since it counts every allocation.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/random.hpp"
#include "scene.hpp"

namespace {

std::atomic<std::size_t> allocations{0};
std::atomic<long long> held{0};  ///< [bytes] requested and not freed

void* allocate(std::size_t size) {
  // The size is kept in front of the block.
  constexpr std::size_t kHeader = alignof(std::max_align_t);
  void* block = std::malloc(size + kHeader);
  if (block == nullptr) throw std::bad_alloc();
  *static_cast<std::size_t*>(block) = size;
  ++allocations;
  held += static_cast<long long>(size);
  return static_cast<char*>(block) + kHeader;
}

void release(void* pointer) noexcept {
  if (pointer == nullptr) return;
  void* block = static_cast<char*>(pointer) - alignof(std::max_align_t);
  held -= static_cast<long long>(*static_cast<std::size_t*>(block));
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* pointer) noexcept { release(pointer); }
void operator delete[](void* pointer) noexcept { release(pointer); }
void operator delete(void* pointer, std::size_t) noexcept { release(pointer); }
void operator delete[](void* pointer, std::size_t) noexcept { release(pointer); }

namespace pedzone::test {
namespace {

NewPerson somebody(std::uint64_t k, double size) {
  NewPerson person;
  person.key = k + 1;
  person.position = {1.0 + (size - 2.0) * random_uniform(3, k, 1, Purpose::kPlacement),
                     1.0 + (size - 2.0) * random_uniform(3, k, 2, Purpose::kPlacement)};
  person.destination =
      k % 2 == 0 ? line_at_x(size - 0.5, 1, size - 1) : line_at_x(0.5, 1, size - 1);
  person.place_freely = true;
  return person;
}

TEST(Memory, a_step_allocates_nothing_after_the_first_ones) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP()
      << "the thread sanitizer's stand-in for oneTBB (crowd/state/parallel.hpp) makes threads";
#endif
  // One thread: oneTBB's own task memory is not the crowd's.
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const Zone zone = zone_of(box(0, 0, 60, 60), {}, true);
  Crowd crowd(zone, 1);
  for (std::uint64_t k = 0; k < 400; ++k) crowd.add(somebody(k, 60));
  const std::vector<VehicleState> vehicles{vehicle_at({5, 30}, 0.0, 0.3)};
  const std::vector<SeenPerson> seen{{{30, 30}, {0.1, 0}, 0.24}};
  for (int k = 0; k < 50; ++k) {
    crowd.see(seen);
    crowd.step(0.1, vehicles);
  }
  const std::size_t before = allocations;
  for (int k = 0; k < 30; ++k) {
    crowd.see(seen);
    crowd.step(0.1, vehicles);
  }
  EXPECT_EQ(allocations - before, 0u);
}

TEST(Memory, groups_allocate_nothing_either) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "as above";
#endif
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const Zone zone = zone_of(box(0, 0, 30, 30), {}, true);
  Crowd crowd(zone, 1);
  for (std::uint64_t k = 0; k < 80; ++k) {
    NewPerson person = somebody(k, 30);
    person.group = 1 + k / 4;
    crowd.add(person);
  }
  const std::vector<VehicleState> vehicles{vehicle_at({15, 15}, 0.0, 0.5)};
  for (int k = 0; k < 150; ++k) crowd.step(0.1, vehicles);
  const std::size_t before = allocations;
  for (int k = 0; k < 30; ++k) crowd.step(0.1, vehicles);
  EXPECT_EQ(allocations - before, 0u);
}

TEST(Memory, a_person_takes_little_more_than_a_kilobyte) {
  const Zone zone = zone_of(box(0, 0, 110, 110), {}, true);
  constexpr int kPersons = 10000;
  const long long before = held;
  Crowd crowd(zone, 1);
  for (std::uint64_t k = 0; k < kPersons; ++k) {
    NewPerson person = somebody(k, 110);
    person.place_freely = false;
    crowd.add(person);
  }
  for (int k = 0; k < 5; ++k) crowd.step(0.1, {});
  const double each = static_cast<double>(held - before) / kPersons;
  RecordProperty("bytes_per_person", std::to_string(each));
  EXPECT_LT(each, 1250.0);
}

}  // namespace
}  // namespace pedzone::test
