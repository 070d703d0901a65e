// When SUMO's plan for a person is read again, and what follows from it.
#include "sumo/plan/replanning.hpp"

#include <gtest/gtest.h>

namespace pedzone {
namespace {

constexpr std::size_t kPlan = 7, kOther = 8;

class ReplanningTest : public testing::Test {
 protected:
  ReplanningTest() { note_look(watch_, 20.0, 3); }

  /// SUMO has it so far [m] from where it was told to.
  GuestFinding find(std::size_t plan, double away) {
    return what_happened(watch_, plan, {5.0, 1.0}, [&] {
      ++asked_;
      return Vec2(5.0 + away, 1.0);
    });
  }

  PlanWatch watch_{.plan = kPlan};
  int asked_ = 0;  ///< times that SUMO was asked for the place
};

TEST_F(ReplanningTest, looks_at_who_is_new_at_once) { EXPECT_TRUE(is_due({}, 0.0, 0)); }

TEST_F(ReplanningTest, looks_twice_a_second) {
  EXPECT_FALSE(is_due(watch_, 20.4, 3));
  EXPECT_TRUE(is_due(watch_, 20.5, 3));
  note_look(watch_, 20.5, 3);
  EXPECT_FALSE(is_due(watch_, 20.9, 3));
}

TEST_F(ReplanningTest, looks_more_seldom_where_no_program_is_about) {
  note_look(watch_, 21.0, 3, kPlanIntervalAlone);
  EXPECT_FALSE(is_due(watch_, 25.9, 3));
  EXPECT_TRUE(is_due(watch_, 26.0, 3));
}

TEST_F(ReplanningTest, looks_at_once_when_the_number_of_stages_has_changed) {
  EXPECT_TRUE(is_due(watch_, 20.1, 2));
  EXPECT_TRUE(is_due(watch_, 20.1, 4));
  note_look(watch_, 20.1, 4);
  EXPECT_FALSE(is_due(watch_, 20.2, 4));
}

TEST_F(ReplanningTest, finds_nothing_where_plan_and_place_are_as_told) {
  EXPECT_EQ(find(kPlan, 0.0), GuestFinding::kUnchanged);
  EXPECT_EQ(find(kPlan, 0.009), GuestFinding::kUnchanged) << "rounding over TraCI";
}

TEST_F(ReplanningTest, who_is_elsewhere_with_the_same_plan_was_moved_by_another_program) {
  EXPECT_EQ(find(kPlan, 0.011), GuestFinding::kMoved);
}

TEST_F(ReplanningTest, who_has_another_plan_is_replanned_wherever_it_is) {
  EXPECT_EQ(find(kOther, 0.0), GuestFinding::kReplanned);
  EXPECT_EQ(find(kOther, 4.0), GuestFinding::kReplanned) << "SUMO has moved it itself";
  EXPECT_EQ(asked_, 0) << "that costs a message";
}

TEST_F(ReplanningTest, gives_nobody_back_whose_plan_has_changed_before_it_is_looked_at) {
  EXPECT_TRUE(is_plan_sure(watch_, kPlan));
  EXPECT_FALSE(is_plan_sure(watch_, kOther));
  EXPECT_TRUE(is_due(watch_, 20.1, 3));
  EXPECT_FALSE(is_plan_sure(watch_, kPlan)) << "not looked at yet";
  note_look(watch_, 20.1, 3);
  EXPECT_TRUE(is_plan_sure(watch_, kPlan));
}

TEST_F(ReplanningTest, gives_nobody_back_at_whom_nobody_has_looked) {
  PlanWatch fresh{.plan = kPlan};
  EXPECT_FALSE(is_plan_sure(fresh, kPlan));
}

TEST_F(ReplanningTest, with_a_new_plan_only_who_walked_it_is_remembered) {
  for (const bool given_back : {false, true}) {
    const PersonPast now =
        with_new_plan({.plan = kPlan, .last = 2, .refused_edge = 1, .was_given_back = given_back});
    EXPECT_EQ(now.plan, 0U);
    EXPECT_EQ(now.last, -1) << "no edge of the new route was walked yet";
    EXPECT_EQ(now.refused_edge, -1) << "every edge is asked again";
    EXPECT_TRUE(now.was_controlled);
    EXPECT_EQ(now.was_given_back, given_back);
  }
}

}  // namespace
}  // namespace pedzone
