// Vehicles on scripted paths: where they are put, when they leave, how people see them move.
#include "sumo/plan/steering.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "four_edges.hpp"

namespace pedzone {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr double kLength = 4.0;  // [m]

/// East from t = 10 s on, 20 m in 10 s; then north, 20 m in 10 s.
VehiclePath corner(const std::string& vehicle) {
  return {vehicle, {{10, {60, 0}}, {20, {80, 0}}, {30, {80, 20}}}};
}

class SteeringTest : public testing::Test, protected test::FourEdges {
 protected:
  std::vector<SteerOrder> plan(double time) {
    return steering_.plan(time, present_, [this](const std::string& id) {
      asked_.push_back(id);
      return kLength;
    });
  }

  Fleet fleet_of(double speed) const {
    Fleet fleet(network, zones());
    fleet.update({test::seen_vehicle("av", {60.0, 0.0}, speed),
                  test::seen_vehicle("car", {90.0, 0.0}, speed)},
                 0.1);
    return fleet;
  }

  Steering steering_{{corner("av")}};
  std::vector<std::string> present_{"car", "av"}, asked_;
};

TEST_F(SteeringTest, leaves_a_vehicle_to_sumo_before_its_first_row) {
  EXPECT_THAT(plan(9.9), IsEmpty());
  EXPECT_THAT(asked_, IsEmpty());
}

TEST_F(SteeringTest, puts_it_where_the_path_says) {
  const auto begin = plan(10.0);
  ASSERT_THAT(begin, SizeIs(1));
  EXPECT_EQ(begin[0].vehicle, "av");
  ASSERT_TRUE(begin[0].place);
  EXPECT_TRUE(begin[0].place->front.isApprox(Vec2(60.0, 0.0)));
  const auto later = plan(15.0);
  EXPECT_TRUE(later.at(0).place->front.isApprox(Vec2(70.0, 0.0)));
  EXPECT_NEAR(later[0].place->heading, 0.0, 1e-9);
  // Its rear is still before the corner: as far as its length says.
  EXPECT_NEAR(plan(21.0).at(0).place->heading, std::atan2(2.0, 2.0), 1e-9);
  EXPECT_NEAR(plan(30.0).at(0).place->heading, 0.5 * kPi, 1e-9);
}

TEST_F(SteeringTest, removes_it_after_its_last_row) {
  plan(10.0);
  EXPECT_TRUE(plan(30.0).at(0).place) << "the last row counts";
  EXPECT_FALSE(steering_.over());
  const auto end = plan(30.1);
  ASSERT_THAT(end, SizeIs(1));
  EXPECT_FALSE(end[0].place);
  EXPECT_TRUE(steering_.over());
  EXPECT_THAT(plan(30.2), IsEmpty());
}

TEST_F(SteeringTest, refuses_a_vehicle_that_has_not_departed_at_its_first_row) {
  present_ = {"car"};
  EXPECT_THAT(plan(9.9), IsEmpty());
  EXPECT_THROW(plan(10.0), InputError);
}

TEST_F(SteeringTest, forgets_a_vehicle_that_somebody_has_removed) {
  plan(10.0);
  present_ = {"car"};
  EXPECT_THAT(plan(11.0), IsEmpty());
  EXPECT_TRUE(steering_.over());
}

TEST_F(SteeringTest, shows_people_the_motion_of_the_path_and_not_sumos) {
  plan(10.0);
  Fleet fleet = fleet_of(0.1);
  steering_.foresee(fleet, 15.0, 0.5);
  const FleetVehicle& steered = fleet.vehicles()[0];
  EXPECT_TRUE(steered.traits.external);
  EXPECT_TRUE(steered.velocity.isApprox(Vec2(2.0, 0.0)));
  EXPECT_NEAR(steered.speed, 2.0, 1e-9);
  EXPECT_NEAR(steered.yaw_rate, 0.0, 1e-9);
  steering_.foresee(fleet, 21.0, 0.5);
  EXPECT_GT(steered.yaw_rate, 0.1) << "it turns to the left";
  EXPECT_TRUE(steered.way.back().isApprox(Vec2(80.0, 20.0))) << "no farther than the last row";
  const FleetVehicle& other = fleet.vehicles()[1];
  EXPECT_FALSE(other.traits.external);
  EXPECT_NEAR(other.speed, 0.1, 1e-9);
}

TEST_F(SteeringTest, changes_nothing_of_a_vehicle_that_is_not_steered_yet) {
  steering_ = Steering({corner("av"), {"car", {{100, {90, 0}}, {110, {99, 0}}}}});
  plan(10.0);
  Fleet fleet = fleet_of(0.1);
  steering_.foresee(fleet, 10.0, 0.1);
  EXPECT_TRUE(fleet.vehicles()[0].traits.external);
  EXPECT_FALSE(fleet.vehicles()[1].traits.external);
}

}  // namespace
}  // namespace pedzone
