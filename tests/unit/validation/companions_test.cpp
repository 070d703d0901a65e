// Who is taken for a group in a replay.
#include "validation/companions.hpp"

#include <gtest/gtest.h>

namespace pedzone::test {
namespace {

/// Walks east from there for so many frames.
PersonTrack walks(const Vec2& from, const Vec2& velocity, int first = 0, int frames = 60) {
  PersonTrack track{"", first, {}};
  for (int k = 0; k < frames; ++k) track.places.push_back(from + velocity * (kFrame * k));
  return track;
}

TEST(Companions, walk_within_a_metre_and_a_half_in_one_direction) {
  Clip clip;
  clip.persons = {walks({0, 0}, {1.3, 0}), walks({0, 1.2}, {1.3, 0}), walks({0, 4}, {1.3, 0}),
                  walks({0, 5.6}, {1.3, 0})};
  const auto groups = companions(clip);
  EXPECT_NE(groups[0], 0U);
  EXPECT_EQ(groups[0], groups[1]);
  EXPECT_EQ(groups[2], 0U);  // 1.6 m apart
  EXPECT_EQ(groups[3], 0U);
}

TEST(Companions, are_not_those_who_meet_or_are_near_for_a_while_only) {
  Clip clip;
  clip.persons = {walks({0, 0}, {1.3, 0}), walks({1, 0.5}, {-0.1, 0}), walks({0, -1}, {1.3, -0.5})};
  for (const std::uint64_t group : companions(clip)) EXPECT_EQ(group, 0U);
  // Near all the time that both are there, but that is a third of the longer track.
  clip.persons = {walks({0, 0}, {1.3, 0}), walks({5.2, 1}, {1.3, 0}, 40, 25)};
  for (const std::uint64_t group : companions(clip)) EXPECT_EQ(group, 0U);
}

TEST(Companions, are_pairs_of_the_nearest_and_never_chains) {
  Clip clip;
  for (const double y : {0.0, 1.4, 2.2, 3.6}) clip.persons.push_back(walks({0, y}, {1.3, 0}));
  const auto groups = companions(clip);
  EXPECT_EQ(groups[1], groups[2]);
  EXPECT_NE(groups[1], 0U);
  EXPECT_EQ(groups[0], 0U);
  EXPECT_EQ(groups[3], 0U);
}

}  // namespace
}  // namespace pedzone::test
