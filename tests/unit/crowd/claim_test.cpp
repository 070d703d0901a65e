// A vehicle that people hold up claims the room ahead of it.
#include <gmock/gmock.h>

#include <utility>
#include <vector>

#include "crowd/sense/claim_room.hpp"
#include "crowd/sense/side_room.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

/// A standing shuttle with its front at x = 0 that asks for 8 m along +x.
struct Claimant {
  Polyline way{{-4.0, 0.0}, {0.0, 0.0}, {40.0, 0.0}};
  VehicleState vehicle = vehicle_at({-2.0, 0.0}, 0.0, 0.0, 4.0, 2.0);
  Claimant() {
    vehicle.way = way;
    vehicle.claim = 8.0;
  }
};

TEST(PlaceInClaim, is_ahead_of_the_bumper_and_between_the_sides) {
  const Claimant shuttle;
  const auto place = place_in_claim(shuttle.vehicle, {3.0, 0.5}, 0.24);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->ahead, 3.0, 1e-9);
  EXPECT_NEAR(place->lateral, 0.5, 1e-9);
  EXPECT_FALSE(place_in_claim(shuttle.vehicle, {9.0, 0.0}, 0.24)) << "beyond";
  EXPECT_FALSE(place_in_claim(shuttle.vehicle, {-2.0, 1.1}, 0.24)) << "beside the body";
  EXPECT_FALSE(place_in_claim(shuttle.vehicle, {3.0, 1.3}, 0.24)) << "beside the way";
}

TEST(PlaceInClaim, follows_the_vehicles_way_round_a_bend) {
  Claimant shuttle;
  shuttle.way = {{-4.0, 0.0}, {0.0, 0.0}, {3.0, 0.0}, {3.0, 30.0}};
  shuttle.vehicle.way = shuttle.way;
  EXPECT_TRUE(place_in_claim(shuttle.vehicle, {3.0, 4.0}, 0.24));
  EXPECT_FALSE(place_in_claim(shuttle.vehicle, {7.0, 0.0}, 0.24));
}

/// People in a street along x, `half_width` to either side of the vehicle's way.
class ClaimScene {
 public:
  explicit ClaimScene(double half_width)
      : zone_(zone_of(box(-30.0, -half_width, 60.0, half_width))), scene_(zone_) {}

  std::size_t add(const Vec2& from, const Vec2& to) {
    return scene_.add(from, Destination{to, to}, 1.3, 0.0);
  }
  void park(const VehicleState& other) { parked_.push_back(other); }
  void run(double seconds) {
    for (double t = 0.0; t < seconds; t += 0.1) {
      scene_.vehicles = parked_;
      scene_.vehicles.push_back(shuttle_.vehicle);
      scene_.step();
    }
  }
  bool in_the_way(std::size_t person) const {
    return place_in_claim(shuttle_.vehicle, scene_.people[person].view.position, 0.24).has_value();
  }
  const PersonView& view(std::size_t person) const { return scene_.people[person].view; }

 private:
  Claimant shuttle_;
  std::vector<VehicleState> parked_;
  Zone zone_;
  Scene scene_;
};

TEST(Claim, people_in_the_way_step_out_of_it) {
  ClaimScene scene(6.0);
  std::vector<std::size_t> people;
  for (int i = 0; i < 6; ++i) people.push_back(scene.add({1.5 + i, 0.3 * (i % 3) - 0.3}, {-20, 0}));
  scene.run(6.0);
  for (const std::size_t person : people) EXPECT_FALSE(scene.in_the_way(person)) << person;
}

TEST(Claim, people_step_out_on_the_side_on_which_they_stand) {
  for (const double y : {0.4, -0.4}) {
    ClaimScene scene(6.0);
    const std::size_t person = scene.add({4.0, y}, {-20.0, 0.0});
    for (int k = 0; k < 12; ++k) {
      scene.run(0.25);
      EXPECT_GT(scene.view(person).position.y() * (y > 0.0 ? 1.0 : -1.0), 0.35) << y;
    }
    EXPECT_FALSE(scene.in_the_way(person)) << y;
  }
}

TEST(Claim, nobody_steps_into_it) {
  ClaimScene scene(6.0);
  const std::size_t person = scene.add({4.0, 4.0}, {4.0, -5.0});
  for (int i = 0; i < 20; ++i) {
    scene.run(0.5);
    EXPECT_FALSE(scene.in_the_way(person));
  }
  EXPECT_EQ(scene.view(person).motion, Motion::kWaiting);
}

TEST(Claim, without_room_beside_people_walk_ahead_of_the_vehicle) {
  ClaimScene scene(1.2);  // the shuttle is 2 m wide
  const std::size_t person = scene.add({2.0, 0.0}, {-20.0, 0.0});
  scene.run(4.0);
  EXPECT_GT(scene.view(person).position.x(), 5.0);
}

