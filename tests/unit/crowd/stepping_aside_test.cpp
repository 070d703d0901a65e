// Narrow streets: people and vehicles that cannot both stay where they are.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <utility>

#include "crowd/sense/side_room.hpp"
#include "crowd/sense/vehicle_motion.hpp"
#include "scene.hpp"
#include "world/speeds.hpp"

namespace pedzone::test {
namespace {

constexpr double kRadius = 0.24, kTurned = 0.12;  // [m]

/// A street along x with a vehicle in its middle, `beside` [m] from its sides to the walls.
class NarrowStreet {
 public:
  NarrowStreet(double beside, double claim, double speed = 0.0)
      : NarrowStreet(zone_of(box(-30.0, -1.0 - beside, 60.0, 1.0 + beside)), claim, speed) {}
  /// Of another shape.
  NarrowStreet(Zone zone, double claim, double speed = 0.0)
      : zone_(std::move(zone)), scene_(zone_) {
    vehicle_ = vehicle_at({-2.0, 0.0}, 0.0, speed, 4.0, 2.0);
    vehicle_.way = way_;
    vehicle_.claim = claim;
  }

  std::size_t add(const Vec2& from, const Vec2& to, double speed = 1.3) {
    return scene_.add(from, Destination{to, to}, speed, 0.0);
  }
  void run(double seconds) {
    for (double t = 0.0; t < seconds; t += 0.1) {
      scene_.vehicles = {vehicle_};
      scene_.step();
      least_ = std::min(least_, distance_to(vehicle_, view(0).position));
      for (const VehiclePush& push : scene_.crowd.pushes()) runs_into_ |= push.run_into;
      vehicle_.centre += vehicle_.velocity * 0.1;
    }
  }
  void drive_on(double speed) { vehicle_.velocity = {speed, 0.0}; }
  bool runs_into_anybody() const { return runs_into_; }
  const PersonView& view(std::size_t person) const { return scene_.people[person].view; }
  const Scene& scene() const { return scene_; }
  double least_distance_so_far() const { return least_; }

