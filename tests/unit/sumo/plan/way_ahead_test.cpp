// A vehicle's way: from its rear along the lanes that it came by and those it comes to.
#include "sumo/plan/way_ahead.hpp"

#include "fleet_fixture.hpp"

namespace pedzone {
namespace {

class WayAheadTest : public test::FleetTest {};

TEST_F(WayAheadTest, is_as_long_as_braking_takes_and_30_m) {
  for (const double speed : {0.0, 3.0, 9.0}) {
    const FleetVehicle vehicle = one(car(60.0, speed));
    EXPECT_TRUE(vehicle.way.front().isApprox(Vec2(56.0, 0.0))) << "from its rear";
    // 4.5 m/s² is how it likes to brake.
    EXPECT_NEAR(vehicle.way.back().x(), 60.0 + speed * speed / (2.0 * 4.5) + 30.0, 1e-9);
  }
}

TEST_F(WayAheadTest, ends_with_the_route) {
  route_ = {e0, e1};
  EXPECT_NEAR(one(car(90.0, 0.0)).way.back().x(), 100.0, 1e-9);
  EXPECT_TRUE(one(car(90.0, 0.0)).leaves);
  EXPECT_FALSE(one(car(60.0, 0.0)).leaves) << "its trip goes on beyond the way that is built";
}

TEST_F(WayAheadTest, keeps_to_the_side_on_which_the_vehicle_drives) {
  VehicleSeen left = car(60.0, 0.0);
  left.lateral = 0.5;
  EXPECT_NEAR(one(left).way.back().y(), 0.5, 1e-12);
}

TEST_F(WayAheadTest, of_one_that_overtakes_leads_on_beside_its_own_lane) {
  VehicleSeen overtaking = car(60.0, 0.0);
  overtaking.front.y() = overtaking.lateral = 4.0;
  overtaking.overtakes = true;
  EXPECT_TRUE(one(overtaking).way.back().isApprox(Vec2(90.0, 4.0)));
  overtaking.front.x() = 90.0;
  EXPECT_TRUE(one(overtaking).way.back().isApprox(Vec2(120.0, 0.0))) << "back on its own beyond";
}

TEST_F(WayAheadTest, follows_the_route_round_a_corner) {
  const int north = add_edge("north", "C", "N", 100, 150);
  network.lanes[lane_of(north)].shape = {{100.0, 0.0}, {100.0, 50.0}};
  connect(lane_of(e1), lane_of(north));
  route_ = {e1, north};
  VehicleSeen turning = car(90.0, 0.0);
  turning.route_index = 0;
  EXPECT_TRUE(one(turning).way.back().isApprox(Vec2(100.0, 20.0)));
}

TEST_F(WayAheadTest, of_a_lane_that_does_not_lead_on_is_its_neighbours) {
  const int wide = add_edge("wide", "X", "D", 60, 100, 2);
  connect(network.edges[wide].lanes[0], lane_of(e2));
  route_ = {wide, e2};
  VehicleSeen changing = car(90.0, 0.0);
  changing.lane = network.edges[wide].lanes[1];
  changing.route_index = 0;
  changing.front.y() = 4.0;
  EXPECT_TRUE(one(changing).way.back().isApprox(Vec2(120.0, 0.0)));
}

TEST_F(WayAheadTest, goes_onto_the_lane_that_SUMO_means) {
  const int wide = add_edge("wide", "C", "W", 100, 150, 2);
  const std::vector<int>& lanes = network.edges[wide].lanes;
  network.lanes[lanes[1]].shape = {{100.0, 3.0}, {150.0, 3.0}};
  for (const int lane : lanes) connect(lane_of(e1), lane);
  route_ = {e1, wide};
  VehicleSeen widening = car(90.0, 0.0);
  widening.route_index = 0;
  EXPECT_NEAR(one(widening).way.back().y(), 0.0, 1e-9) << "the first, where nothing is known";
  const std::vector<int> means{lane_of(e1), lanes[1]};
  widening.means = means;
  EXPECT_NEAR(one(widening).way.back().y(), 3.0, 1e-9);
}

TEST_F(WayAheadTest, of_one_that_changes_lanes_bit_by_bit_leads_to_the_other_lane) {
  const int wide = add_edge("wide", "C", "W", 100, 150, 2);
  const std::vector<int>& lanes = network.edges[wide].lanes;
  network.lanes[lanes[1]].shape = {{100.0, 3.0}, {150.0, 3.0}};
  route_ = {wide};
  const auto at = [&](const Vec2& front, int lane, double lateral, bool drifts) {
    VehicleSeen seen = test::seen_vehicle("car", front, 5.0);
    seen.lane = lanes[lane];
    seen.lateral = lateral;
    seen.route = route_;
    seen.traits.drifts = drifts;
    return seen;
  };
  const auto way_of = [&](const VehicleSeen& now) {
    return moved(at({105.0, 0.0}, 0, 0.0, now.traits.drifts), now, 1.0).way;
  };
  const Polyline before_half = way_of(at({110.0, 1.0}, 0, 1.0, true));
  EXPECT_NEAR(project_on(before_half, {115.0, 2.0}).lateral, 0.0, 1e-9) << "1 m/s sideways";
  EXPECT_TRUE(before_half.back().isApprox(Vec2(142.8, 3.0), 0.01)) << "then along it";
  const Polyline after_half = way_of(at({110.0, 2.0}, 1, -1.0, true));
  EXPECT_NEAR(project_on(after_half, {112.5, 3.0}).lateral, 0.0, 1e-9);
  EXPECT_NEAR(after_half.back().y(), 3.0, 1e-9);
  EXPECT_NEAR(way_of(at({110.0, 1.0}, 0, 1.0, false)).back().y(), 1.0, 1e-9) << "SUMO jumps";
}

TEST_F(WayAheadTest, tells_how_far_a_junction_is_or_how_far_the_front_has_come_into_it) {
  const int first = add_edge(":J_0", "J", "J", 100, 106),
            second = add_edge(":J_1", "J", "J", 106, 112);
  const int after = add_edge("after", "J", "K", 112, 160);
  for (const int inside : {first, second}) {
    network.edges[inside].function = EdgeFunction::kInternal;
  }
  network.junction_index["J"] = 4;
  network.junctions.resize(5);
  network.junctions[4].type = "traffic_light";
  network.connections.push_back({lane_of(e1), lane_of(after), lane_of(first)});
  network.connections.push_back({lane_of(first), lane_of(after), lane_of(second)});
  connect(lane_of(second), lane_of(after));
  route_ = {e1, after};
  const auto at = [&](double x, int edge) {
    VehicleSeen vehicle = car(x, 2.0);
    vehicle.lane = lane_of(edge);
    vehicle.route_index = 0;
    return vehicle;
  };
  const JunctionAhead ahead = one(at(90.0, e1)).junction;
  EXPECT_EQ(ahead.junction, 4);
  EXPECT_TRUE(ahead.signalled);
  EXPECT_NEAR(ahead.begin, 10.0, 1e-9);
  EXPECT_NEAR(ahead.end, 22.0, 1e-9);
  EXPECT_NEAR(one(at(104.0, first)).junction.begin, -4.0, 1e-9);
  const JunctionAhead inside = moved(at(104.0, first), at(108.0, second), 1.0).junction;
  EXPECT_EQ(inside.junction, 4);
  EXPECT_NEAR(inside.begin, -8.0, 1e-9) << "all of its lanes count";
  EXPECT_NEAR(inside.end, 4.0, 1e-9);
}

TEST_F(WayAheadTest, of_one_that_is_on_no_lane_goes_straight_on) {
  VehicleSeen lost = car(60.0, 0.0);
  lost.lane = -1;
  lost.heading = 0.5 * kPi;
  EXPECT_TRUE(one(lost).way.back().isApprox(Vec2(60.0, 30.0)));
}

/// Round a corner: from the street's end at x = 200 straight to the left.
class RearTest : public test::FleetTest {
 protected:
  RearTest() {
    e4_ = add_edge("e4", "E", "F", 0, 50);
    network.lanes[lane_of(e4_)].shape = {{200.0, 0.0}, {200.0, 50.0}};
    connect(lane_of(e3), lane_of(e4_));
    zone.walkable = Region{Polygon{{{50, -2}, {250, -2}, {250, 50}, {50, 50}}, {}}};
  }

