// Room that is kept for vehicles that are about to depart.
#include "sumo/plan/insertions.hpp"

#include <gmock/gmock.h>

#include "four_edges.hpp"

namespace pedzone {
namespace {

class InsertionsTest : public testing::Test, protected test::FourEdges {
 protected:
  /// A car 5 m long, to depart with its front at 5.1 m on e1, which begins at x = 50 m.
  Departure car(double time) const { return {"car", time, e1, lane_of(e1), 5.1, 5.0, 1.8}; }

  using Pending = std::vector<std::string>;

  std::vector<VehicleState> claims(Insertions& insertions, double time,
                                   const Pending& pending = {}) const {
    std::vector<VehicleState> out;
    insertions.add_claims(time, 0.1, pending, fleet_, out);
    return out;
  }

  InsertionsTest() {
    for (Lane& lane : network.lanes) lane.width = 3.2;
  }

  std::vector<Zone> all_ = zones();
  Fleet fleet_{network, all_};
};

TEST_F(InsertionsTest, claim_the_room_from_rear_to_front_when_it_is_due) {
  Insertions insertions(network, {car(20.0)});
  EXPECT_TRUE(claims(insertions, 15.9).empty());
  const auto found = claims(insertions, 16.1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].width, 1.3, 1e-9);
  EXPECT_LT(found[0].length, 0.1) << "nothing stands there yet";
  EXPECT_LE(found[0].way.front().x(), 50.1);
  EXPECT_NEAR(found[0].way.back().x(), 55.1, 1e-9);
  EXPECT_GE(found[0].way.front().x() + found[0].claim, 55.1);
}

TEST_F(InsertionsTest, claim_the_whole_width_where_there_is_room_beside_it) {
  network.lanes[lane_of(e1)].width = 5.0;
  Insertions insertions(network, {car(20.0)});
  EXPECT_NEAR(claims(insertions, 20.0).at(0).width, 1.8, 1e-9);
}

TEST_F(InsertionsTest, claim_beside_the_middle_as_far_as_the_lane_goes) {
  Lane& lane = network.lanes[lane_of(e1)];
  const double middle = lane.shape.front().y();
  lane.width = 5.0;
  Departure left = car(20.0), right = car(20.0), open = car(20.0);
  left.lateral = 100.0;
  right.lateral = -0.5;
  open.lateral = std::nullopt;
  Insertions insertions(network, {left, right, open});
  const auto found = claims(insertions, 20.0);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[0].way.back().y(), middle + 1.6, 1e-9) << "1.8 m wide";
  EXPECT_NEAR(found[1].way.back().y(), middle - 0.5, 1e-9);
  EXPECT_NEAR(found[2].way.back().y(), middle, 1e-9);
  EXPECT_NEAR(found[2].width, 4.5, 1e-9) << "SUMO may put it anywhere across";
}

TEST_F(InsertionsTest, claim_where_sumos_position_is_on_a_lane_that_it_counts_shorter) {
  Lane& lane = network.lanes[lane_of(e1)];
  lane.length = 0.5 * length_of(lane.shape);
  Departure there = car(20.0);
  there.position = 10.0;
  Insertions insertions(network, {there});
  EXPECT_NEAR(claims(insertions, 20.0).at(0).way.back().x(), 70.0, 1e-9);
}

TEST_F(InsertionsTest, claim_all_places_of_one_that_waits) {
  Departure other = car(20.0);
  other.edge = e2;
  other.lane = lane_of(e2);
  Insertions insertions(network, {car(20.0), other});
  EXPECT_EQ(claims(insertions, 20.0).size(), 2U);
  EXPECT_EQ(claims(insertions, 27.0, {"car"}).size(), 2U);
}

TEST_F(InsertionsTest, claim_until_sumo_has_tried_and_on_if_it_could_not) {
  Insertions insertions(network, {car(20.0)});
  EXPECT_EQ(claims(insertions, 20.0).size(), 1U) << "SUMO tries in the step that follows";
  EXPECT_TRUE(claims(insertions, 20.1).empty()) << "it is there";
  EXPECT_EQ(claims(insertions, 27.0, {"car"}).size(), 1U);
  EXPECT_TRUE(claims(insertions, 41.0, {"car"}).empty()) << "people get past";
  EXPECT_EQ(claims(insertions, 51.0, {"car"}).size(), 1U);
  EXPECT_TRUE(claims(insertions, 51.0, {"nobody knows it"}).empty());
}

TEST_F(InsertionsTest, claim_one_place_for_all_that_wait_on_an_edge_and_for_copies) {
  Insertions insertions(network, {car(20.0)});
  EXPECT_EQ(claims(insertions, 22.0, {"car.1", "car.2"}).size(), 1U);
}

TEST_F(InsertionsTest, claim_nothing_where_a_vehicle_stands) {
  Insertions insertions(network, {car(20.0)});
  fleet_.update({test::seen_vehicle("queue", {56.0, 0.0}, 0.0)}, 0.1);
  EXPECT_TRUE(claims(insertions, 22.0, {"car"}).empty());
  EXPECT_TRUE(claims(insertions, 19.0).empty());
  fleet_.update({test::seen_vehicle("queue", {63.0, 0.0}, 0.0)}, 0.1);
  EXPECT_EQ(claims(insertions, 22.0, {"car"}).size(), 1U) << "it has driven on";
}

TEST_F(InsertionsTest, claim_every_lane_where_sumo_chooses_one) {
  const int wide = add_edge("wide", "C", "N", 100, 150, 3);
  Departure any = car(20.0);
  any.edge = wide;
  any.lane = -1;
  Insertions insertions(network, {any});
  EXPECT_EQ(claims(insertions, 20.0).size(), 3U);
}

}  // namespace
}  // namespace pedzone
