// Who is given back to SUMO, when, and by which calls.
#include "sumo/plan/release_plan.hpp"

#include <gmock/gmock.h>

#include "four_edges.hpp"

namespace pedzone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kPortal = 50.0 - kPortalInset;  // [m] on the lane of an edge walked forward

class ReleasePlanTest : public testing::Test, protected test::FourEdges {
 protected:
  ReleasePlanTest() {
    for (Lane& lane : network.lanes) lane.vehicles = false;
    stretch_.lane = lane_of(e2);
    stretch_.hop_lane = lane_of(e3);
    stretch_.position = kPortal;
  }

  ReleasePlan release(const std::string& present = "e1_0") const {
    return plan_release(network, stretch_, walked_, present, 0.5);
  }

  ZoneStretch stretch_;
  Walked walked_{{148.5, 0.5}, {149.1, 1.0}, 0.25, 1.2};
};

TEST_F(ReleasePlanTest, moves_the_person_onto_the_last_lane_where_the_step_began) {
  // SUMO walks it for this step itself.
  EXPECT_THAT(release().moves, ElementsAre(LaneMove{"e2_0", 48.5, 1.0}));
  EXPECT_FALSE(release().remove_stage);
}

TEST_F(ReleasePlanTest, hops_over_another_lane_where_sumo_has_it_on_that_very_lane) {
  EXPECT_THAT(release("e2_0").moves,
              ElementsAre(LaneMove{"e3_0", 25.0, {}}, LaneMove{"e2_0", 48.5, 1.0}));
}

TEST_F(ReleasePlanTest, person_jumps_no_farther_than_a_step_and_half_a_metre) {
  walked_.from.x() = 120.0;
  EXPECT_NEAR(release().moves.at(0).position, kPortal - (1.2 * 0.5 + 0.5), 1e-9);
  walked_.from.x() = 160.0;
  EXPECT_NEAR(release().moves.at(0).position, kPortal, 1e-9) << "nor beyond the portal";
  stretch_.forward = false;
  stretch_.position = kPortalInset;
  walked_.from.x() = 130.0;
  EXPECT_NEAR(release().moves.at(0).position, kPortalInset + (1.2 * 0.5 + 0.5), 1e-9);
  walked_.from.x() = 90.0;
  EXPECT_NEAR(release().moves.at(0).position, kPortalInset, 1e-9);
}

TEST_F(ReleasePlanTest, keeps_the_side_and_the_body_on_the_lane) {
  walked_.to.y() = -1.0;
  EXPECT_NEAR(*release().moves.at(0).lateral, -1.0, 1e-9);
  walked_.to.y() = 9.0;
  EXPECT_NEAR(*release().moves.at(0).lateral, 2.0 - 0.25, 1e-9);
  walked_.radius = 3.0;
  EXPECT_NEAR(*release().moves.at(0).lateral, 0.0, 1e-9) << "wider than the lane";
}

TEST_F(ReleasePlanTest, at_the_side_of_a_lane_that_vehicles_use_as_well) {
  network.lanes[lane_of(e2)].vehicles = true;
  for (const bool left_hand : {false, true}) {
    network.left_hand = left_hand;
    const double side = left_hand ? 1.0 : -1.0;
    for (const double walked : {-1.0, 0.0, 1.0}) {
      walked_.to.y() = walked;
      EXPECT_NEAR(*release().moves.at(0).lateral, side * 1.5, 1e-9) << walked;
    }
    for (const double walked : {-1.7, 1.7}) {
      walked_.to.y() = walked;
      EXPECT_NEAR(*release().moves.at(0).lateral, walked, 1e-9) << "vehicles pass";
    }
  }
  network.left_hand = false;
  network.lanes[lane_of(e2)].width = 3.2;
  walked_.to.y() = 0.5;
  EXPECT_NEAR(*release().moves.at(0).lateral, -1.2, 1e-9) << "as far as SUMO's first stripe goes";
  network.lanes[lane_of(e2)].width = 3.5;
  walked_.to.y() = -1.5;
  EXPECT_NEAR(*release().moves.at(0).lateral, -(0.9 + 0.448), 1e-9)
      << "SUMO gives a car the last stripe";
  network.lanes[lane_of(e2)].width = 3.38;
  EXPECT_NEAR(*release().moves.at(0).lateral, -(1.69 - 0.25), 1e-9) << "that one is free";
  stretch_.release = Release::kStepOver;  // comes onto it from a walking area
  walked_.to.y() = 0.0;
  EXPECT_NEAR(*release().moves.back().lateral, 0.0, 1e-9);
}

