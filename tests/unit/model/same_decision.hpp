// Decisions that have to be the same to the bit.
#pragma once

#include <gtest/gtest.h>

#include "model/walking_model.hpp"

namespace pedzone::test {

inline void expect_equal(const Decision& a, const Decision& b, std::size_t person) {
  ASSERT_EQ(a.direction, b.direction) << "person " << person;
  ASSERT_EQ(a.speed, b.speed) << "person " << person;
  ASSERT_EQ(a.free_distance, b.free_distance) << "person " << person;
  ASSERT_EQ(a.waits, b.waits) << "person " << person;
  ASSERT_EQ(a.turns, b.turns) << "person " << person;
}

}  // namespace pedzone::test
