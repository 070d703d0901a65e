// The vehicles near a zone, and what people see of them.
#include "sumo/plan/fleet.hpp"

#include <gmock/gmock.h>

#include <random>
#include <tuple>

#include "fleet_fixture.hpp"

namespace pedzone {
namespace {

using test::FleetTest;

TEST_F(FleetTest, has_the_vehicles_within_sixty_metres_of_a_zone) {
  const Fleet fleet(network, zones());
  EXPECT_TRUE(fleet.near_zone({50.0 - 59.9, 0.0}));
  EXPECT_FALSE(fleet.near_zone({50.0 - 60.1, 0.0}));
  EXPECT_TRUE(fleet.near_zone({100.0, 2.0 + 59.9}));
  EXPECT_FALSE(fleet.near_zone({100.0, 2.0 + 60.1}));
}

TEST_F(FleetTest, has_a_train_of_which_both_ends_are_far_away) {
  const Fleet fleet(network, zones());
  const double y = 3.0;
  EXPECT_TRUE(fleet.near_zone({400.0, y}, {-200.0, y}));
  EXPECT_TRUE(fleet.near_zone({-200.0, y}, {400.0, y}));
  EXPECT_FALSE(fleet.near_zone({400.0, y}, {300.0, y}));
  EXPECT_FALSE(fleet.near_zone({400.0, 100.0}, {-200.0, 100.0}));
}

TEST_F(FleetTest, shows_each_zone_the_vehicles_near_it) {
  std::vector<Zone> two{zones()[0], zones()[0]};
  for (Vec2& corner : two[1].walkable[0].outer) corner += Vec2(1000.0, 0.0);
  const Fleet fleet(network, two);
  VehicleState here, there, long_one, train;
  here.centre = {60.0, 0.0};
  there.centre = {1060.0, 0.0};
  long_one.centre = {50.0 - 65.0, 0.0};  // its front is 59 m from the first zone
  long_one.length = 12.0;
  train.centre = {300.0, 0.0};
  train.length = 400.0;  // from 100 m to 500 m
  const std::vector<VehicleState> all{here, there, long_one, train};
  const auto centres_near = [&](std::size_t which) {
    std::vector<Vec2> centres;
    for (const VehicleState& state : fleet.states_near(which, all)) centres.push_back(state.centre);
    return centres;
  };
  EXPECT_THAT(centres_near(0), testing::ElementsAre(here.centre, long_one.centre, train.centre));
  EXPECT_THAT(centres_near(1), testing::ElementsAre(there.centre));
}

TEST_F(FleetTest, has_those_that_need_more_to_stop_too) {
  Lane& comes = network.lanes[lane_of(e0)];
  comes.speed = 13.89;
  EXPECT_FALSE(Fleet(network, zones()).near_zone({50.0 - 61.0, 0.0})) << "needs 35 m";
  comes.speed = 25.0;  // 69 m at 4.5 m/s2, 25 m in a second
  EXPECT_TRUE(Fleet(network, zones()).near_zone({50.0 - 94.0, 0.0}));
  EXPECT_FALSE(Fleet(network, zones()).near_zone({50.0 - 95.0, 0.0}));
  comes.speed = 13.89;
  zone.weather = find_weather("ice");  // a quarter of the deceleration: 86 m
  EXPECT_TRUE(Fleet(network, zones()).near_zone({50.0 - 99.0, 0.0}));
  EXPECT_FALSE(Fleet(network, zones()).near_zone({50.0 - 100.0, 0.0}));
  network.lanes[lane_of(e3)].speed = 40.0;  // leads out of it
  comes.vehicles = false;
  EXPECT_FALSE(Fleet(network, zones()).near_zone({50.0 - 61.0, 0.0}));
}

TEST_F(FleetTest, remembers_what_people_did_to_a_vehicle_while_it_is_near) {
  Fleet fleet(network, zones());
  fleet.update({car(60.0, 2.0)}, 0.1);
  FleetVehicle& vehicle = fleet.vehicles()[0];
  EXPECT_LT(vehicle.commanded, 0.0);
  vehicle.commanded = 1.5;
  vehicle.blocked_time = 7.0;
  vehicle.slowed = 3.0;
  vehicle.creeping = true;
  vehicle.claim = 8.0;
  fleet.update({test::seen_vehicle("other", {70.0, 0.0}, 2.0), car(60.2, 2.0)}, 0.1);
  const FleetVehicle &other = fleet.vehicles()[0], &same = fleet.vehicles()[1];
  EXPECT_EQ(other.blocked_time, 0.0);
  EXPECT_FALSE(other.creeping);
  EXPECT_EQ(std::tuple(same.commanded, same.blocked_time, same.slowed, same.creeping),
            std::tuple(1.5, 7.0, 3.0, true));
  EXPECT_EQ(same.claim, 0.0) << "is asked for anew in each step";
  fleet.update({}, 0.1);
  fleet.update({car(60.4, 2.0)}, 0.1);
  EXPECT_EQ(fleet.vehicles()[0].blocked_time, 0.0);
}

TEST_F(FleetTest, sees_from_two_places_that_a_vehicle_reverses) {
  const FleetVehicle back = moved(car(60.0, 2.0), car(59.8, 2.0), 0.1);
  EXPECT_TRUE(back.velocity.isApprox(Vec2(-2.0, 0.0)));
  EXPECT_TRUE(back.reverses);
  const FleetVehicle aside = moved(
      car(60.0, 2.0),
      [&] {
        VehicleSeen now = car(60.0, 2.0);
        now.front.y() = 0.2;
        return now;
      }(),
      0.1);
  EXPECT_TRUE(aside.velocity.isApprox(Vec2(0.0, 2.0)));
  EXPECT_FALSE(aside.reverses);
}

TEST(CameFromAhead, is_told_by_the_way_and_not_by_the_heading) {
  FleetVehicle vehicle;  // it turns round: its rear is still on the lane by which it came
  vehicle.traits.length = 4.0;
  vehicle.way = {{2.0, 0.0}, {4.0, 0.0}, {5.0, 1.0}, {4.0, 2.0}, {-30.0, 2.0}};
  vehicle.front = point_on(vehicle.way, 4.0).point;
  vehicle.heading = angle_of(vehicle.front - vehicle.way.front());
  const auto before = [&](double offset) { return point_on(vehicle.way, offset).point; };
  for (const double offset : {0.0, 2.5, 3.9, 4.0}) {
    EXPECT_FALSE(came_from_ahead(vehicle, before(offset))) << offset;
  }
  EXPECT_TRUE(came_from_ahead(vehicle, before(4.1)));
  EXPECT_TRUE(came_from_ahead(vehicle, before(6.0)));
}

TEST(CameFromAhead, not_where_the_way_back_lay_nearer_than_the_way_behind) {
  FleetVehicle vehicle;
  vehicle.traits.length = 4.0;
  vehicle.way = {{56.0, 0.0}, {64.0, 0.0}, {64.0, 3.2}, {30.0, 3.2}};
  EXPECT_FALSE(came_from_ahead(vehicle, {50.0, 0.0})) << "10 m in a step, and not 14 m back";
  EXPECT_TRUE(came_from_ahead(vehicle, {61.0, 0.1}));
}

TEST_F(FleetTest, takes_the_heading_for_the_way_of_one_that_hardly_moves) {
  EXPECT_TRUE(moved(car(60.0, 0.05), car(59.995, 0.05), 0.1).velocity.isApprox(Vec2(0.05, 0.0)));
  EXPECT_TRUE(one(car(60.0, 2.0)).velocity.isApprox(Vec2(2.0, 0.0)));
}

TEST_F(FleetTest, minds_the_first_zone_on_a_vehicles_way) {
  Zone first = zone, second = zone;
  first.lanes = {lane_of(e2)};
  second.lanes = {lane_of(e1)};
  const std::vector<Zone> both{first, second};
  Fleet fleet(network, both);
  VehicleSeen far = car(10.0, 0.0);  // on e0: its way ends before the zones
  far.lane = lane_of(e0);
  far.route_index = 0;
  fleet.update({car(90.0, 0.0), far}, 0.1);
  EXPECT_EQ(fleet.vehicles()[0].zone, 1);
  EXPECT_EQ(fleet.vehicles()[1].zone, 0);
}

TEST_F(FleetTest, shows_people_how_fast_a_vehicle_will_be_in_the_step) {
  FleetVehicle vehicle = one(car(60.0, 5.0));
  vehicle.traits.accel = 2.0;
  EXPECT_NEAR(state(vehicle, 0.5).velocity.x(), 6.0, 1e-9) << "it may accelerate";
  vehicle.allowed_speed = 5.4;
  EXPECT_NEAR(state(vehicle, 0.5).velocity.x(), 5.4, 1e-9) << "up to what is allowed";
  vehicle.allowed_speed = 3.0;
  EXPECT_NEAR(state(vehicle, 0.5).velocity.x(), 5.0, 1e-9) << "it need not brake for that at once";
  vehicle.commanded = 1.0;
  EXPECT_NEAR(state(vehicle, 0.5).velocity.x(), 1.0, 1e-9) << "as it was told";
  vehicle.stopped = true;
  EXPECT_NEAR(state(vehicle, 0.5).velocity.x(), 0.0, 1e-9) << "at its stop";
}

TEST_F(FleetTest, shows_people_that_nobody_drives_off_in_a_queue) {
  const auto behind = [&](double gap, double leaders_speed, double lateral = 0.0) {
    VehicleSeen leader = car(60.0, leaders_speed);
    leader.id = "leader";
    leader.front.y() += lateral;
    VehicleSeen follower = car(60.0 - leader.traits.length - gap, 0.5);
    const std::vector<Zone> all = zones();
    Fleet fleet(network, all);
    fleet.update({follower, leader}, 1.0);
    std::vector<VehicleState> states;
    fleet.states(1.0, states);
    return states.at(0).velocity.norm();
  };
  EXPECT_NEAR(behind(2.5, 0.0), 0.0, 1e-9) << "its minGap is all there is";
  EXPECT_NEAR(behind(4.5, 0.0), -4.5 + std::sqrt(4.5 * 4.5 + 2.0 * 4.5 * 2.0), 1e-9)
      << "what Krauss's model finds safe";
  EXPECT_GT(behind(2.5, 2.0), behind(2.5, 1.0)) << "behind one that drives it may";
  EXPECT_GT(behind(2.5, 0.0, 3.0), 3.0) << "not held by one beside its way";
  EXPECT_GT(behind(30.0, 0.0), 3.0);
}

TEST_F(FleetTest, shows_people_that_nobody_brakes_harder_in_a_queue_than_it_likes_to) {
  VehicleSeen leader = car(60.0, 0.0);
  leader.id = "leader";
  VehicleSeen follower = car(60.0 - leader.traits.length - leader.traits.min_gap, 5.0);
  const std::vector<Zone> all = zones();
  Fleet fleet(network, all);
  fleet.update({follower, leader}, 1.0);
  std::vector<VehicleState> states;
  fleet.states(1.0, states);
  EXPECT_NEAR(states.at(0).velocity.norm(), 5.0 - follower.traits.decel, 1e-9);
}

TEST_F(FleetTest, follows_a_long_vehicle_in_whatever_direction) {
  constexpr double kGap = 9.0, kLength = 18.0;  // [m]
  const std::vector<Zone> all = zones();
  for (int k = 0; k < 16; ++k) {
    VehicleSeen follower = test::seen_vehicle("follower", {50.0, 0.0}, 0.0);
    follower.heading = wrap_angle(k * kPi / 8.0);
    VehicleSeen leader = follower;
    leader.id = "leader";
    leader.traits.length = kLength;
    leader.front += unit(follower.heading) * (kGap + kLength);
    Fleet fleet(network, all);
    fleet.update({follower, leader}, 0.1);
    const double decel = follower.traits.decel, room = kGap - follower.traits.min_gap;
    EXPECT_NEAR(fleet.vehicles()[0].follows_at, -decel + std::sqrt(decel * (decel + 2.0 * room)),
                1e-6)
        << k;
    EXPECT_GT(fleet.vehicles()[1].follows_at, 1e9) << "the leader follows nobody";
    ASSERT_TRUE(fleet.vehicles()[0].leader) << k;
    EXPECT_EQ(fleet.vehicles()[0].leader->index, 1u) << k;
    EXPECT_NEAR(fleet.vehicles()[0].leader->gap, kGap, 1e-6) << k;
    EXPECT_FALSE(fleet.vehicles()[1].leader) << k;
  }
}

TEST_F(FleetTest, follows_among_many_as_the_slowest_of_each_pair_alone_lets_it) {
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<VehicleSeen> all;
  for (int i = 0; i < 40; ++i) {  // on no lane, so that all go straight on
    all.push_back(test::seen_vehicle(std::to_string(i), {between(0.0, 80.0), between(0.0, 80.0)},
                                     between(0.0, 15.0)));
    all.back().heading = between(-kPi, kPi);
    all.back().traits.length = between(1.0, 20.0);
  }
  const std::vector<Zone> zone_list = zones();
  Fleet together(network, zone_list);
  together.update(all, 0.1);
  int followers = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    double slowest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (i == j) continue;
      Fleet pair(network, zone_list);
      pair.update({all[i], all[j]}, 0.1);
      slowest = std::min(slowest, pair.vehicles()[0].follows_at);
    }
    EXPECT_EQ(together.vehicles()[i].follows_at, slowest) << i;
    followers += slowest < 1e9;
  }
  EXPECT_GT(followers, 10);
}