TEST_F(ReleasePlanTest, person_that_arrives_is_put_at_its_arrival_position) {
  stretch_.release = Release::kArrive;
  stretch_.hop_lane = lane_of(e1);
  stretch_.position = 20.0;
  EXPECT_THAT(release("e2_0").moves,
              ElementsAre(LaneMove{"e1_0", 25.0, {}}, LaneMove{"e2_0", 20.0, 1.0}));
}

TEST_F(ReleasePlanTest, walk_on_one_edge_with_one_lane_is_removed) {
  stretch_.release = Release::kRemoveStage;
  stretch_.hop_lane = -1;
  EXPECT_TRUE(release("e2_0").remove_stage);
  EXPECT_THAT(release("e2_0").moves, IsEmpty());
}

TEST_F(ReleasePlanTest, steps_over_a_junction_by_way_of_the_edge_before) {
  stretch_.release = Release::kStepOver;
  stretch_.lane = lane_of(e3);
  stretch_.hop_lane = lane_of(e1);
  stretch_.position = kPortalInset;
  walked_.to.x() = 150.2;
  EXPECT_THAT(release("e2_0").moves,
              ElementsAre(LaneMove{"e1_0", 25.0, {}}, LaneMove{"e3_0", kPortalInset, 1.0}));
  EXPECT_THAT(release("e1_0").moves,
              ElementsAre(LaneMove{"e3_0", 25.0, {}}, LaneMove{"e1_0", 25.0, {}},
                          LaneMove{"e3_0", kPortalInset, 1.0}));
}

TEST_F(ReleasePlanTest, tells_where_sumo_has_the_person_then) {
  ReleasePlan plan;
  EXPECT_FALSE(place_of(network, plan));
  plan.moves = {{"e2_0", 5.0, {}}, {"e1_0", 20.0, 1.5}};
  EXPECT_TRUE(place_of(network, plan)->isApprox(Vec2(70.0, 1.5)));
}

class MayRelease : public testing::Test, protected test::FourEdges {
 protected:
  bool ask(double dt = 0.1) {
    return may_release(kPlace, {kPlace, kPlace, kRadius, 1.2}, fleet_, dt, held_);
  }

  /// The only vehicle: its front `before` [m] before the place.
  FleetVehicle& vehicle(double before, double speed) {
    VehicleSeen seen = test::seen_vehicle("van", kPlace - Vec2(before, 0.0), speed);
    seen.lane = lane_of(e2);
    seen.route = route_;
    fleet_.update({seen}, 0.1);
    return fleet_.vehicles()[0];
  }

  static constexpr double kRadius = 0.25;  // [m]
  const Vec2 kPlace{149.0, 0.0};

  const std::vector<int> route_{e2, e3};
  const std::vector<Zone> zones_{zone};
  Fleet fleet_{network, zones_};
  double held_ = 0.0;  ///< [s]
};

