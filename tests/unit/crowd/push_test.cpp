// Vehicles move people no faster than people step, and what they do to whom is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "crowd/push_log.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kStepping = 3.0;  // [m/s] the limit
constexpr double kRadius = 0.24, kStep = 0.1;
constexpr double kRounding = 1e-6;  // [m] radii are kept as floats
constexpr double kFront = 2.5;      // [m] of a vehicle, from its centre

std::unique_ptr<WalkingModel> standing_model() { return fixed_model({0.0, 0.0, 10.0, false}); }

/// Room [m] that is kept to a vehicle that drives straight: 5 cm, and 40 ms of its way.
double gap_at(double speed) { return 0.05 + 0.04 * speed; }

/// What happens in a scene.
struct Pushes {
  PushLog log;
  double way = 0.0, fastest = 0.0;

  void run(Scene& scene, double until, double dt = kStep) {
    while (scene.time < until - 1e-9) {
      const double begin = scene.time;
      scene.step(dt);
      log.add(begin, dt, scene.crowd.pushes());
      for (const VehiclePush& push : scene.crowd.pushes()) {
        way += push.way;
        fastest = std::max(fastest, push.speed);
      }
    }
  }
};

class Push : public ::testing::Test {
 protected:
  const Zone zone_ = zone_of(box(0, 0, 80, 20));
};

TEST_F(Push, is_as_long_as_the_vehicle_drives_on_and_as_fast) {
  Scene scene(zone_, 1, standing_model());
  scene.add({40, 10}, point(70, 10), 1.34, 0.0);
  scene.vehicles = {vehicle_at({35, 10}, 0.0, 1.0)};
  Pushes pushes;
  pushes.run(scene, 5.0);
  const double free = 40.0 - kRadius - gap_at(1.0) - (35.0 + kFront);
  EXPECT_NEAR(pushes.way, 5.0 - free, kRounding);
  EXPECT_NEAR(pushes.fastest, 1.0, 1e-9);
  ASSERT_EQ(pushes.log.persons().size(), 1u);
  const auto& [key, person] = *pushes.log.persons().begin();
  EXPECT_EQ(key, scene.people[0].given.key);
  EXPECT_NEAR(person.way, pushes.way, 1e-9);
  EXPECT_NEAR(person.speed, 1.0, 1e-9);
  // Before its bumper, and farther than a step: not without a contact.
  EXPECT_TRUE(person.run_into);
  ASSERT_EQ(pushes.log.run_into().size(), 1u);
  EXPECT_NEAR(pushes.log.run_into().front().speed, 1.0, 1e-9);
}

TEST_F(Push, by_the_side_of_a_vehicle_that_turns_is_for_room_only_where_its_way_is_not_known) {
  const Polyline way{{32.5, 10.0}, {60.0, 10.0}};
  const auto room_after = [&](double room, bool known) {
    Scene scene(zone_, 1, standing_model());
    scene.add({35.0, 10.0 + 0.9 + kRadius + room}, point(70, 10), 1.34, 0.0);
    VehicleState vehicle = vehicle_at({35.0, 10.0}, 0.0, 2.0);
    vehicle.yaw_rate = 0.8;
    if (known) vehicle.way = way;
    vehicle.forwards = known;
    scene.vehicles = {vehicle};
    scene.step(kStep);
    return scene.crowd.view(scene.people[0].handle).position.y() - 10.0 - 0.9 - kRadius;
  };
  EXPECT_NEAR(room_after(0.06, true), 0.06, 1e-9);
  EXPECT_NEAR(room_after(0.02, true), 0.05, 0.01) << "it turns its shoulders";
  EXPECT_GT(room_after(0.4, false), 0.5);
}

