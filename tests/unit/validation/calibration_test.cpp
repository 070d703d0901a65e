// What is made small when parameters are fitted, and which of the good points is taken.
#include "validation/calibration.hpp"

#include <gtest/gtest.h>

namespace pedzone::test {
namespace {

ScoredPerson person(std::uint32_t clip, double walked_clearance, double deviation = 0.5) {
  ScoredPerson p;
  p.clip = clip;
  p.recorded.clearance = 2.0;
  p.recorded.deviation = 0.5;
  p.recorded.mean_speed = p.recorded.least_speed = 1.2;
  p.walked = p.recorded;
  p.walked.clearance = walked_clearance;
  p.walked.deviation = deviation;
  return p;
}

std::vector<Clip> two_clips() {
  std::vector<Clip> clips(2);
  clips[0].site = clips[1].site = "site";
  clips[0].manoeuvre = clips[1].manoeuvre = "front";
  return clips;
}

TEST(Misfit, keeps_its_term_of_order_where_one_seed_has_no_crossing) {
  const std::vector<Clip> clips = two_clips();
  ScoredRuns runs(2, {person(0, 2.0)});
  runs[0][0].recorded.passing = runs[1][0].recorded.passing = PassingOrder{true, 1.0};
  const double without = misfit(clips, runs, std::vector<bool>{true, true});
  runs[0][0].walked.passing = PassingOrder{true, 1.0};
  EXPECT_LT(misfit(clips, runs, std::vector<bool>{true, true}), without + 1e-12);
  // Wrong in the one seed that has a crossing: it tells.
  runs[0][0].walked.passing = PassingOrder{false, 1.0};
  EXPECT_GT(misfit(clips, runs, std::vector<bool>{true, true}), without + 1.0);
}

TEST(Misfit, counts_a_clip_as_often_as_it_is_drawn) {
  const std::vector<Clip> clips = two_clips();
  const ScoredRuns runs(1, {person(0, 2.0), person(1, 1.0)});
  const auto of = [&](int first, int second) {
    return misfit(clips, runs, std::vector<int>{first, second});
  };
  EXPECT_EQ(of(1, 1), misfit(clips, runs, std::vector<bool>{true, true}));
  EXPECT_EQ(of(1, 0), misfit(clips, runs, std::vector<bool>{true, false}));
  EXPECT_EQ(of(2, 0), of(1, 0));
  EXPECT_LT(of(1, 0), of(2, 1));
  EXPECT_LT(of(2, 1), of(1, 2));
  EXPECT_LT(of(1, 2), of(0, 1));
}

}  // namespace
}  // namespace pedzone::test