TEST_F(MayRelease, puts_whom_it_releases_so_far_ahead_of_a_vehicle_that_sumo_walks_it_on) {
  ZoneStretch stretch;
  stretch.lane = lane_of(e2);
  const auto position = [&](double before, double speed) {
    vehicle(before, speed);
    ReleasePlan plan{.moves = {{"e2_0", 49.0, {}}}};
    const bool goes = go_ahead_of_vehicles(network, stretch, fleet_, 0.5, held_, plan);
    return goes ? plan.moves.back().position : 0.0;
  };
  EXPECT_NEAR(position(1.1, 0.0), 49.15, 1e-9);
  EXPECT_NEAR(position(1.3, 0.0), 49.0, 1e-9) << "it is already";
  EXPECT_NEAR(position(-0.5, 0.0), 49.0, 1e-9) << "beside it";
  EXPECT_NEAR(position(9.0, 3.0), 49.0, 1e-9) << "it can stop";
  EXPECT_EQ(position(5.0, 3.0), 0.0) << "not before one that drives";
  EXPECT_EQ(held_, 0.5);
  held_ = 100.0;
  EXPECT_NEAR(position(5.0, 3.0), 49.0, 1e-9) << "but not for ever";
  EXPECT_NEAR(position(0.1, 0.0), 50.05, 1e-9) << "over the end of the lane";
  stretch.forward = false;
  EXPECT_NEAR(position(1.1, 0.0), 49.0, 1e-9);
}

TEST_F(MayRelease, where_no_vehicle_is) { EXPECT_TRUE(ask()); }

TEST_F(MayRelease, not_before_a_vehicle_that_comes_in_five_seconds) {
  vehicle(9.0, 2.0);
  EXPECT_FALSE(ask());
  vehicle(13.0, 2.0);
  EXPECT_TRUE(ask());
  vehicle(13.0, 4.0);
  EXPECT_FALSE(ask());
}

TEST_F(MayRelease, after_ten_seconds_where_vehicles_keep_coming_by_but_would_not_touch_it) {
  const auto held = [&](double before, bool ends_trip) {
    vehicle(before, 2.0);
    held_ = 0.0;
    double time = 0.0;
    const Walked walked{kPlace, kPlace, kRadius, 1.2, ends_trip};
    while (!may_release(kPlace, walked, fleet_, 0.1, held_) && time < 100.0) time += 0.1;
    return time;
  };
  EXPECT_NEAR(held(9.0, false), 10.0, 0.1 + 1e-6) << "is not there within two seconds";
  EXPECT_GE(held(2.0, false), 100.0);
  EXPECT_NEAR(held(2.0, true), 10.0, 0.1 + 1e-6) << "SUMO takes it out at once";
}

TEST_F(MayRelease, after_ten_seconds_beside_one_that_waits_for_people) {
  for (const double dt : {0.1, 0.5, 1.0}) {
    held_ = 0.0;
    vehicle(0.5, 0.0).commanded = 0.0;
    double time = 0.0;
    while (!ask(dt) && time < 100.0) time += dt;
    EXPECT_NEAR(time, 10.0, dt + 1e-6) << dt;
  }
}

TEST_F(MayRelease, after_ten_seconds_beside_one_that_lets_people_go_first) {
  vehicle(0.5, 0.0).lets_go = true;
  double time = 0.0;
  while (!ask() && time < 100.0) time += 0.1;
  EXPECT_NEAR(time, 10.0, 0.1 + 1e-6);
}

TEST_F(MayRelease, not_beside_one_that_waits_for_something_else) {
  vehicle(0.5, 0.0);
  for (int step = 0; step < 1000; ++step) EXPECT_FALSE(ask());
  EXPECT_EQ(held_, 0.0);
  vehicle(0.5 + kRadius + 0.1, 0.0);
  EXPECT_TRUE(ask()) << "farther than half a metre from the body";
}

TEST_F(MayRelease, neither_at_its_own_place_nor_at_that_which_sumo_has_for_it) {
  const Vec2 far = kPlace + Vec2(0.0, 9.0);
  const auto hand_over = [&](const Vec2& walked_to, const std::optional<Vec2>& place) {
    return may_hand_over({far, walked_to, kRadius, 1.2}, place, fleet_, 0.1, held_);
  };
  vehicle(0.5, 0.0);
  EXPECT_FALSE(hand_over(kPlace, far));
  EXPECT_FALSE(hand_over(far, kPlace));
  EXPECT_FALSE(hand_over(kPlace, std::nullopt));
  EXPECT_TRUE(hand_over(far, std::nullopt)) << "SUMO leaves it where it is";
  EXPECT_TRUE(hand_over(far, far));
}