TEST_F(Push, moves_nobody_into_somebody_else) {
  // Three in a file before a vehicle that is as fast as they can step. Without further passes over
  // the contacts two of them are 9 cm nearer than turned shoulders let them.
  Scene scene(zone_, 1, standing_model());
  for (const double x : {40.0, 40.5, 41.0}) scene.add({x, 10}, point(70, 10), 1.34, 0.0);
  scene.vehicles = {vehicle_at({37, 10}, 0.0, 2.9)};
  double nearest = 1.0, moved = 0.0;
  while (scene.time < 1.5) {
    scene.step(kStep);
    for (const auto& one : scene.people) {
      for (const auto& other : scene.people) {
        if (&one != &other) {
          nearest = std::min(nearest, (one.view.position - other.view.position).norm());
        }
      }
    }
    for (const VehiclePush& push : scene.crowd.pushes()) {
      moved = std::max(moved, push.speed);
    }
  }
  EXPECT_GT(moved, 2.5);
  EXPECT_LE(moved, kStepping + 1e-9);
  EXPECT_GE(nearest, 2.0 * 0.5 * kRadius - 0.01);
}

TEST_F(Push, moves_nobody_under_another_vehicle_for_room_to_turn) {
  Scene scene(zone_, 1, standing_model());
  scene.add({40, 10}, point(70, 10), 1.34, 0.0);
  VehicleState turns = vehicle_at({40, 8}, 0.0, 0.5);  // 0.86 m from the body
  turns.yaw_rate = 1.6;
  scene.vehicles = {vehicle_at({40, 11.24}, 0.0, 1.0), turns};  // the other passes 0.1 m beside it
  for (int k = 0; k < 3; ++k) {
    scene.step(kStep);
    EXPECT_GE(scene.least_vehicle_gap(), 0.05 - 1e-3) << k;
  }
}

TEST_F(Push, is_told_of_a_step_as_of_its_substeps) {
  for (const double dt : {0.1, 1.0}) {
    Scene scene(zone_, 1, standing_model());
    scene.add({40, 10}, point(70, 10), 1.34, 0.0);
    scene.vehicles = {vehicle_at({35, 10}, 0.0, 1.0)};
    Pushes pushes;
    pushes.run(scene, 5.0, dt);
    EXPECT_NEAR(pushes.log.persons().begin()->second.way,
                5.0 - (5.0 - kFront - kRadius - gap_at(1.0)), kRounding)
        << dt;
  }
}

TEST_F(Push, is_none_of_who_stands_beside_the_way) {
  // The rest of the room is kept before and behind: 50 km/h along a kerb move nobody.
  for (const double speed : {1.0, 13.9}) {
    Scene scene(zone_, 1, standing_model());
    scene.add({40, 10.9 + kRadius + 0.06}, point(70, 10), 1.34, 0.0);
    scene.add({42, 10.9 + kRadius + 0.03}, point(70, 10), 1.34, 0.0);
    scene.vehicles = {vehicle_at({25, 10}, 0.0, speed)};
    Pushes pushes;
    pushes.run(scene, 30.0 / speed);
    ASSERT_EQ(pushes.log.persons().size(), 1u) << speed;
    const auto& [key, person] = *pushes.log.persons().begin();
    EXPECT_EQ(key, scene.people[1].given.key);
    EXPECT_NEAR(person.way, 0.02, 1e-3);
  }
}

TEST_F(Push, is_not_waited_for_by_who_has_arrived) {
  Crowd crowd(zone_, 1);
  NewPerson person;
  person.position = {39, 10.3};
  person.destination = point(40, 10.3);
  const Crowd::Handle handle = crowd.add(person);
  Pushes pushes;
  bool arrived_before = false;
  for (int k = 0; k < 120; ++k) {
    crowd.step(kStep, std::vector{vehicle_at({15 + 0.3 * k, 10}, 0.0, 3.0)});
    pushes.log.add(kStep * k, kStep, crowd.pushes());
    arrived_before = arrived_before || (k < 40 && crowd.view(handle).arrived);
  }
  EXPECT_TRUE(arrived_before);
  EXPECT_TRUE(pushes.log.persons().empty());
  EXPECT_GT(crowd.view(handle).position.y(), 10.9 + kRadius);
}