TEST_F(FleetTest, shows_people_how_sure_it_is_where_a_vehicle_gets_to) {
  VehicleSeen seen = car(70.0, 6.0);
  seen.allowed_speed = 14.0;
  FleetVehicle vehicle = one(seen);
  vehicle.follows_at = 5.0;
  const VehicleState free = state(vehicle, 1.0);
  EXPECT_NEAR(free.velocity.norm(), 5.0, 1e-9);
  EXPECT_NEAR(free.slower, 5.0 - (6.0 - 4.5), 1e-9) << "SUMO may brake it as it likes to brake";
  EXPECT_NEAR(free.lead, 6.0 + 2.6, 1e-9) << "or not mind the one ahead";
  EXPECT_EQ(free.starts, 0.0);
  vehicle.commanded = 4.0;
  EXPECT_NEAR(state(vehicle, 1.0).lead, 4.0, 1e-9) << "it obeys";
  EXPECT_NEAR(state(vehicle, 0.1).lag, 0.0, 0.0) << "counted by the crowd";
  vehicle.commanded = -1.0;
  vehicle.speed = 0.0;
  vehicle.waits = true;
  const VehicleState waiting = state(vehicle, 1.0);
  EXPECT_EQ(waiting.velocity.norm(), 0.0);
  EXPECT_EQ(waiting.lead, 0.0) << "people cross before one that waits";
  EXPECT_NEAR(waiting.starts, 2.6, 1e-9);
  vehicle.stopped = true;
  EXPECT_EQ(state(vehicle, 1.0).starts, 0.0) << "at its own stop";
}

