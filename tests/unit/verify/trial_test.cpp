#include "verify/trial.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "verify/standard_test.hpp"

namespace pedzone::verify {
namespace {

double least_gap(const std::vector<Vec2>& places) {
  double least = 1e9;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(least, (places[i] - places[j]).norm());
    }
  }
  return least;
}

TEST(Places, never_overlap_and_stay_off_the_walls) {
  for (const std::size_t count : {1, 2, 7, 60, 164, 208}) {
    const std::vector<Vec2> places = places_in({0, 0}, {26, 2}, count, 5);
    ASSERT_EQ(places.size(), count);
    EXPECT_GE(least_gap(places), 2.0 * kBodyRadius - 1e-9) << count;
    for (const Vec2& place : places) {
      EXPECT_GE(place.y(), kBodyRadius - 1e-9);
      EXPECT_LE(place.y(), 2.0 - kBodyRadius + 1e-9);
      EXPECT_GE(place.x(), 0.0);
      EXPECT_LE(place.x(), 26.0);
    }
  }
}

TEST(Places, keep_apart_over_the_end_of_a_period) {
  std::vector<Vec2> places = places_in({0, 0}, {26, 1.8}, 164, 2);
  for (std::size_t i = 0, count = places.size(); i < count; ++i) {
    places.emplace_back(places[i] + Vec2(26.0, 0.0));
  }
  EXPECT_GE(least_gap(places), 2.0 * kBodyRadius - 1e-9);
}

TEST(Places, depend_on_the_seed_alone) {
  EXPECT_EQ(places_in({0, 0}, {9, 3}, 20, 4), places_in({0, 0}, {9, 3}, 20, 4));
  EXPECT_NE(places_in({0, 0}, {9, 3}, 20, 4), places_in({0, 0}, {9, 3}, 20, 5));
}

TEST(Places, refuse_bodies_that_do_not_fit) {
  EXPECT_THROW(places_in({0, 0}, {10, 2}, 200, 1), std::invalid_argument);
}

TEST(DrawnSpeed, is_weidmanns_distribution) {
  constexpr int kPeople = 20000;
  double sum = 0.0, squares = 0.0;
  for (int k = 1; k <= kPeople; ++k) {
    const double speed = drawn_speed(7, static_cast<std::uint64_t>(k));
    EXPECT_GE(speed, 0.5);
    EXPECT_LE(speed, 2.2);
    sum += speed;
    squares += speed * speed;
  }
  const double mean = sum / kPeople;
  // Four standard errors; the limits are more than three deviations off and hardly matter.
  EXPECT_NEAR(mean, kMeanSpeed, 0.008);
  EXPECT_NEAR(std::sqrt(squares / kPeople - mean * mean), kSpeedSpread, 0.008);
}

TEST(StandardTests, have_ids_of_their_own_limits_with_a_source_and_a_drawing) {
  std::set<std::string> ids;
  for (const StandardTest& test : standard_tests()) {
    EXPECT_TRUE(ids.insert(test.id).second) << test.id;
    EXPECT_FALSE(test.drawing.walkable.empty()) << test.id;
    EXPECT_FALSE(test.source.empty()) << test.id;
    bool judged = false;
    for (const FigureSpec& figure : test.figures) {
      const bool limited = figure.least || figure.most;
      EXPECT_EQ(limited, figure.judged != Judged::kNot) << test.id << " " << figure.key;
      EXPECT_TRUE(!limited || !figure.limit_source.empty()) << test.id << " " << figure.key;
      judged = judged || limited;
    }
    EXPECT_TRUE(judged) << test.id;
  }
  EXPECT_GE(ids.size(), 20U);
}

}  // namespace
}  // namespace pedzone::verify
