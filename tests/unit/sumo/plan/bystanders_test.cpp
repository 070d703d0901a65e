// The persons whom SUMO walks: who is looked at, who is near, who is seen.
#include "sumo/plan/bystanders.hpp"

#include <gmock/gmock.h>

#include "four_edges.hpp"

namespace pedzone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

class BystandersTest : public testing::Test, protected test::FourEdges {
 protected:
  BystandersTest() { zone.parameters.sight = 10.0; }

  Bystander& person(const std::string& id) {
    return *std::ranges::find(bystanders_->all(), id, &Bystander::id);
  }

  /// Everybody is at these places [m].
  void stand(const std::vector<std::pair<std::string, Vec2>>& places, double time) {
    std::vector<std::string> ids;
    for (const auto& [id, at] : places) ids.push_back(id);
    bystanders_->update(ids);
    for (const auto& [id, at] : places) bystanders_->look(person(id), time, at);
  }

  std::vector<std::string> seen_by(const std::vector<Vec2>& eyes) {
    std::vector<Bystander*> seen;
    bystanders_->seen_from(0, eyes, seen);
    std::vector<std::string> ids;
    for (const Bystander* one : seen) ids.push_back(one->id);
    return ids;
  }

  void SetUp() override {
    zones_ = zones();
    bystanders_.emplace(zones_);
  }

  std::vector<Zone> zones_;
  std::optional<Bystanders> bystanders_;
};

TEST_F(BystandersTest, are_known_again_from_step_to_step) {
  bystanders_->update({"b", "d"});
  bystanders_->look(person("d"), 0.0, {100.0, 0.0});
  bystanders_->update({"e", "a", "d"});  // in any order
  ASSERT_EQ(bystanders_->all().size(), 3U);
  EXPECT_EQ(bystanders_->all()[0].id, "a");
  EXPECT_EQ(bystanders_->all()[1].id, "d");
  EXPECT_TRUE(person("d").near);
  EXPECT_FALSE(person("a").near);
}

TEST_F(BystandersTest, tells_whom_sumo_has_lost_and_who_of_them_was_a_guest) {
  bystanders_->update({"a", "b", "c", "d"});
  for (const char* guest : {"a", "c", "d"}) bystanders_->set_guest(guest, true);
  bystanders_->update({"c"});
  std::vector<std::pair<std::string, bool>> gone;
  for (const Bystander& person : bystanders_->gone()) gone.emplace_back(person.id, person.guest);
  EXPECT_THAT(gone, ElementsAre(Pair("a", true), Pair("b", false), Pair("d", true)));
  bystanders_->update({"c"});
  EXPECT_THAT(bystanders_->gone(), IsEmpty());
}

TEST_F(BystandersTest, near_is_who_is_within_sight_of_the_zone) {
  stand({{"in", {100.0, 0.0}}, {"beside", {100.0, 9.0}}, {"far", {100.0, 80.0}}}, 0.0);
  EXPECT_TRUE(person("in").near);
  EXPECT_TRUE(person("beside").near);
  EXPECT_FALSE(person("far").near);
}

TEST_F(BystandersTest, looks_again_when_somebody_can_have_come_near) {
  stand({{"near", {100.0, 0.0}}, {"far", {100.0, 42.0}}, {"away", {100.0, 5000.0}}}, 7.0);
  EXPECT_TRUE(Bystanders::is_due(person("near"), 7.1)) << "in every step";
  // At 40 m/s at most; the distance is a lower bound, so that it may be sooner.
  EXPECT_FALSE(Bystanders::is_due(person("far"), 7.05));
  EXPECT_TRUE(Bystanders::is_due(person("far"), 7.0 + (42.0 - 2.0 - 10.0) / 40.0 + 1e-6));
  EXPECT_FALSE(Bystanders::is_due(person("away"), 11.9));
  EXPECT_TRUE(Bystanders::is_due(person("away"), 12.0)) << "a program may move it anyhow";
}