TEST_F(Push, of_a_fast_one_is_no_faster_than_people_step_and_it_runs_into_them) {
  for (const double speed : {3.5, 8.0, 15.0}) {
    Scene scene(zone_, 1, blind_model());
    scene.add({60, 10.2}, point(5, 10.2));
    scene.vehicles = {vehicle_at({5, 10}, 0.0, speed)};
    Pushes pushes;
    pushes.run(scene, 70.0 / speed);
    const Scene::Person& person = scene.people[0];
    for (std::size_t k = 1; k < person.path.size(); ++k) {
      EXPECT_LE((person.path[k] - person.path[k - 1]).norm(), (kStepping + 1.34) * kStep + 1e-9);
    }
    EXPECT_NEAR(pushes.fastest, kStepping, 1e-9) << speed;
    ASSERT_EQ(pushes.log.run_into().size(), 1u) << speed;
    const RunInto& event = pushes.log.run_into()[0];
    EXPECT_EQ(event.person, person.given.key);
    EXPECT_DOUBLE_EQ(event.speed, speed);
    // They close in at both speeds from 52.26 m apart, and the push delays the contact a little.
    EXPECT_NEAR(event.time, (60.0 - 5.0 - kFront - kRadius) / (speed + 1.34), 0.5);
    EXPECT_TRUE(pushes.log.persons().at(person.given.key).run_into);
    EXPECT_GT(scene.least_vehicle_gap(), -kRadius - 1e-9);
    EXPECT_LT(scene.least_vehicle_gap(), -0.01);
  }
}

TEST_F(Push, of_two_vehicles_at_once_is_no_faster_either) {
  Scene scene(zone_, 1, standing_model());
  scene.add({40, 10}, point(5, 5), 1.34, 0.0);
  scene.vehicles = {vehicle_at({35, 10}, 0.0, 6.0), vehicle_at({40, 5}, kPi / 2, 6.0)};
  for (VehicleState& vehicle : scene.vehicles) vehicle.key = vehicle.centre.x() > 36.0 ? 1 : 2;
  Pushes pushes;
  std::size_t most = 0;
  while (scene.time < 1.0) {
    const Vec2 before = scene.people[0].view.position;
    pushes.run(scene, scene.time + kStep);
    most = std::max(most, scene.crowd.pushes().size());
    EXPECT_LE((scene.people[0].view.position - before).norm(), kStepping * kStep + 1e-9);
  }
  EXPECT_EQ(most, 2u);
  EXPECT_EQ(pushes.log.run_into().size(), 2u);
}

TEST_F(Push, brings_bodies_apart_at_that_speed_once_the_vehicle_stands) {
  Scene scene(zone_, 1, standing_model());
  scene.add({40, 10}, point(70, 10), 1.34, 0.0);
  scene.vehicles = {vehicle_at({40, 9.5}, 0.0, 0.0)};
  const double deep = 0.5 * 1.8 - 0.5 + kRadius + gap_at(0.0);
  int steps = 0;
  while (clearance(scene.vehicles[0], scene.people[0].view.position) < kRadius) {
    scene.step();
    ++steps;
    ASSERT_LE(steps, 10);
  }
  EXPECT_EQ(steps, static_cast<int>(std::ceil(deep / (kStepping * kStep))));
  EXPECT_TRUE(scene.crowd.pushes().empty()) << "it does not drive";
  EXPECT_TRUE(scene.crowd.kept_anybody_out());
}

TEST_F(Push, against_a_wall_runs_into_who_has_no_room_left) {
  const Zone lane = zone_of(box(0, 0, 40, 1.9));
  Scene scene(lane, 1, standing_model());
  scene.add({39, 0.95}, point(2, 0.95), 1.34, 0.0);
  scene.vehicles = {vehicle_at({35, 0.95}, 0.0, 0.5, 5.0, 1.8)};
  Pushes pushes;
  pushes.run(scene, 5.0);
  ASSERT_EQ(pushes.log.run_into().size(), 1u);
  EXPECT_DOUBLE_EQ(pushes.log.run_into()[0].speed, 0.5);
  EXPECT_GE(scene.least_wall_gap(), -1e-6);
}

