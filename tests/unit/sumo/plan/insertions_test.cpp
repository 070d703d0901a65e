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

  std::vector<VehicleState> claims(Insertions& insertions, double time) const {
    std::vector<VehicleState> out;
    insertions.add_claims(time, fleet_, out);
    return out;
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

TEST_F(InsertionsTest, claim_nothing_once_it_is_there_or_long_over) {
  Insertions insertions(network, {car(20.0)});
  EXPECT_EQ(claims(insertions, 22.0).size(), 1U) << "SUMO may put it there late";
  fleet_.update({test::seen_vehicle("car", {55.1, 0.0}, 0.0)}, 0.1);
  EXPECT_TRUE(claims(insertions, 22.1).empty());
  fleet_.update({}, 0.1);
  EXPECT_EQ(claims(insertions, 23.9).size(), 1U);
  EXPECT_TRUE(claims(insertions, 24.1).empty());
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