TEST_F(MayRelease, beside_whatever_stands_where_the_trip_ends) {
  const auto hand_over = [&](bool ends_trip) {
    return may_hand_over({kPlace, kPlace, kRadius, 1.2, ends_trip}, kPlace, fleet_, 0.1, held_);
  };
  vehicle(0.5, 0.0);
  EXPECT_FALSE(hand_over(false));
  EXPECT_TRUE(hand_over(true));
  vehicle(9.0, 2.0);
  EXPECT_FALSE(hand_over(true)) << "who comes would brake for it";
}

TEST_F(ReleasePlanTest, the_trip_ends_with_the_last_stage_if_it_ends_in_the_zone) {
  ZoneStretch stretch;
  for (const Release release : {Release::kArrive, Release::kRemoveStage}) {
    stretch.release = release;
    EXPECT_TRUE(ends_trip(stretch, 1));
    EXPECT_FALSE(ends_trip(stretch, 2));
  }
  for (const Release release : {Release::kLeave, Release::kStepOver}) {
    stretch.release = release;
    EXPECT_FALSE(ends_trip(stretch, 1));
  }
}

class LetGoTest : public testing::Test, protected test::FourEdges {
 protected:
  std::optional<ReleasePlan> let_go(const Vec2& position, const std::string& present,
                                    const std::vector<int>& route) const {
    return plan_let_go(network, route, static_cast<int>(route.size()) - 1, position, 0.25, present);
  }
  std::optional<ReleasePlan> let_go(const Vec2& position, const std::string& present) const {
    return let_go(position, present, {e0, e1, e2, e3});
  }
};

TEST_F(LetGoTest, goes_on_from_where_it_stands) {
  EXPECT_THAT(let_go({70.0, 0.5}, "e0_0")->moves, ElementsAre(LaneMove{"e1_0", 20.0, 0.5}));
  EXPECT_THAT(let_go({70.0, 9.0}, "e0_0")->moves, ElementsAre(LaneMove{"e1_0", 20.0, 1.75}));
}

TEST_F(LetGoTest, hops_over_a_neighbour_where_sumo_has_it_on_that_very_lane) {
  EXPECT_THAT(let_go({70.0, 0.5}, "e1_0")->moves,
              ElementsAre(LaneMove{"e0_0", 25.0, {}}, LaneMove{"e1_0", 20.0, 0.5}));
  EXPECT_THAT(let_go({20.0, 0.5}, "e0_0")->moves,
              ElementsAre(LaneMove{"e1_0", 25.0, {}}, LaneMove{"e0_0", 20.0, 0.5}));
}

TEST_F(LetGoTest, never_to_a_place_that_the_route_comes_by_a_second_time) {
  EXPECT_THAT(let_go({70.0, 0.5}, "e3_0", {e0, e2, e0, e1})->moves,
              ElementsAre(LaneMove{"e1_0", 20.0, 0.5}));
}

TEST_F(LetGoTest, a_route_of_one_edge_with_one_lane_begins_anew) {
  EXPECT_TRUE(let_go({70.0, 0.5}, "e1_0", {e1})->begin_anew);
  EXPECT_THAT(let_go({70.0, 0.5}, "e1_0", {e1})->moves, ElementsAre(LaneMove{"e1_0", 20.0, 0.5}));
  EXPECT_FALSE(let_go({70.0, 0.5}, "", {e1})->begin_anew) << "SUMO has it on another lane";
  EXPECT_FALSE(let_go({70.0, 0.5}, "e1_0", {e0, e1})->begin_anew);
}

}  // namespace
}  // namespace pedzone
