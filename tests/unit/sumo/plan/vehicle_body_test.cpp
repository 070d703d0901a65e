// Vehicles that bend: of what parts they are, and where those are.
#include <gmock/gmock.h>

#include "fleet_fixture.hpp"
#include "shuttle.hpp"
#include "sumo/plan/fleet.hpp"
#include "sumo/plan/yield_plan.hpp"

namespace pedzone {
namespace {

using test::FleetTest;

TEST(VehicleParts, are_those_that_sumo_draws) {
  const auto parts = [](const char* shape, const char* vclass, double length,
                        const CarriageLengths& own = {}) {
    return parts_of(shape, vclass, length, own);
  };
  EXPECT_EQ(parts("rail/railcar", "tram", 22.0).count(), 3);
  EXPECT_NEAR(parts("rail/railcar", "tram", 22.0).first, 22.0 / 3.0, 1e-9);
  EXPECT_EQ(parts("rail/railcar", "rail_urban", 109.5).count(), 6);
  EXPECT_EQ(parts("bus/flexible", "bus", 16.5).count(), 2);
  EXPECT_DOUBLE_EQ(parts("bus/flexible", "bus", 16.5).first, 8.25);
  EXPECT_EQ(parts("truck/trailer", "trailer", 16.5).count(), 2);
  EXPECT_NEAR(parts("truck/trailer", "trailer", 16.5).first, 16.5 * 9.25 / 16.0, 1e-9);
  for (const char* rigid : {"passenger", "bus", "truck", "delivery", "ship"}) {
    EXPECT_EQ(parts(rigid, "bus", 12.0).count(), 1) << rigid;
  }
  EXPECT_EQ(parts("rail/railcar", "tram", 5.0).count(), 1) << "shorter than a carriage";
}

TEST(VehicleParts, are_as_long_as_their_type_says) {
  const CarriageLengths twelve{{}, 12.0, {}};
  EXPECT_EQ(parts_of("bus", "bus", 36.0, twelve).count(), 3);
  EXPECT_DOUBLE_EQ(parts_of("rail/railcar", "tram", 36.0, twelve).first, 12.0);
  EXPECT_EQ(parts_of("rail/railcar", "tram", 36.0, {{}, 40.0, {}}).count(), 1) << "does not bend";
  EXPECT_EQ(parts_of("rail/railcar", "tram", 36.0, {6.0, 10.0, 0.0}).count(), 4);
  EXPECT_DOUBLE_EQ(parts_of("rail/railcar", "tram", 36.0, {6.0, 10.0, 0.0}).first, 6.0);
  for (const double nonsense : {0.0, -3.0, std::nan("")}) {
    EXPECT_EQ(parts_of("bus", "bus", 36.0, {{}, nonsense, {}}).count(), 1) << nonsense;
  }
}

TEST(VehicleParts, fill_the_vehicle_without_gaps) {
  const VehicleParts parts = parts_of("rail", "rail", 135.0, {});
  ASSERT_GT(parts.count(), 2);
  double front = 135.0;
  for (int k = 0; k < parts.count(); ++k) {
    const VehiclePart part = part_of(parts, 135.0, k);
    EXPECT_NEAR(part.rear + part.length, front, 1e-9) << k;
    front = part.rear;
  }
  EXPECT_NEAR(front, 0.0, 1e-9);
}

/// A tram of three parts of 10 m, 2 m wide, whose way turns left at the origin, its front 15 m
/// beyond.
FleetVehicle tram() {
  FleetVehicle vehicle;
  vehicle.traits.length = 30.0;
  vehicle.traits.width = 2.0;
  vehicle.traits.parts = {10.0, 2};
  vehicle.way = {{-15.0, 0.0}, {-5.0, 0.0}, {0.0, 0.0}, {0.0, 5.0}, {0.0, 15.0}, {0.0, 60.0}};
  vehicle.front = {0.0, 15.0};
  vehicle.heading = angle_of(Vec2(15.0, 15.0));
  vehicle.speed = 5.0;
  return vehicle;
}

TEST(VehicleBody, of_one_that_bends_lies_on_its_way) {
  const VehicleBody body = body_of(tram());
  ASSERT_EQ(body.parts().size(), 3U);
  EXPECT_TRUE(body.first().centre.isApprox(Vec2(0.0, 10.0)));
  EXPECT_TRUE(body.first().axis.isApprox(Vec2(0.0, 1.0)));
  EXPECT_TRUE(body.parts()[1].axis.isApprox(Vec2(1.0, 1.0).normalized()));
  EXPECT_TRUE(body.parts()[2].centre.isApprox(Vec2(-10.0, 0.0)));
  EXPECT_LT(body.signed_distance({-12.0, 0.5}), 0.0) << "on its last part";
  EXPECT_GT(body.signed_distance({-7.5, 7.5}), 4.0) << "on the line from its rear to its front";
}

TEST(VehicleBody, of_one_that_bends_goes_on_along_its_way) {
  const VehicleBody body = body_after(tram(), 15.0);
  for (const Rectangle& part : body.parts()) {
    EXPECT_NEAR(part.centre.x(), 0.0, 1e-9);
    EXPECT_TRUE(part.axis.isApprox(Vec2(0.0, 1.0)));
  }
  EXPECT_NEAR(body.parts()[2].centre.y(), 5.0, 1e-9);
}

TEST(VehicleBody, is_straight_where_its_way_is_not_known) {
  FleetVehicle vehicle = tram();
  vehicle.way.clear();
  const VehicleBody body = body_of(vehicle);
  ASSERT_EQ(body.parts().size(), 1U);
  EXPECT_TRUE(body.first().centre.isApprox(vehicle.centre()));
}

TEST(VehicleBody, of_one_that_bends_leaves_room_for_who_stands_in_the_corner) {
  const PersonAhead in_corner{{-7.5, 7.5}, Vec2::Zero(), 0.25, {}};
  EXPECT_FALSE(first_in_way(tram(), {&in_corner, 1}, 0.3, 40.0));
  FleetVehicle rigid = tram();
  rigid.traits.parts = {};
  const PersonAhead on_way{{0.0, 30.0}, Vec2::Zero(), 0.25, {}};
  EXPECT_NEAR(first_in_way(tram(), {&on_way, 1}, 0.0, 40.0)->distance, 14.75, 0.05);
}

TEST_F(FleetTest, shows_people_each_part_of_a_vehicle_that_bends) {
  Fleet fleet(network, zones());
  fleet.vehicles() = {tram()};
  fleet.vehicles()[0].id = "tram";
  fleet.vehicles()[0].allowed_speed = 5.0;
  fleet.vehicles()[0].claim = 4.0;
  std::vector<VehicleState> states;
  fleet.states(1.0, states);
  ASSERT_EQ(states.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(states[k].key, states[0].key) << k;
    EXPECT_NEAR(states[k].length, 10.0, 1e-9) << k;
    const Vec2 rear = point_on(fleet.vehicles()[0].way, 20.0 - 10.0 * static_cast<double>(k)).point;
    EXPECT_TRUE(states[k].way.front().isApprox(rear)) << "its own way begins at its rear, " << k;
    EXPECT_NEAR(states[k].gone, 0.0, 1e-9) << k;
    EXPECT_NEAR(states[k].claim, 4.0 + 10.0 * static_cast<double>(k), 1e-9) << "all as far ahead";
  }
  EXPECT_TRUE(states[0].velocity.isApprox(Vec2(0.0, 5.0)));
  EXPECT_TRUE(states[2].velocity.isApprox(Vec2(5.0, 0.0)));
  EXPECT_NEAR(states[1].heading, 0.25 * kPi, 1e-9);
  EXPECT_GT(states[1].yaw_rate, 0.1);
}

TEST_F(FleetTest, asks_for_no_room_beside_a_part_of_one_that_nobody_holds_up) {
  Fleet fleet(network, zones());
  fleet.vehicles() = {tram()};
  std::vector<VehicleState> states;
  fleet.states(1.0, states);
  for (const VehicleState& state : states) EXPECT_EQ(state.claim, 0.0);
}

TEST_F(FleetTest, knows_the_way_of_each_part_of_one_that_comes) {
  Fleet fleet(network, zones());
  VehicleSeen seen = car(90.0, 2.0);
  seen.traits.length = 30.0;
  seen.traits.parts = {10.0, 2};
  fleet.update({seen}, 0.1);
  std::vector<VehicleState> states;
  fleet.states(0.1, states);
  ASSERT_EQ(states.size(), 3U);
  for (const VehicleState& state : states) {
    EXPECT_NEAR(state.gone, 0.0, 1e-9);
    EXPECT_NEAR(state.way.front().x(), state.centre.x() - 5.0, 1e-9);
  }
}

TEST_F(FleetTest, shows_the_parts_of_one_whose_way_ends_as_they_move_now) {
  Fleet fleet(network, zones());
  fleet.vehicles() = {tram()};
  FleetVehicle& vehicle = fleet.vehicles()[0];
  vehicle.way.pop_back();
  vehicle.velocity = unit(vehicle.heading) * 5.0;
  std::vector<VehicleState> states;
  fleet.states(1.0, states);
  ASSERT_EQ(states.size(), 3U);
  EXPECT_TRUE(states[0].velocity.isApprox(Vec2(0.0, 5.0)));
  EXPECT_TRUE(states[2].velocity.isApprox(Vec2(5.0, 0.0)));
}

TEST_F(FleetTest, touches_whom_a_part_overlaps) {
  Fleet fleet(network, zones());
  VehicleSeen seen = car(90.0, 0.0);
  seen.traits.length = 30.0;
  seen.traits.parts = {10.0, 2};
  fleet.update({seen}, 0.1);
  EXPECT_TRUE(fleet.touches({61.0, 0.0}, 0.2));
  EXPECT_FALSE(fleet.touches({59.0, 0.0}, 0.2));
}

}  // namespace
}  // namespace pedzone