TEST_F(FleetTest, shows_people_where_one_gets_to_whose_speed_changes_evenly_within_a_step) {
  FleetVehicle vehicle = one(car(70.0, 6.0));
  vehicle.traits.ballistic = true;
  vehicle.allowed_speed = 14.0;
  const VehicleState free = state(vehicle, 1.0);
  EXPECT_NEAR(free.velocity.norm(), 6.0 + 0.5 * 2.6, 1e-9);
  EXPECT_NEAR(free.lead, 6.0 + 0.5 * 2.6, 1e-9);
  EXPECT_NEAR(free.slower, 0.5 * (2.6 + 4.5), 1e-9);
  vehicle.commanded = 0.0;
  EXPECT_NEAR(state(vehicle, 1.0).velocity.norm(), 3.0, 1e-9) << "it does not stop at once";
}

TEST_F(FleetTest, shows_people_that_a_vehicle_speeds_up) {
  for (const double dt : {0.1, 0.2, 1.0}) {
    Fleet fleet(network, zones());
    std::vector<VehicleState> states;
    const auto look = [&](double speed) {
      VehicleSeen seen = car(60.0, speed);
      seen.traits.accel = 1.5;
      seen.allowed_speed = 50.0;
      fleet.update({seen}, dt);
      fleet.states(dt, states);
      return states.at(0);
    };
    EXPECT_EQ(look(3.0).gain, 0.0) << "just seen";
    double speed = 3.0;
    for (double time = 0.0; time < 6.0; time += dt) look(speed += 1.5 * dt);
    const VehicleState faster = look(speed += 1.5 * dt);
    const double mean = speed + 0.5 * 1.5;  // of the next second
    EXPECT_NEAR(faster.velocity.norm() + faster.gain, std::max(mean, speed + 1.5 * dt), 0.01) << dt;
    for (double time = 0.0; time < 3.0; time += dt) look(speed -= 1.5 * dt);
    EXPECT_EQ(look(speed).gain, 0.0) << "it has braked";
  }
}