TEST_F(Push, takes_nobody_who_has_no_room_left_across_the_vehicle) {
  // Between its flank and two walls: the only exit that is free is the one on its other side.
  const Zone corner = zone_of(box(27.3, 0, 80, 11.35));
  Scene scene(corner, 1, standing_model());
  scene.add({27.7, 11.1}, point(70, 5), 1.34, 0.0);
  scene.vehicles = {vehicle_at({30, 10}, 0.0, 1.0)};
  scene.step();
  EXPECT_GE(clearance(scene.vehicles[0], scene.people[0].view.position), 0.2 - 1e-3);
}

TEST_F(Push, is_none_before_one_that_stands_or_passes) {
  Scene scene(zone_, 1, blind_model());
  scene.add({30, 10}, point(70, 10));
  scene.add({60, 3}, point(5, 3));
  scene.vehicles = {vehicle_at({40, 10}, 0.0, 0.0), vehicle_at({5, 10}, 0.0, 0.0),
                    vehicle_at({20, 15}, 0.0, 4.0)};
  Pushes pushes;
  pushes.run(scene, 12.0);
  EXPECT_TRUE(pushes.log.persons().empty());
  EXPECT_TRUE(scene.crowd.kept_anybody_out()) << "the first walks against a standing one";
}

TEST_F(Push, is_off_where_vehicles_are_let_through) {
  Scene scene(zone_, 1, standing_model());
  scene.add({40, 10}, point(70, 10), 1.34, 0.0);
  scene.crowd.let_vehicles_through();
  scene.vehicles = {vehicle_at({35, 10}, 0.0, 5.0)};
  Pushes pushes;
  pushes.run(scene, 1.0);
  EXPECT_EQ(scene.people[0].view.position, Vec2(40, 10));
  EXPECT_EQ(clearance(scene.vehicles[0], {40, 10}), 0.0);
  EXPECT_TRUE(pushes.log.persons().empty());
  EXPECT_FALSE(scene.crowd.kept_anybody_out());
}

TEST_F(Push, is_told_by_person_and_vehicle_in_whatever_order_people_came) {
  std::vector<std::vector<VehiclePush>> told;
  for (const bool backward : {false, true}) {
    Scene scene(zone_, 1, standing_model());
    for (int n = 0; n < 6; ++n) {
      const int k = backward ? 5 - n : n;
      NewPerson person;
      person.key = static_cast<std::uint64_t>(100 - 7 * k);
      person.position = {40.0 + 0.1 * k, 5.0 + 2.0 * k};
      person.destination = point(70, 10);
      scene.add(person);
    }
    for (int k = 0; k < 6; ++k) {
      scene.vehicles.push_back(vehicle_at({37.2, 5.0 + 2.0 * k}, 0.0, 2.0));
      scene.vehicles.back().key = static_cast<std::uint64_t>(9 - k);
    }
    for (int k = 0; k < 4; ++k) scene.step();
    told.emplace_back(scene.crowd.pushes().begin(), scene.crowd.pushes().end());
  }
  ASSERT_EQ(told[0].size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(told[0][k].person, told[1][k].person);
    EXPECT_EQ(told[0][k].vehicle, told[1][k].vehicle);
    EXPECT_EQ(told[0][k].way, told[1][k].way);
    EXPECT_EQ(told[0][k].position, told[1][k].position);
  }
}

/// In a street that leaves 0.35 m beside a bus people go past it, with turned shoulders and a wall
/// beside them, while it stands, and when it drives off.
TEST(PushInNarrowStreet, does_not_take_people_off_the_wall_into_the_vehicle) {
  const Zone zone = zone_of(box(-40, -1.6, 60, 1.6));
  Scene scene(zone);
  for (int k = 0; k < 6; ++k) scene.add({9.0 + 2.0 * k, 0.8}, point(-35, 0), 1.34, 0.0);
  scene.vehicles = {vehicle_at({0, 0}, 0.0, 0.0, 9.0, 2.5)};
  const auto beside = [&] {
    return std::ranges::count_if(scene.people, [](const Scene::Person& person) {
      return std::abs(person.view.position.x()) < 4.0;
    });
  };
  Pushes pushes;
  while (beside() < 2 && scene.time < 60.0) pushes.run(scene, scene.time + 0.5, 0.5);
  ASSERT_GE(beside(), 2);
  VehicleState& bus = scene.vehicles[0];
  bus.velocity = {0.4, 0.0};
  bus.slower = 0.4;  // SUMO may not let it
  pushes.run(scene, scene.time + 4.0, 0.5);
  EXPECT_TRUE(pushes.log.run_into().empty());
}

