// Persons whom another program walks: when they are asked about, and when they come back.
#include "sumo/plan/outside_walkers.hpp"

#include <gtest/gtest.h>

namespace pedzone {
namespace {

class OutsideWalkersTest : public testing::Test {
 protected:
  /// Another program walks it from 10 s on.
  void leave(bool declared) { leave_to_others(person_, 10.0, declared); }

  Bystander person_;
};

TEST_F(OutsideWalkersTest, who_is_left_to_others_is_marked_as_theirs) {
  leave(false);
  EXPECT_TRUE(person_.external);
  EXPECT_FALSE(person_.declared);
  leave(true);
  EXPECT_TRUE(person_.declared);
}

TEST_F(OutsideWalkersTest, who_was_noticed_is_asked_about_after_three_seconds_of_standing) {
  leave(false);
  person_.velocity = {0.0, 1.2};
  EXPECT_FALSE(is_to_be_asked(person_, 12.0));
  EXPECT_FALSE(is_to_be_asked(person_, 60.0)) << "it walks all the time";
  person_.velocity = {0.0, 0.0};
  EXPECT_FALSE(is_to_be_asked(person_, 62.9));
  EXPECT_TRUE(is_to_be_asked(person_, 63.0));
}

TEST_F(OutsideWalkersTest, the_slightest_move_begins_the_three_seconds_anew) {
  leave(false);
  EXPECT_FALSE(is_to_be_asked(person_, 12.9));
  person_.velocity = {1e-6, 0.0};
  EXPECT_FALSE(is_to_be_asked(person_, 13.0));
  person_.velocity = {0.0, 0.0};
  EXPECT_FALSE(is_to_be_asked(person_, 15.9));
  EXPECT_TRUE(is_to_be_asked(person_, 16.0));
}

TEST_F(OutsideWalkersTest, who_was_declared_is_asked_about_though_it_walks) {
  leave(true);
  person_.velocity = {0.0, 1.2};
  EXPECT_FALSE(is_to_be_asked(person_, 12.9));
  EXPECT_TRUE(is_to_be_asked(person_, 13.0));
}

TEST_F(OutsideWalkersTest, is_asked_about_twice_a_second) {
  leave(true);
  ASSERT_TRUE(is_to_be_asked(person_, 13.0));
  EXPECT_FALSE(is_to_be_asked(person_, 13.4));
  EXPECT_TRUE(is_to_be_asked(person_, 13.5));
  EXPECT_FALSE(is_to_be_asked(person_, 13.6));
}

TEST_F(OutsideWalkersTest, comes_back_unless_it_is_declared) {
  for (const bool declared : {false, true}) {
    leave(declared);
    EXPECT_FALSE(comes_back(person_, true));
    EXPECT_TRUE(person_.external);
    EXPECT_TRUE(comes_back(person_, false)) << "also one whose declaration was taken back";
    EXPECT_FALSE(person_.external);
  }
}

TEST_F(OutsideWalkersTest, is_put_on_a_lane_only_where_it_stands_and_outside_junctions) {
  EXPECT_TRUE(is_to_be_put_back(person_, "e1"));
  EXPECT_FALSE(is_to_be_put_back(person_, ":e1_w0")) << "on a walking area";
  person_.velocity = {0.0, 0.1};
  EXPECT_FALSE(is_to_be_put_back(person_, "e1"));
}

}  // namespace
}  // namespace pedzone