TEST_F(FleetTest, shows_people_no_gain_of_one_that_is_told_to_brake) {
  FleetVehicle vehicle = one(car(60.0, 5.0));
  vehicle.gain = SpeedGain(3.0);
  vehicle.gain.follow(5.0, 1.0);
  vehicle.commanded = 5.1;
  EXPECT_GT(state(vehicle, 0.1).gain, 0.3);
  vehicle.commanded = 4.9;
  EXPECT_EQ(state(vehicle, 0.1).gain, 0.0);
}

TEST_F(FleetTest, shows_people_where_a_vehicle_turns) {
  FleetVehicle vehicle = one(car(60.0, 5.0));
  vehicle.way = {{56.0, 0.0}, {60.0, 0.0}, {60.0, 30.0}};
  EXPECT_TRUE(state(vehicle, 0.5).forwards);
  EXPECT_GT(state(vehicle, 0.5).yaw_rate, 0.1) << "to the left is positive";
  vehicle.way.back().y() = -30.0;
  EXPECT_LT(state(vehicle, 0.5).yaw_rate, -0.1);
}

TEST_F(FleetTest, shows_people_one_that_reverses_or_is_steered_by_others_as_it_moves_now) {
  FleetVehicle vehicle = one(car(60.0, 5.0));
  vehicle.velocity = {-5.0, 0.0};
  vehicle.reverses = true;
  EXPECT_TRUE(state(vehicle, 0.5).velocity.isApprox(Vec2(-5.0, 0.0)));
  EXPECT_FALSE(state(vehicle, 0.5).forwards);
  vehicle.velocity = {0.0, 3.0};
  vehicle.yaw_rate = 0.7;
  vehicle.traits.external = true;
  EXPECT_TRUE(state(vehicle, 0.5).velocity.isApprox(Vec2(0.0, 3.0)));
  EXPECT_EQ(state(vehicle, 0.5).yaw_rate, 0.7);
}

