// What the summary says of all persons that pedzone walked.
#include "sumo/plan/walk_totals.hpp"

#include <gtest/gtest.h>

namespace pedzone {
namespace {

TEST(WalkTotals, count_each_person_once_and_each_takeover) {
  WalkTotals totals;
  PersonPast ann, bob;
  totals.take_over(ann, false);
  totals.give_back(ann, false);
  totals.take_over(ann, false);
  totals.take_over(bob, false);
  EXPECT_EQ(totals.controlled, 2);
  EXPECT_EQ(totals.takeovers, 3);
  EXPECT_EQ(totals.returns, 1);
}

TEST(WalkTotals, do_not_count_who_goes_on_with_another_plan_again) {
  WalkTotals totals;
  PersonPast ann;
  totals.take_over(ann, false);
  totals.take_over(ann, true);
  EXPECT_EQ(totals.controlled, 1);
  EXPECT_EQ(totals.takeovers, 1);
}

TEST(WalkTotals, count_each_return_and_each_person_that_returned_once) {
  WalkTotals totals;
  PersonPast ann, bob;
  totals.give_back(ann, false);
  totals.give_back(ann, false);
  totals.give_back(bob, true);
  EXPECT_EQ(totals.given_back, 2);
  EXPECT_EQ(totals.returns, 3);
  EXPECT_EQ(totals.ended, 1);
}

TEST(WalkTotals, sum_distance_and_seconds_and_what_it_would_take_freely) {
  WalkTotals totals;
  PersonView view{};
  view.position = {3.0, 4.0};
  view.motion = Motion::kWalking;
  totals.walk({0.0, 0.0}, view, 2.0, 4.0);
  EXPECT_EQ(totals.distance, 5.0);
  EXPECT_EQ(totals.time, 4.0);
  EXPECT_EQ(totals.free_time, 2.5);
  EXPECT_EQ(totals.waiting, 0.0);
  view.motion = Motion::kWaiting;
  totals.walk(view.position, view, 2.0, 0.5);
  EXPECT_EQ(totals.distance, 5.0);
  EXPECT_EQ(totals.waiting, 0.5);
}

TEST(WalkTotals, have_no_free_time_of_who_cannot_walk) {
  WalkTotals totals;
  PersonView view{};
  view.position = {1.0, 0.0};
  totals.walk({0.0, 0.0}, view, 0.0, 1.0);
  EXPECT_EQ(totals.free_time, 0.0);
}

}  // namespace
}  // namespace pedzone