TEST_F(BystandersTest, guests_are_not_looked_at_until_they_are_given_back) {
  stand({{"a", {100.0, 500.0}}}, 0.0);
  EXPECT_FALSE(Bystanders::is_due(person("a"), 0.1));
  bystanders_->set_guest("a", true);
  EXPECT_FALSE(Bystanders::is_due(person("a"), 100.0));
  bystanders_->set_guest("a", false);
  EXPECT_TRUE(Bystanders::is_due(person("a"), 0.1)) << "it may be anywhere by now";
  bystanders_->set_guest("A", true);
  EXPECT_TRUE(Bystanders::is_due(person("a"), 0.1)) << "nobody has that id";
}

TEST_F(BystandersTest, speed_is_distance_over_seconds_and_not_over_steps) {
  stand({{"a", {100.0, 0.0}}}, 0.0);
  EXPECT_TRUE(person("a").velocity.isZero()) << "nothing is known yet";
  stand({{"a", {100.0, 1.0}}}, 0.5);
  EXPECT_TRUE(person("a").velocity.isApprox(Vec2(0.0, 2.0)));
  EXPECT_NEAR(person("a").heading, 0.5 * kPi, 1e-12);
  stand({{"a", {100.004, 1.0}}}, 1.0);
  EXPECT_NEAR(person("a").heading, 0.5 * kPi, 1e-12) << "hardly moves: faces where it did";
}

TEST_F(BystandersTest, are_seen_by_eyes_that_are_near) {
  stand({{"here", {60.0, 0.0}}, {"there", {140.0, 0.0}}}, 0.0);
  EXPECT_THAT(seen_by({{62.0, 0.0}}), ElementsAre("here"));
  EXPECT_THAT(seen_by({{62.0, 0.0}, {139.0, 1.0}}), ElementsAre("here", "there"));
  EXPECT_THAT(seen_by({}), IsEmpty());
}

TEST_F(BystandersTest, whoever_is_within_sight_of_an_eye_is_seen) {
  for (double x = 55.0; x < 145.0; x += 0.7) {
    stand({{"a", {x, 0.0}}}, x);
    EXPECT_THAT(seen_by({{x - 9.9, 0.0}}), ElementsAre("a")) << x;
    EXPECT_THAT(seen_by({{x + 9.9, 1.0}}), ElementsAre("a")) << x;
  }
}

TEST_F(BystandersTest, guests_and_who_is_out_of_sight_of_the_zone_are_not_seen) {
  stand({{"guest", {100.0, 0.0}}, {"out", {100.0, 45.0}}}, 0.0);
  bystanders_->set_guest("guest", true);
  EXPECT_THAT(seen_by({{100.0, 1.0}, {100.0, 44.0}}), IsEmpty());
}

TEST_F(BystandersTest, who_is_near_another_zone_is_not_seen_from_this_one) {
  Zone other = zone;
  other.walkable = Region{Polygon{{{300, -2}, {350, -2}, {350, 2}, {300, 2}}, {}}};
  zones_ = {zone, other};
  bystanders_.emplace(zones_);
  stand({{"a", {310.0, 0.0}}}, 0.0);
  EXPECT_TRUE(person("a").near);
  EXPECT_THAT(seen_by({{311.0, 0.0}}), IsEmpty());
}

TEST_F(BystandersTest, of_whom_another_program_moves_the_last_two_places_tell_the_speed) {
  stand({{"a", {100.0, 0.0}}}, 0.0);
  stand({{"a", {100.0, 0.6}}}, 0.5);
  const double along_lane = 0.0, heading = 0.0;
  EXPECT_EQ(seen(person("a"), along_lane, heading).velocity, Vec2(0.0, 0.0));
  person("a").external = true;
  EXPECT_NEAR((seen(person("a"), along_lane, heading).velocity - Vec2(0.0, 1.2)).norm(), 0.0, 1e-9);
  EXPECT_EQ(seen(person("a"), along_lane, heading).position, Vec2(100.0, 0.6));
}

TEST_F(BystandersTest, who_is_longer_than_wide_does_not_turn_its_shoulders) {
  Bystander walker, pram;
  walker.id = "walker";
  pram.id = "pram";
  measure(walker, {0.215, 0.478});
  EXPECT_TRUE(walker.turns);
  EXPECT_NEAR(walker.radius, 0.239, 1e-9);
  EXPECT_NE(walker.key, 0U);
  measure(pram, {1.2, 0.6});
  EXPECT_FALSE(pram.turns);
  EXPECT_NE(pram.key, walker.key);
}

}  // namespace
}  // namespace pedzone