VehiclePush push_of(double way, bool run_into = false, std::uint64_t vehicle = 5) {
  VehiclePush push;
  push.person = 1;
  push.vehicle = vehicle;
  push.way = way;
  push.speed = 10.0 * way;
  push.run_into = run_into;
  push.contact_speed = run_into ? 4.0 : 0.0;
  return push;
}

TEST(PushLog, joins_what_is_less_than_a_second_apart) {
  PushLog log;
  for (const double time : {1.0, 1.1, 1.9, 4.0, 4.1}) {
    log.add(time, 0.1, std::vector{push_of(0.1)});
  }
  EXPECT_DOUBLE_EQ(log.persons().at(1).way, 0.3);
  EXPECT_DOUBLE_EQ(log.persons().at(1).speed, 1.0);
}

TEST(PushLog, takes_whom_a_vehicle_moves_along_before_it_for_run_into) {
  PushLog log;
  VehiclePush push = push_of(0.3);
  push.contact_speed = 3.0;
  for (double time = 0.0; time < 0.35; time += 0.1) {
    push.carried = 0.0;  // aside
    log.add(time, 0.1, std::vector{push});
  }
  EXPECT_TRUE(log.run_into().empty());
  for (double time = 2.0; time < 2.65; time += 0.1) {
    push.carried = 0.3;
    log.add(time, 0.1, std::vector{push});
  }
  ASSERT_EQ(log.run_into().size(), 1u);
  EXPECT_NEAR(log.run_into().front().time, 2.3, 1e-9);
  EXPECT_DOUBLE_EQ(log.run_into().front().speed, 3.0);
  EXPECT_TRUE(log.persons().at(1).run_into);
}

TEST(PushLog, does_not_take_another_vehicle_for_the_one_that_moved_somebody_along) {
  PushLog log;
  VehiclePush push = push_of(0.3);
  push.carried = 0.3;
  for (const double time : {0.0, 0.1, 0.2, 0.3}) log.add(time, 0.1, std::vector{push});
  ASSERT_EQ(log.run_into().size(), 1u);
  VehiclePush other = push_of(0.05, false, 8);
  for (const double carried : {0.0, 0.05}) {
    other.carried = carried;
    log.add(1.0 + carried, 0.1, std::vector{other});
  }
  EXPECT_EQ(log.run_into().size(), 1u);
  push.carried = 0.0;
  log.add(2.5, 0.1, std::vector{push});
  EXPECT_EQ(log.run_into().size(), 1u) << "it only brushes past";
}

TEST(PushLog, leaves_out_who_is_hardly_moved) {
  PushLog log;
  log.add(0.0, 0.1, std::vector{push_of(0.004)});
  log.add(5.0, 0.1, std::vector{push_of(0.009)});
  EXPECT_TRUE(log.persons().empty());
  log.add(5.1, 0.1, std::vector{push_of(0.009)});
  EXPECT_EQ(log.persons().size(), 1u);
}

TEST(PushLog, counts_a_contact_once_until_it_is_over) {
  PushLog log;
  for (const double time : {1.0, 1.1, 1.3, 2.0}) {
    log.add(time, 0.1, std::vector{push_of(0.3, true)});
  }
  log.add(2.1, 0.1, std::vector{push_of(0.3, true, 6)});
  log.add(3.3, 0.1, std::vector{push_of(0.3, true)});
  ASSERT_EQ(log.run_into().size(), 3u);
  EXPECT_EQ(log.run_into()[0].time, 1.0);
  EXPECT_EQ(log.run_into()[1].vehicle, 6u);
  EXPECT_EQ(log.run_into()[2].time, 3.3);
  EXPECT_EQ(log.run_into()[2].speed, 4.0);
}

}  // namespace
}  // namespace pedzone::test