 private:
  Polyline way_{{-4.0, 0.0}, {0.0, 0.0}, {40.0, 0.0}};
  VehicleState vehicle_;
  Zone zone_;
  Scene scene_;
  double least_ = 1e9;  ///< [m]
  bool runs_into_ = false;
};

TEST(SteppingAside, turned_at_the_wall_people_leave_room_for_the_vehicle) {
  NarrowStreet street(0.52, 8.0);  // a van in a lane of 3.2 m
  street.add({3.0, 0.1}, {-20.0, 0.0});
  street.run(5.0);
  const PersonView& person = street.view(0);
  EXPECT_NEAR(person.position.x(), 3.0, 0.5) << "has no need to walk ahead of it";
  EXPECT_GE(std::abs(person.position.y()), 1.0 + kRadius + 0.05);
  EXPECT_LT(person.radius, 0.6 * kRadius);
  EXPECT_EQ(person.motion, Motion::kWaiting);
}

TEST(SteppingAside, who_goes_back_does_not_depend_on_the_order_of_those_who_come) {
  const auto places = [](const std::vector<std::uint64_t>& order) {
    const Zone zone = zone_of(box(0.0, -1.2, 40.0, 1.2));
    Scene scene(zone);
    std::array<std::size_t, 4> index{};
    for (const std::uint64_t key : order) {
      const bool east = key == 1;
      NewPerson person;
      person.key = key;
      person.position = {east ? 17.0 : key == 2 ? 21.0 : 24.6, 0.9};
      person.destination = east ? Destination{{38, 0}, {38, 0}} : Destination{{2, 0}, {2, 0}};
      person.preferred_speed = 1.2;
      person.heading = east ? 0.0 : kPi;
      index[key] = scene.add(person);
    }
    scene.vehicles = {vehicle_at({20.0, -0.3}, 0.0, 0.0, 10.0, 1.8)};
    scene.run(5.0);
    std::vector<double> found;
    for (std::size_t key = 1; key < 4; ++key) {
      found.push_back(scene.people[index[key]].view.position.x());
      found.push_back(scene.people[index[key]].view.position.y());
    }
    return found;
  };
  EXPECT_EQ(places({1, 2, 3}), places({1, 3, 2}));
  EXPECT_EQ(places({1, 2, 3}), places({3, 2, 1}));
}

TEST(SteppingAside, past_a_vehicle_that_they_cannot_let_by_people_go_themselves) {
  NarrowStreet street(0.35, 8.0);  // a bus in a lane of 3.2 m
  const std::size_t person = street.add({2.0, 0.1}, {-20.0, 0.0});
  street.run(25.0);
  EXPECT_GT(street.scene().people[person].arrival_time, 0.0);
  EXPECT_GT(street.least_distance_so_far(), kTurned);
}

TEST(SteppingAside, a_parked_vehicle_is_passed_in_the_same_way) {
  for (const double from : {6.0, -10.0}) {
    NarrowStreet street(0.35, 0.0);
    const std::size_t person = street.add({from, 0.0}, {from > 0.0 ? -20.0 : 20.0, 0.0});
    street.run(40.0);
    EXPECT_GT(street.scene().people[person].arrival_time, 0.0) << from;
  }
}

TEST(SteppingAside, who_squeezes_past_a_vehicle_is_not_run_into_where_it_creeps_on) {
  NarrowStreet street(0.35, 0.0);
  street.add({3.0, 0.0}, {-20.0, 0.0});
  while (street.view(0).position.x() > -1.0) street.run(0.1);
  ASSERT_LT(street.least_distance_so_far(), 0.9 * kRadius) << "it has turned";
  street.drive_on(kSqueezeSpeed);
  street.run(3.0);
  EXPECT_LT(street.view(0).position.x(), -2.0);
  EXPECT_FALSE(street.runs_into_anybody());
}

TEST(SteppingAside, nobody_goes_past_where_a_turned_body_does_not_fit) {
  NarrowStreet street(0.25, 0.0);
  const std::size_t person = street.add({6.0, 0.0}, {-20.0, 0.0});
  street.run(20.0);
  EXPECT_LT(street.scene().people[person].arrival_time, 0.0);
  EXPECT_GT(street.view(person).position.x(), 0.0);
}

TEST(SteppingAside, of_two_that_meet_beside_a_vehicle_one_goes_back) {
  NarrowStreet street(0.35, 0.0);
  const std::size_t first = street.add({-0.5, 1.17}, {-20.0, 0.0});
  const std::size_t second = street.add({-3.0, 1.17}, {20.0, 0.0});
  street.run(60.0);
  EXPECT_GT(street.scene().people[first].arrival_time, 0.0);
  EXPECT_GT(street.scene().people[second].arrival_time, 0.0);
}

TEST(SteppingAside, who_holds_up_a_vehicle_from_beside_does_not_wait_for_it) {
  NarrowStreet street(0.35, 8.0);
  street.add({-0.6, 1.17}, {20.0, 0.0});
  street.run(10.0);
  EXPECT_GT(street.view(0).position.x(), 1.0) << "it could not drive past";
}

TEST(SteppingAside, nobody_waits_before_a_vehicle_for_who_comes_out_where_there_is_room_aside) {
  const Ring widens_at_its_front{{-30.0, -1.35}, {0.2, -1.35}, {0.2, -5.0}, {30.0, -5.0},
                                 {30.0, 5.0},    {0.2, 5.0},   {0.2, 1.35}, {-30.0, 1.35}};
  constexpr double kHardly = 0.01;  // [m/s]
  NarrowStreet street(zone_of(widens_at_its_front), 8.0);
  street.add({1.0, 0.0}, {-20.0, 0.0});
  street.add({-0.5, 1.17}, {20.0, 0.0}, kHardly);
  street.run(6.0);
  EXPECT_GT(std::abs(street.view(0).position.y()), 1.0 + kRadius)
      << "the vehicle can drive on, and make room for both";
}

TEST(SteppingAside, behind_a_vehicle_that_claims_room_who_comes_out_finds_the_end_free) {
  NarrowStreet street(0.35, 8.0);
  constexpr double kHardly = 0.01;  // [m/s]
  const std::size_t waits = street.add({-4.5, 0.9}, {20.0, 0.0});
  street.add({-3.5, 1.17}, {-20.0, 0.0}, kHardly);
  street.run(2.0);  // then it finds the other side
  EXPECT_LT(street.view(waits).position.x(), -4.0 - kRadius - 0.65) << "0.7 m are left free";
}

/// A street of 3.2 m with a corner, between walls: a van with its front at the corner is about to
/// turn left. Its rear will sweep all the room on the inner side.
class TightCorner : public ::testing::Test {
 protected:
  TightCorner() {
    van_ = vehicle_at({-3.25, 0.0}, 0.0, 0.0, 6.5, 2.16);
    van_.way = way_;
    van_.claim = 8.0;
  }
  std::size_t add(const Vec2& from, const Vec2& to) {
    return scene_.add(from, Destination{to, to}, 1.3, 0.0);
  }
  Vec2 place_after(double seconds, std::size_t person) {
    for (double t = 0.0; t < seconds; t += 0.1) {
      scene_.vehicles = {van_};
      scene_.step();
    }
    return scene_.people[person].view.position;
  }

