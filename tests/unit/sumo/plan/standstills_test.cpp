// Who has not got on for a minute: everybody who has stayed within half a metre and does not want
// to.
#include "sumo/plan/standstills.hpp"

#include <gmock/gmock.h>

namespace pedzone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class StandstillsTest : public testing::Test {
 protected:
  /// Looks at everybody at `time` [s]; a place is so far [m] east.
  std::vector<std::string> look(double time, const std::vector<std::pair<std::string, double>>& all,
                                const std::string& resting = "") {
    std::vector<Standstills::Present> present;
    for (const auto& [id, east] : all) present.push_back({id, {east, 0.0}});
    standstills_.update(time, present, [&](const std::string& id) {
      asked_.push_back(id);
      return id == resting;
    });
    std::vector<std::string> found;
    for (const Standstill& one : standstills_.all()) found.push_back(one.id);
    return found;
  }

  Standstills standstills_;
  std::vector<std::string> asked_;  ///< whether they rest
};

TEST_F(StandstillsTest, are_of_who_has_not_moved_for_a_minute) {
  EXPECT_THAT(look(5.0, {{"a", 0.0}}), IsEmpty());
  EXPECT_THAT(look(64.9, {{"a", 0.0}}), IsEmpty());
  EXPECT_THAT(look(65.0, {{"a", 0.0}}), ElementsAre("a"));
  EXPECT_EQ(standstills_.all()[0].since, 5.0);
}

TEST_F(StandstillsTest, are_not_of_who_has_moved_by_two_steps) {
  look(0.0, {{"stays", 0.0}, {"goes", 0.0}});
  look(30.0, {{"stays", 1.5}, {"goes", 1.51}});
  EXPECT_THAT(look(60.0, {{"stays", 1.5}, {"goes", 1.51}}), ElementsAre("stays"));
  EXPECT_THAT(look(90.0, {{"stays", 1.5}, {"goes", 1.51}}), ElementsAre("stays", "goes"));
}

TEST_F(StandstillsTest, count_the_way_from_the_first_place_and_not_between_looks) {
  look(0.0, {{"crawls", 0.0}});
  for (int k = 1; k < 12; ++k) EXPECT_THAT(look(5.0 * k, {{"crawls", 0.3 * k}}), IsEmpty());
  EXPECT_THAT(look(60.0, {{"crawls", 3.6}}), IsEmpty());
}

TEST_F(StandstillsTest, end_when_somebody_gets_on) {
  look(0.0, {{"a", 0.0}});
  ASSERT_THAT(look(60.0, {{"a", 0.0}}), ElementsAre("a"));
  EXPECT_THAT(look(65.0, {{"a", 1.6}}), IsEmpty());
  EXPECT_THAT(look(124.9, {{"a", 1.6}}), IsEmpty());
  EXPECT_THAT(look(125.0, {{"a", 1.6}}), ElementsAre("a"));
}

TEST_F(StandstillsTest, are_not_of_who_rests_and_begin_when_it_no_longer_does) {
  look(0.0, {{"sits", 0.0}});
  EXPECT_THAT(look(60.0, {{"sits", 0.0}}, "sits"), IsEmpty());
  EXPECT_THAT(look(119.9, {{"sits", 0.0}}), IsEmpty());
  EXPECT_THAT(look(120.0, {{"sits", 0.0}}), ElementsAre("sits"));
}

TEST_F(StandstillsTest, ask_only_of_those_who_have_not_moved_whether_they_rest) {
  look(0.0, {{"stays", 0.0}, {"goes", 0.0}});
  look(5.0, {{"stays", 0.0}, {"goes", 1.6}, {"new", 0.0}});
  EXPECT_THAT(asked_, ElementsAre("stays"));
}

TEST_F(StandstillsTest, begin_anew_for_who_was_away) {
  look(0.0, {{"a", 0.0}});
  look(30.0, {});
  look(35.0, {{"a", 0.0}});
  EXPECT_THAT(look(60.0, {{"a", 0.0}}), IsEmpty());
  EXPECT_THAT(look(95.0, {{"a", 0.0}}), ElementsAre("a"));
  EXPECT_EQ(standstills_.all()[0].since, 35.0);
}

TEST_F(StandstillsTest, name_the_longest_first_and_then_by_id) {
  look(0.0, {{"z", 0.0}});
  look(1.0, {{"z", 0.0}, {"b", 3.0}, {"a", 4.0}});
  EXPECT_THAT(look(70.0, {{"a", 4.0}, {"b", 3.0}, {"z", 0.0}}), ElementsAre("z", "a", "b"));
  EXPECT_EQ(standstills_.all()[1].position, Vec2(4.0, 0.0));
}

TEST_F(StandstillsTest, name_ten) {
  std::vector<std::pair<std::string, double>> all;
  for (char id = 'a'; id <= 'c'; ++id) all.emplace_back(std::string(1, id), 0.0);
  look(0.0, all);
  look(60.0, all);
  EXPECT_EQ(standstills_.named().size(), 3U);
  for (char id = 'd'; id <= 'z'; ++id) all.emplace_back(std::string(1, id), 0.0);
  look(60.0, all);
  EXPECT_EQ(look(120.0, all).size(), 26U);
  ASSERT_EQ(standstills_.named().size(), 10U);
  standstills_.named()[0].where = "in zone 'plaza'";
  EXPECT_EQ(standstills_.all()[0].where, "in zone 'plaza'");
}

TEST_F(StandstillsTest, know_how_many_they_were_at_most_and_when_first) {
  EXPECT_EQ(standstills_.most(), 0U);
  look(0.0, {{"a", 0.0}, {"b", 1.0}});
  look(60.0, {{"a", 0.0}, {"b", 1.0}});
  look(65.0, {{"a", 0.0}, {"b", 1.0}});
  look(70.0, {{"a", 9.0}, {"b", 1.0}});
  EXPECT_EQ(standstills_.most(), 2U);
  EXPECT_EQ(standstills_.most_at(), 60.0);
  EXPECT_EQ(standstills_.all().size(), 1U);
}

TEST(AtRest, is_who_sits_or_chats_and_not_who_is_held_up) {
  EXPECT_TRUE(is_at_rest(Activity::kSitting));
  EXPECT_TRUE(is_at_rest(Activity::kChatting));
  EXPECT_FALSE(is_at_rest(Activity::kNone));
  EXPECT_FALSE(is_at_rest(Activity::kTexting)) << "walks while it does";
}

}  // namespace
}  // namespace pedzone
