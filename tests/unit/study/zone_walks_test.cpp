#include "study/measure/zone_walks.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"

namespace pedzone::study {
namespace {

constexpr double kStep = 1.0;  // [s]
/// The way finder's clearance is mitred at corners, up to 1.42 times as large.
constexpr double kRounding = 0.02;

/// A zone 20 m wide and 10 m deep with a wall up to 1 m from its north border in the middle.
///
///   0        10       20
///   +--------..--------+ 10
///   |        ##        | 9
///   |        ##        |
///   +--------##--------+ 0
std::vector<Zone> walled_zone() {
  std::vector<Zone> zones(1);
  zones[0].walkable =
      repair({{0, 0}, {9, 0}, {9, 9}, {11, 9}, {11, 0}, {20, 0}, {20, 10}, {0, 10}});
  zones[0].walls = WallIndex(zones[0].walkable);
  zones[0].ways = WayFinder(zones[0].walkable, kWayClearance);
  return zones;
}

Trips one_walker(double max_speed) {
  return {{{"p", "adult", 0.0, {}, {{0.0, {}, max_speed}}}}, {}};
}

/// Walks a person along some places, a step of kStep each, at the speeds that these give. The zone
/// is where x >= 0.
std::map<std::string, double> walk(const Trips& trips, const std::vector<Zone>& zones,
                                   const std::vector<Vec2>& places, double free_share = 1.0,
                                   double most_speed = 100.0) {
  Pedestrians pedestrians(trips);
  ZoneWalks walks(trips, zones, free_share);
  RunStep step;
  for (const Vec2& at : places) {
    PersonSample sample{.id = "p", .position = at};
    if (step.number > 0) sample.velocity = (at - places[step.number - 1]) / kStep;
    if (sample.velocity.norm() > most_speed) sample.velocity *= most_speed / sample.velocity.norm();
    const Pedestrian pedestrian = pedestrians.at(step.time, std::span(&sample, 1)).front();
    if (at.x() >= 0.0) walks.add({step, pedestrian, 0, {}});
    step = {step.number + 1, step.time + kStep, kStep};
  }
  std::map<std::string, double> values;
  walks.finish(values);
  return values;
}

TEST(ZoneWalks, only_the_part_within_the_zone_counts) {
  const auto zones = walled_zone();
  const Trips trips = one_walker(2.0);
  // From 3 m west of the zone at 1 m/s; inside from x = 0 (a border is inside) to 6, then 3 s
  // standing, then 2 m more.
  std::vector<Vec2> places;
  for (double x : {-3., -2., -1., 0., 1., 2., 3., 4., 5., 6., 6., 6., 6., 7., 8.}) {
    places.emplace_back(x, 5.0);
  }
  auto values = walk(trips, zones, places);
  EXPECT_EQ(values["person.visitors"], 1.0);
  EXPECT_DOUBLE_EQ(values["person.walked"], 8.0);
  EXPECT_DOUBLE_EQ(values["person.waiting"], 3.0);
  EXPECT_DOUBLE_EQ(values["person.speed"], 8.0 / 11.0);
  // 11 s for 8 m that take 4 s at 2 m/s; who dawdles 10 % on average needs more by itself.
  EXPECT_NEAR(values["person.delay"], 11.0 - 8.0 / 2.0, 1e-6);
  EXPECT_EQ(values["person.delay95"], values["person.delay"]) << "of one";
  EXPECT_NEAR(walk(trips, zones, places, 0.9)["person.delay"], 11.0 - 8.0 / 1.8, 1e-6);
  EXPECT_NEAR(values["person.detour"], 1.0, 1e-6);
}

TEST(ZoneWalks, who_is_put_on_farther_than_it_walks_has_jumped) {
  const auto zones = walled_zone();
  const std::vector<Vec2> places{{0, 5}, {1, 5}, {6, 5}, {7, 5}};
  auto values = walk(one_walker(2.0), zones, places, 1.0, 1.5);  // 5 m in a second, at 1.5 m/s
  EXPECT_DOUBLE_EQ(values["person.jumped"], 3.5);
  EXPECT_DOUBLE_EQ(walk(one_walker(2.0), zones, places)["person.jumped"], 0.0);
}

TEST(ZoneWalks, the_shortest_way_leads_round_walls) {
  const auto zones = walled_zone();
  const Trips trips = one_walker(1.0);
  // Over the wall with room for the body; then straight through it, as SUMO's own models may.
  const double y = 9.0 + kWayClearance;
  auto values = walk(trips, zones, {{5, 2}, {9, y}, {11, y}, {15, 2}});
  EXPECT_NEAR(values["person.detour"], 1.0, kRounding);
  values = walk(trips, zones, {{5, 2}, {7, 2}, {9, 2}, {11, 2}, {13, 2}, {15, 2}});
  EXPECT_DOUBLE_EQ(values["person.walked"], 10.0);
  const double shortest = 2.0 * std::hypot(4.0, y - 2.0) + 2.0;
  EXPECT_NEAR(values["person.detour"], 10.0 / shortest, kRounding);
  EXPECT_NEAR(values["person.delay"], 5.0 - shortest, kRounding * shortest);
}

TEST(ZoneWalks, who_comes_back_begins_another_visit) {
  const auto zones = walled_zone();
  // At half the maximum speed: half a second of each metre is delay.
  auto values = walk(one_walker(2.0), zones, {{1, 5}, {0, 5}, {-1, 5}, {0, 5}, {1, 5}, {2, 5}});
  EXPECT_EQ(values["person.visitors"], 1.0);
  EXPECT_DOUBLE_EQ(values["person.walked"], 3.0);
  EXPECT_NEAR(values["person.delay"], 1.5, 1e-3) << "numerical: places with room";
}

TEST(ZoneWalks, planned_stops_and_rides_are_no_walks) {
  const auto zones = walled_zone();
  // Walks until 2 s, stops until 5 s, and walks again.
  const Trips trips{{{"p", "adult", 0.0, {}, {{0.0, 2.0, 1.0}, {5.0, {}, 1.0}}}}, {}};
  auto values =
      walk(trips, zones, {{1, 5}, {2, 5}, {3, 5}, {3, 5}, {3, 5}, {3, 5}, {4, 5}, {5, 5}});
  EXPECT_DOUBLE_EQ(values["person.waiting"], 0.0);
  EXPECT_DOUBLE_EQ(values["person.walked"], 4.0);
  EXPECT_DOUBLE_EQ(values["person.speed"], 1.0);

  Pedestrians pedestrians(trips);
  const PersonSample rider{.id = "p", .position = {1, 5}, .rides_in = "bus"};
  EXPECT_TRUE(pedestrians.at(0.0, std::span(&rider, 1)).empty());
}

TEST(ZoneWalks, where_nobody_comes_nothing_is_said) {
  const auto zones = walled_zone();
  EXPECT_THAT(walk(one_walker(1.0), zones, {{-5, 5}, {-4, 5}}),
              testing::ElementsAre(testing::Pair("person.visitors", 0.0)));
}

TEST(ZoneWalks, outputs_of_two_runs_are_refused) {
  const Trips trips = one_walker(1.0);
  Pedestrians pedestrians(trips);
  const PersonSample stranger{.id = "stranger"};
  EXPECT_THROW(pedestrians.at(0.0, std::span(&stranger, 1)), InputError);
}

}  // namespace
}  // namespace pedzone::study