  /// A car of 4 m with its front so far [m] along e3 and e4, and as SUMO turns it.
  VehicleSeen car(double along, double rear) const {
    const auto at = [](double x) { return x < 200.0 ? Vec2(x, 0.0) : Vec2(200.0, x - 200.0); };
    VehicleSeen seen = test::seen_vehicle("car", at(along), 2.0);
    seen.heading = angle_of(at(along) - at(rear));
    seen.lane = lane_of(along < 200.0 ? e3 : e4_);
    seen.route = route_;
    seen.route_index = along < 200.0 ? 0 : 1;
    return seen;
  }

  int e4_ = 0;
  std::vector<int> route_;
};

TEST_F(RearTest, follows_the_lanes_that_the_vehicle_came_by) {
  route_ = {e3, e4_};
  const FleetVehicle turning = moved(car(199.0, 195.0), car(202.0, 198.0), 1.0);
  // 2 m farther on the whole of it is round the corner, and no longer aslant.
  const VehicleBody there = body_after(turning, 2.0);
  const Rectangle& later = there.first();
  EXPECT_TRUE(later.centre.isApprox(Vec2(200.0, 2.0), 1e-6)) << later.centre.transpose();
  EXPECT_NEAR(later.axis.x(), 0.0, 1e-9);
  EXPECT_TRUE(turning.way.front().isApprox(Vec2(198.0, 0.0), 1e-6));
}

TEST_F(RearTest, is_its_length_behind_the_front_of_one_beside_its_lanes_middle) {
  route_ = {e3, e4_};
  for (const double lateral : {-0.3, 0.3}) {
    VehicleSeen before = car(199.0, 195.0), now = car(202.0, 198.0);
    before.lateral = now.lateral = lateral;
    before.front.y() += lateral;
    now.front.x() -= lateral;
    const FleetVehicle turning = moved(before, now, 1.0);
    const double length = turning.traits.length;
    EXPECT_TRUE(point_on(turning.way, length).point.isApprox(turning.front, 1e-9)) << lateral;
    EXPECT_NEAR(point_on(turning.way, 0.0).point.y(), lateral, 0.1) << "on the lane it came by";
  }
}

TEST_F(RearTest, is_straight_behind_the_first_lane_of_one_inserted_on_less_than_its_length) {
  route_ = {e3, e4_};
  network.lanes[lane_of(e3)].shape = {{198.0, 0.0}, {200.0, 0.0}};
  const FleetVehicle turning = moved(car(199.5, 195.5), car(201.0, 197.0), 1.0);
  EXPECT_TRUE(turning.way.front().isApprox(Vec2(197.0, 0.0), 1e-6));
  EXPECT_NEAR(body_after(turning, 3.0).first().axis.x(), 0.0, 1e-9) << "round the corner then";
}

TEST_F(RearTest, of_one_that_bends_is_known_by_the_heading_of_its_first_part_too) {
  route_ = {e3, e4_};
  // A tram of two parts: SUMO 1.15's heading is that of the whole, 1.18's that of the first.
  for (const double seen_from : {12.0, 6.0}) {
    VehicleSeen before = car(199.0, 187.0), now = car(204.0, 204.0 - seen_from);
    for (VehicleSeen* one : {&before, &now}) {
      one->traits.length = 12.0;
      one->traits.parts = {6.0, 1};
    }
    const FleetVehicle tram = moved(before, now, 1.0);
    EXPECT_TRUE(tram.way.front().isApprox(Vec2(192.0, 0.0), 1e-6)) << seen_from;
    before.traits.parts = now.traits.parts = {};
    const Vec2 rear = moved(before, now, 1.0).way.front();
    EXPECT_EQ(rear.isApprox(Vec2(192.0, 0.0), 1e-6), seen_from == 12.0) << "of a stiff one";
  }
}

TEST_F(RearTest, is_straight_behind_one_that_has_not_come_by_its_lanes) {
  route_ = {e3, e4_};
  const FleetVehicle put = one(car(202.0, 198.0));
  EXPECT_TRUE(put.way.front().isApprox(Vec2(put.front - unit(put.heading) * 4.0), 1e-9));
  VehicleSeen changes = car(190.0, 186.0);
  changes.heading += 0.3;  // a change of lanes
  const FleetVehicle changing = moved(car(188.0, 184.0), changes, 1.0);
  EXPECT_TRUE(changing.way.front().isApprox(Vec2(changing.front - unit(changing.heading) * 4.0)));
}

}  // namespace
}  // namespace pedzone