TEST_F(FleetTest, touches_whom_a_body_overlaps) {
  Fleet fleet(network, zones());
  fleet.update({car(60.0, 0.0)}, 0.1);
  EXPECT_TRUE(fleet.touches({58.0, 1.2}, 0.24));
  EXPECT_FALSE(fleet.touches({58.0, 1.3}, 0.24));
  EXPECT_TRUE(fleet.touches({55.8, 0.0}, 0.24)) << "behind its rear";
}

TEST_F(FleetTest, approaches_a_place_by_seconds_and_not_by_metres) {
  for (const auto& [speed, ahead, comes] :
       {std::tuple{4.0, 19.0, true}, {4.0, 23.0, false}, {2.0, 9.0, true}, {2.0, 13.0, false}}) {
    Fleet fleet(network, zones());
    fleet.update({car(60.0, speed)}, 0.1);
    EXPECT_EQ(fleet.approaches({60.0 + ahead, 0.0}, 0.5, 5.0), comes) << speed << ' ' << ahead;
    EXPECT_FALSE(fleet.approaches({60.0 - ahead, 0.0}, 0.5, 5.0)) << "behind it";
  }
}

TEST_F(FleetTest, one_that_waits_does_not_approach) {
  Fleet fleet(network, zones());
  fleet.update({car(60.0, 0.3)}, 0.1);
  EXPECT_FALSE(fleet.approaches({60.5, 0.0}, 0.6, 5.0));
  EXPECT_NE(fleet.waiting_beside({60.5, 0.0}, 0.6), nullptr);
  EXPECT_EQ(fleet.waiting_beside({60.7, 0.0}, 0.6), nullptr) << "too far away";
  fleet.vehicles()[0].speed = 0.6;
  EXPECT_EQ(fleet.waiting_beside({60.5, 0.0}, 0.6), nullptr) << "it moves";
  EXPECT_TRUE(fleet.approaches({60.5, 0.0}, 0.6, 5.0));
}

TEST_F(FleetTest, one_that_is_parked_does_not_wait) {
  Fleet fleet(network, zones());
  VehicleSeen parked = car(60.0, 0.0);
  parked.stopped = true;
  fleet.update({parked}, 0.1);
  EXPECT_EQ(fleet.waiting_beside({60.5, 0.0}, 0.6), nullptr);
}

TEST_F(FleetTest, has_the_grip_of_the_worst_weather) {
  EXPECT_EQ(Fleet(network, zones()).grip(), 1.0);
  Zone icy = zone;
  icy.weather = find_weather("ice");
  EXPECT_EQ(Fleet(network, {zone, icy}).grip(), icy.weather->deceleration);
  EXPECT_LT(icy.weather->deceleration, 1.0);
}

}  // namespace
}  // namespace pedzone