  VehicleState van_;

 private:
  const Polyline way_{{-6.5, 0.0}, {0.0, 0.0}, {20.0, 34.64}};
  const Zone zone_ = zone_of(Ring{
      {-40.0, -1.6}, {0.92, -1.6}, {20.92, 33.04}, {19.08, 36.24}, {-0.92, 1.6}, {-40.0, 1.6}});
  Scene scene_{zone_};
};

TEST_F(TightCorner, who_is_beside_the_vehicle_steps_back_out_of_its_sweep) {
  const std::size_t person = add({-3.0, 1.34}, {17.0, 30.0});
  EXPECT_TRUE(comes_within(van_, place_after(0.1, person), 0.01));
  const Vec2 there = place_after(10.0, person);
  EXPECT_LT(there.x(), -5.0) << "where its rear is";
  EXPECT_FALSE(comes_within(van_, there, kTurned + 0.05));
}

TEST_F(TightCorner, who_cannot_step_back_for_others_goes_on_before_the_vehicle) {
  const std::size_t person = add({-3.0, 1.34}, {17.0, 30.0});
  for (int k = 1; k < 8; ++k) add({-3.0 - 0.6 * k, 1.34}, {17.0, 30.0});
  EXPECT_GT(place_after(10.0, person).x(), 1.0);
}

TEST(SideRoom, swings_over_who_stands_behind_the_corner) {
  VehicleState vehicle = vehicle_at({-2.0, 0.0}, 0.0, 0.0, 4.0, 2.0);
  const Polyline left{{-4.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 30.0}};
  vehicle.way = left;
  EXPECT_TRUE(swings_over(vehicle, {-0.5, 1.4}, kRadius)) << "the body cuts the corner";
  EXPECT_FALSE(swings_over(vehicle, {-3.5, 1.4}, kRadius));
  EXPECT_FALSE(swings_over(vehicle, {-0.5, -2.0}, kRadius));
  const WallIndex open(Region{Polygon{box(-20.0, -20.0, 20.0, 20.0), {}}});
  const auto place = place_clear({open, {}}, vehicle, {-0.5, 1.4}, {kRadius, kTurned}, 0.5 * kPi);
  ASSERT_TRUE(place);
  EXPECT_FALSE(swings_over(vehicle, *place, kRadius));
  EXPECT_LT((*place - Vec2(-0.5, 1.4)).norm(), 4.0);
}

TEST(SideRoom, is_clear_where_nobody_stands_on_the_way_there) {
  VehicleState vehicle = vehicle_at({-2.0, 0.0}, 0.0, 0.0, 4.0, 2.0);
  const Polyline left{{-4.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 30.0}};
  vehicle.way = left;
  const WallIndex open(Region{Polygon{box(-20.0, -20.0, 20.0, 20.0), {}}});
  const Vec2 here(-0.5, 1.4);
  const BodyBeside body{kRadius, kTurned};
  const auto nearest = place_clear({open, {}}, vehicle, here, body, 0.5 * kPi);
  ASSERT_TRUE(nearest);
  const std::vector<OtherBody> other{{0.5 * (here + *nearest), kTurned}};
  const auto place = place_clear({open, {}, other}, vehicle, here, body, 0.5 * kPi);
  ASSERT_TRUE(place);
  EXPECT_FALSE(swings_over(vehicle, *place, kRadius));
  const Vec2 along = (*place - here).normalized(), to = other[0].position - here;
  EXPECT_TRUE(to.dot(along) <= 0.0 || std::abs(cross(along, to)) >= 2.0 * kTurned);
}

TEST(SideRoom, is_clear_where_no_other_vehicle_stands_on_the_way_there) {
  const WallIndex open(Region{Polygon{box(-20.0, -20.0, 20.0, 20.0), {}}});
  const Polyline left{{-4.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 30.0}};
  std::vector<VehicleState> vehicles{vehicle_at({-2.0, 0.0}, 0.0, 0.0, 4.0, 2.0)};
  vehicles[0].way = left;
  const Vec2 here(-0.5, 1.4);
  const BodyBeside body{kRadius, kTurned};
  const auto nearest = place_clear({open, {}}, vehicles[0], here, body, 0.5 * kPi);
  ASSERT_TRUE(nearest);
  const Vec2 way = *nearest - here, middle = here + 0.5 * way;
  vehicles.push_back(vehicle_at(middle, angle_of(left_of(way)), 0.0, 1.0, 0.1));
  const std::vector<Rectangle> others{rectangle_of(vehicles[1])};
  const auto place = place_clear({open, others}, vehicles[0], here, body, 0.5 * kPi);
  ASSERT_TRUE(place);
  EXPECT_FALSE(swings_over(vehicles[0], *place, kRadius));
  EXPECT_FALSE(runs_through(rectangle_of(vehicles[1]), here, *place));
}

TEST(SideRoom, is_not_where_another_vehicle_stands) {
  const WallIndex open(Region{Polygon{box(-20.0, -5.0, 20.0, 5.0), {}}});
  std::vector<VehicleState> vehicles{vehicle_at({-2.0, 0.0}, 0.0, 0.0, 4.0, 2.0),
                                     vehicle_at({0.0, 2.2}, kPi, 0.0, 4.0, 2.0)};
  const std::vector<Rectangle> others{rectangle_of(vehicles[1])};
  const BodyBeside body{kRadius, kTurned};
  EXPECT_TRUE(way_beside({open, {}}, vehicles[0], 1.0, body));
  EXPECT_FALSE(way_beside({open, others}, vehicles[0], 1.0, body)) << "0.2 m between them";
  EXPECT_TRUE(way_beside({open, others}, vehicles[0], -1.0, body));
  const Polyline way{{-4.0, 0.0}, {0.0, 0.0}, {40.0, 0.0}};
  vehicles[0].way = way;
  const Vec2 here(1.0, 0.9);
  const auto alone = place_aside({open, {}}, vehicles[0], here, body, 0.7);
  ASSERT_TRUE(alone);
  EXPECT_GT(alone->y(), 1.0) << "the nearer side";
  const auto place = place_aside({open, others}, vehicles[0], here, body, 0.7);
  ASSERT_TRUE(place);
  EXPECT_GT(distance_to(vehicles[1], *place), kTurned);
}

TEST(SideRoom, nobody_beside_a_vehicle_steps_aside_through_it) {
  const WallIndex street(Region{Polygon{box(-20.0, -1.3, 20.0, 5.0), {}}});
  VehicleState vehicle = vehicle_at({-2.0, 0.0}, 0.0, 0.0, 4.0, 2.0);
  const Polyline way{{-4.0, 0.0}, {0.0, 0.0}, {40.0, 0.0}};
  vehicle.way = way;
  const Vec2 here(-0.2, -1.15);
  const auto place = place_aside({street, {}}, vehicle, here, {kRadius, kTurned}, 0.7);
  ASSERT_TRUE(place);
  EXPECT_GT(place->y(), 1.0) << "no room on this side";
  EXPECT_GT(place->x(), 0.0) << "round the front";
}

}  // namespace
}  // namespace pedzone::test