TEST(Claim, nobody_steps_out_to_where_another_vehicle_stands) {
  ClaimScene scene(6.0);
  scene.park(vehicle_at({1.0, 2.2}, kPi, 0.0, 9.0, 2.0));  // from y = 1.2 on
  const std::size_t person = scene.add({1.0, 0.6}, {1.0, 5.0});
  scene.run(10.0);
  EXPECT_FALSE(scene.in_the_way(person)) << scene.view(person).position.transpose();
}

/// A bus turns right. Its rear will sweep all the room on the inside, up to the zone's border; who
/// is there has to go on before it.
TEST(Claim, nobody_steps_out_to_where_the_rear_will_swing) {
  const Zone zone = zone_of(
      Ring{{-20.0, -1.6}, {-1.0, -1.6}, {0.7, -0.6}, {12.0, 6.0}, {12.0, 15.0}, {-20.0, 15.0}});
  const Polyline way{{-8.0, -3.1}, {-6.1, 0.2}, {-4.1, 2.9}, {-2.0, 3.8},  {-0.7, 3.2},
                     {0.0, 2.9},   {0.3, 2.6},  {2.1, 0.2},  {15.6, -23.1}};
  VehicleState bus = vehicle_at(Vec2(0.3, 2.6) - 6.0 * unit(0.6), 0.6, 0.0, 12.0, 2.5);
  bus.way = way;
  bus.claim = 8.0;
  Scene scene(zone);
  const Destination there{{5.0, 4.0}, {5.0, 4.0}};
  const std::size_t person = scene.add({0.7, 0.9}, there, 1.3, 0.0);
  for (int i = 0; i < 80 && scene.people[person].arrival_time <= 0.0; ++i) {
    scene.vehicles = {bus};
    scene.step();
  }
  EXPECT_FALSE(holds_up(bus, scene.people[person].view.position, 0.24));
}

TEST(Claim, people_cross_once_it_is_gone) {
  const Zone zone = zone_of(box(-30.0, -6.0, 60.0, 6.0));
  Scene scene(zone);
  const std::size_t person = scene.add({4.0, 4.0}, Destination{{4.0, -5.0}, {4.0, -5.0}}, 1.3, 0.0);
  Claimant shuttle;
  for (int i = 0; i < 50; ++i) {
    scene.vehicles = {shuttle.vehicle};
    scene.step();
  }
  ASSERT_GT(scene.people[person].view.position.y(), 1.0);
  scene.vehicles.clear();
  scene.run(60.0);
  EXPECT_GT(scene.people[person].arrival_time, 0.0);
}

/// A van eastwards and a shuttle westwards come past each other in a street 6 m wide: the room that
/// people leave beside the one is the other's.
class TwoClaims {
 public:
  TwoClaims(double van_claimed, double shuttle_claimed) {
    van_.way = eastwards_;
    shuttle_.way = westwards_;
    van_.claim = shuttle_.claim = 8.0;
    van_.claimed = van_claimed;
    shuttle_.claimed = shuttle_claimed;
    van_.key = 1;
    shuttle_.key = 2;
  }

  /// Whether somebody who stands at `from` is out of the van's, the shuttle's claim after 6 s.
  std::pair<bool, bool> clears(const Vec2& from) {
    Scene scene(zone_);
    const Vec2 to(40.0, 0.0);
    const std::size_t person = scene.add(from, Destination{to, to}, 1.3, 0.0);
    for (int k = 0; k < 60; ++k) {
      scene.vehicles = {van_, shuttle_};
      scene.step();
    }
    const Vec2 there = scene.people[person].view.position;
    return {!place_in_claim(van_, there, 0.6), !place_in_claim(shuttle_, there, 0.6)};
  }

 private:
  Zone zone_ = zone_of(box(-30.0, -3.0, 60.0, 3.0));
  Polyline eastwards_{{-5.0, -1.5}, {0.0, -1.5}, {40.0, -1.5}};
  Polyline westwards_{{11.0, 1.5}, {7.0, 1.5}, {-30.0, 1.5}};
  VehicleState van_ = vehicle_at({-2.5, -1.5}, 0.0, 0.0, 5.0, 1.9);
  VehicleState shuttle_ = vehicle_at({9.0, 1.5}, kPi, 0.0, 4.0, 2.0);
};

TEST(Claim, of_two_that_meet_the_one_that_has_claimed_for_longer_is_let_through_first) {
  const Vec2 in_both(4.0, 0.0);
  EXPECT_TRUE(TwoClaims(20.0, 10.0).clears(in_both).first);
  EXPECT_TRUE(TwoClaims(10.0, 20.0).clears(in_both).second);
  EXPECT_TRUE(TwoClaims(10.0, 10.0).clears(in_both).first) << "the lower key";
}

TEST(Claim, the_claim_of_the_second_does_not_hold_back_who_leaves_that_of_the_first) {
  EXPECT_TRUE(TwoClaims(20.0, 10.0).clears({4.0, -0.4}).first);
  EXPECT_TRUE(TwoClaims(10.0, 20.0).clears({4.0, 0.4}).second);
}

}  // namespace
}  // namespace pedzone::test
