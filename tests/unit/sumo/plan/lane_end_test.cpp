// Vehicles that keep SUMO's people from coming in at a lane's end.
#include "sumo/plan/lane_end.hpp"

#include "fleet_fixture.hpp"

namespace pedzone {
namespace {

class LaneEndTest : public test::FleetTest {
 protected:
  LaneEndTest() {
    Lane& lane = network.lanes[lane_of(e1)];
    lane.persons = true;
    lane.width = 3.2;
  }

  /// A car of that width [m], 40 m before the end of its lane.
  FleetVehicle wide(double width) const {
    VehicleSeen seen = car(60.0, 0.0);
    seen.traits.width = width;
    return one(seen);
  }

  static std::vector<PersonAhead> at(const Vec2& place, const Vec2& velocity = Vec2::Zero()) {
    return {{place, velocity, 0.24}};
  }
};

TEST_F(LaneEndTest, is_tight_where_less_than_a_stripe_is_left_on_either_side) {
  EXPECT_NEAR(wide(2.16).tight_end, 40.0, 1e-9);
  EXPECT_NEAR(way_to_room(wide(2.16)), 32.0, 1e-9);
  EXPECT_TRUE(std::isinf(wide(1.8).tight_end)) << "SUMO walks people past it";
}

TEST_F(LaneEndTest, is_not_where_nobody_walks_on_the_lane_or_it_is_of_no_zone) {
  network.lanes[lane_of(e1)].persons = false;
  EXPECT_TRUE(std::isinf(wide(2.16).tight_end));
  network.lanes[lane_of(e0)].persons = true;
  VehicleSeen before = car(40.0, 0.0);
  before.traits.width = 2.16;
  before.lane = lane_of(e0);
  before.route_index = 0;
  EXPECT_TRUE(std::isinf(one(before).tight_end));
}

TEST_F(LaneEndTest, is_not_where_the_vehicle_would_wait_in_a_bend_or_a_junction) {
  Lane& lane = network.lanes[lane_of(e1)];
  lane.shape = {{50.0, -20.0}, {95.0, -20.0}, {95.0, -5.0}, {100.0, 0.0}};
  EXPECT_TRUE(std::isinf(wide(2.16).tight_end));
  lane.shape = {{89.0, 0.0}, {100.0, 0.0}};  // 8 m before the end it would reach back into e0
  EXPECT_TRUE(std::isinf(wide(2.16).tight_end));
  lane.shape = {{87.0, 0.0}, {100.0, 0.0}};
  EXPECT_FALSE(std::isinf(wide(2.16).tight_end));
}

TEST_F(LaneEndTest, is_wanted_by_who_waits_beyond_it_or_comes) {
  VehicleSeen seen = car(90.0, 0.0);
  seen.traits.width = 2.16;
  const FleetVehicle van = one(seen);  // the lane ends at x = 100
  EXPECT_TRUE(comes_in(van, at({101.0, 1.0})));
  EXPECT_TRUE(comes_in(van, at({105.0, 4.0}, {-1.0, -0.5})));
  EXPECT_TRUE(comes_in(van, at({103.0, 4.0}, {0.0, -1.3}))) << "round a corner";
  EXPECT_FALSE(comes_in(van, at({103.0, 1.0}, {1.3, 0.0}))) << "walks away";
  EXPECT_FALSE(comes_in(van, at({99.0, 1.0}))) << "is on the lane";
  EXPECT_FALSE(comes_in(van, at({109.0, 0.0}, {-1.3, 0.0}))) << "is far away";
  EXPECT_FALSE(comes_in(van, {}));
}

TEST_F(LaneEndTest, is_left_by_who_walks_on_from_there) {
  VehicleSeen seen = car(90.0, 0.0);
  seen.traits.width = 2.16;
  const FleetVehicle van = one(seen);
  const auto leaving = [&](double x, int lane) {
    std::vector<PersonAhead> people = at({x, 0.5});
    people[0].exit_lane = lane;
    return goes_out(van, people);
  };
  EXPECT_TRUE(leaving(98.0, lane_of(e1)));
  EXPECT_FALSE(leaving(91.5, lane_of(e1))) << "is not there yet";
  EXPECT_FALSE(leaving(89.0, lane_of(e1))) << "is beside the van";
  EXPECT_FALSE(leaving(98.0, lane_of(e2))) << "goes on in the zone";
}

}  // namespace
}  // namespace pedzone
