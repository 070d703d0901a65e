// How people give way: to whom how much, aside or slower, and what is no way out.
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "oracle.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kDegree = kPi / 180.0;

/// Somebody at the origin who walks east.
Scene walker_and(const VehicleState& v) {
  Scene scene;
  scene.parameters.margin_spread = 0.0;
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.vehicles = {v};
  return scene;
}

double aside(const Decision& d) { return std::abs(d.direction) / kDegree; }

void expect_same(const Decision& a, const Decision& b) {
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.speed, b.speed);
  EXPECT_EQ(a.free_distance, b.free_distance);
  EXPECT_EQ(a.waits, b.waits);
  EXPECT_EQ(a.turns, b.turns);
}

/// The least clearance of somebody who walks so far [m] east and meets the scene's vehicle.
double clearance_of(const Scene& scene, double way) {
  Walkthrough walk(scene, {{way, 0.0}});
  while (walk.at(0).x() < way - 2.0 && walk.time() < 60.0) walk.step();
  EXPECT_LT(walk.time(), 60.0);
  return walk.least_clearance();
}

TEST(GivingWay, gives_a_faster_vehicle_more_room) {
  // Up to 5 m/s: of a faster one 25 m of sight show too little time (shared space has 5.6 at most).
  double before = 0.0;
  for (const double speed : {0.5, 1.0, 1.5, 3.0, 4.5}) {
    const Scene scene = walker_and(vehicle({45.0, -1.0}, kPi, speed));
    const double clearance = clearance_of(scene, 60.0);
    EXPECT_GT(clearance, before + 0.1) << speed;
    before = clearance;
  }
}

TEST(GivingWay, gives_a_parked_vehicle_no_more_room_than_in_the_paper) {
  Scene scene = walker_and(vehicle({8.0, 0.3}, 0.4, 0.0));
  // Without a vehicle that it feels, a person walks by Eq. 1; round one that bars its way by Eq. 2.
  Scene first = scene, second = scene;
  first.model_name = "heuristic-original";
  second.model_name = "plain";
  int barred = 0;
  for (double x = -2.0; x < 6.0; x += 0.25) {
    scene.people[0].at = first.people[0].at = second.people[0].at = {x, 0.0};
    const Decision by_first = first.first();
    const bool bars = by_first.free_distance < scene.parameters.near_distance;
    expect_same(scene.first(), bars ? second.first() : by_first);
    barred += bars ? 1 : 0;
  }
  EXPECT_GT(barred, 0);
}

TEST(GivingWay, expects_a_vehicle_that_speeds_up_to_go_on_so) {
  int told_apart = 0;
  for (double y = -20.0; y <= -4.0; y += 0.5) {
    Scene slow = walker_and(vehicle({6.0, y}, kPi / 2.0, 2.0));
    Scene fast = walker_and(vehicle({6.0, y}, kPi / 2.0, 2.5));
    Scene gains = slow;
    gains.vehicles[0].gain = 0.5;
    const Decision expected = fast.first(), decided = gains.first();
    EXPECT_EQ(decided.direction, expected.direction) << y;
    EXPECT_EQ(decided.speed, expected.speed) << y;
    const Decision before = slow.first();
    told_apart += before.direction != expected.direction || before.speed != expected.speed;
    for (const char* of_the_papers : {"plain", "heuristic-original"}) {
      slow.model_name = gains.model_name = of_the_papers;
      expect_same(gains.first(), slow.first());
    }
  }
  EXPECT_GT(told_apart, 3);
}

/// A person's key whose own standard normal number is near z.
std::uint64_t key_of_caution(double z) {
  for (std::uint64_t key = 1;; ++key) {
    if (std::abs(random_normal(0, key, 0, Purpose::kCaution) - z) < 0.01) return key;
  }
}

TEST(GivingWay, keeps_the_cautious_farther_away) {
  for (const double heading : {kPi, 2.6}) {
    double before = 0.0;
    for (const double z : {-1.5, 0.0, 1.5}) {
      Scene scene = walker_and(vehicle(Vec2(10.0, 0.0) - 20.0 * unit(heading), heading, 2.0));
      scene.parameters.margin_spread = 0.25;
      scene.people[0].key = key_of_caution(z);
      const double clearance = clearance_of(scene, 40.0);
      EXPECT_GT(clearance, before + 0.1) << z;
      before = clearance;
    }
  }
}

TEST(GivingWay, of_people_who_do_not_differ_in_caution_does_not_depend_on_who_they_are) {
  Scene scene = walker_and(vehicle({12.0, -1.0}, kPi, 2.0));
  const Decision anybody = scene.first();
  EXPECT_GT(aside(anybody), 2.0);
  scene.people[0].key = key_of_caution(-2.0);
  expect_same(scene.first(), anybody);
  scene.parameters.margin_spread = 1.0;
  EXPECT_NE(scene.first().direction, anybody.direction);
}

/// A vehicle that drives north and will be where the person is, `later` [s] at its speed, or so
/// much before or behind.
Scene crossed(double later, double behind, double slowing_cost) {
  constexpr double kSpeed = 3.0;
  Scene scene = walker_and(vehicle({1.34 * later, -kSpeed * later - behind}, kPi / 2, kSpeed));
  scene.parameters.slowing_cost = slowing_cost;
  scene.parameters.hurry_cost = 100.0;  // nobody hurries
  return scene;
}

TEST(GivingWay, slows_down_or_goes_round_as_slowing_costs) {
  int slowed = 0, turned = 0;
  for (double later = 2.0; later <= 4.0; later += 0.25) {
    for (double behind = -4.0; behind <= 4.0; behind += 1.0) {
      const Decision cheap = crossed(later, behind, 0.02).first();
      const Decision dear = crossed(later, behind, 100.0).first();
      // Eq. 3 alone slows the second one down.
      EXPECT_EQ(dear.speed, std::min(1.34, dear.free_distance / 0.5)) << later << " " << behind;
      EXPECT_LE(cheap.speed, dear.speed) << later << " " << behind;
      slowed += cheap.speed <= 0.75 * 1.34 && cheap.free_distance > 1.0 ? 1 : 0;
      turned += aside(dear) > aside(cheap) + 2.0 ? 1 : 0;
    }
  }
  EXPECT_GT(slowed, 40);
  EXPECT_GT(turned, 40);
}

TEST(GivingWay, says_that_a_person_waits_when_it_stands_for_a_vehicle) {
  int stand = 0;
  for (double later = 1.2; later <= 3.0; later += 0.2) {
    const Decision d = crossed(later, 0.0, 0.02).first();
    EXPECT_EQ(d.waits, d.speed == 0.0);
    stand += d.waits ? 1 : 0;
  }
  EXPECT_GT(stand, 0);
}

/// A car that comes from behind, so far to the left that nobody needs to step aside for it.
Scene overtaken(double ahead, double speed, double heading = 0.0) {
  Scene scene = walker_and(vehicle({ahead, 4.0}, heading, speed));
  scene.parameters.discomfort_margin = 0.1;
  scene.parameters.discomfort_margin_time = 0.1;
  return scene;
}

TEST(GivingWay, slows_down_while_a_car_that_drives_its_way_passes) {
  const double own = 1.34;
  const double beside = overtaken(0.0, 2.3).first().speed;
  EXPECT_LT(beside, 0.9 * own);
  // Nearer means slower; a car farther away than 8 m and one that has passed are none to be let
  // past.
  const double behind = overtaken(-6.0, 2.3).first().speed;
  EXPECT_GT(behind, beside);
  EXPECT_LT(behind, own);
  EXPECT_EQ(overtaken(-12.0, 2.3).first().speed, own);
  EXPECT_EQ(overtaken(2.6, 2.3).first().speed, own);
  // Nor is one that never passes.
  EXPECT_EQ(overtaken(0.0, 1.3).first().speed, own);
  Scene scene = overtaken(0.0, 2.3);
  scene.parameters.letting_pass = 0.0;
  EXPECT_EQ(scene.first().speed, own);
}

TEST(GivingWay, does_not_walk_along_before_a_slow_car_that_comes_from_behind) {
  // A car of 2 m/s that drives 10 degrees off the person's way, into it from the right: whoever
  // keeps beside it is led away from the goal for as long as it drives.
  const auto led = [](double letting_pass) {
    const double heading = 12.0 * kDegree;
    Scene scene = walker_and(vehicle(Vec2(8.0, 0.0) - 11.0 * unit(heading), heading, 2.0));
    scene.parameters.letting_pass = letting_pass;
    Walkthrough walk(scene, {{24.0, 0.0}});
    double most = 0.0;
    while (walk.at(0).x() < 23.0 && walk.time() < 60.0) {
      walk.step();
      most = std::max(most, std::abs(walk.at(0).y()));
    }
    EXPECT_LT(walk.time(), 60.0);
    return most;
  };
  const double now = led(Parameters().letting_pass);
  EXPECT_LT(now, 3.0);
  EXPECT_GT(led(0.0), now + 0.5);
}

TEST(GivingWay, keeps_more_room_to_a_vehicle_that_comes_from_behind) {
  Scene scene = walker_and(vehicle({-8.0, 1.8}, 0.0, 3.0));
  const double now = scene.first().direction;
  EXPECT_LT(now, -2.0 * kDegree);
  scene.parameters.room_behind = 0.0;
  EXPECT_GT(scene.first().direction, now + 1.0 * kDegree);
  // One that comes towards the person is seen: the same room whatever the parameter.
  Scene ahead = walker_and(vehicle({14.0, 1.8}, kPi, 3.0));
  const Decision seen = ahead.first();
  ahead.parameters.room_behind = 1.0;
  expect_same(ahead.first(), seen);
}

TEST(GivingWay, hurries_before_a_vehicle_as_far_as_it_costs_little_and_the_person_can) {
  int hurried = 0;
  for (double later = 2.0; later <= 4.0; later += 0.25) {
    for (double behind = -2.0; behind <= 6.0; behind += 0.5) {
      Scene scene = crossed(later, behind, 100.0);
      scene.parameters.hurry_cost = 0.3;
      const Decision free = scene.first();
      EXPECT_LE(free.speed, 1.2 * 1.34 + 1e-6);
      hurried += free.speed > 1.01 * 1.34 ? 1 : 0;
      scene.parameters.hurry_cost = 100.0;
      EXPECT_LE(scene.first().speed, 1.34 + 1e-9);
    }
  }
  EXPECT_GT(hurried, 10);
}

TEST(GivingWay, steps_aside_for_a_vehicle_that_it_hears_and_for_none_beyond_hearing) {
  for (const double gap : {5.5, 7.0, 7.9, 8.1, 9.0}) {
    // It would pass 0.4 m beside the body: no contact, but too near.
    Scene scene = walker_and(vehicle({-2.5 - gap, 1.65}, 0.0, 4.0));
    const Decision d = scene.first();
    scene.vehicles.clear();
    if (gap > scene.parameters.hearing) {
      expect_same(d, scene.first());
    } else {
      EXPECT_LT(d.direction, -5.0 * kDegree) << gap;
    }
  }
}

TEST(GivingWay, is_the_mirror_image_in_a_mirrored_scene_on_a_grid_to_the_bit) {
  // Axes and whole numbers, so that many sums cancel to nothing.
  const auto model = make_model("heuristic");
  int minded = 0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (const double x : {-6.0, -3.0, 0.0, 3.0, 6.0, 9.0}) {
      for (const double y : {1.0, 2.0, 3.0, 5.0, 8.0}) {
        Scene scene = walker_and(vehicle({x, y}, quarter * kPi / 2, 2.0, 4.0, 2.0));
        scene.people[0].goal = 0.2;
        Scene mirror = scene;
        mirror.people[0].goal = -0.2;
        VehicleState& v = mirror.vehicles[0];
        v = vehicle({x, -y}, -v.heading, 2.0, 4.0, 2.0);
        const Decision a = scene.decide(*model)[0], b = mirror.decide(*model)[0];
        EXPECT_EQ(a.direction, -b.direction) << quarter << " " << x << " " << y;
        EXPECT_EQ(a.speed, b.speed) << quarter << " " << x << " " << y;
        EXPECT_EQ(a.free_distance, b.free_distance) << quarter << " " << x << " " << y;
        scene.parameters.discomfort_margin = scene.parameters.discomfort_margin_time = 0.0;
        const Decision unminded = scene.decide(*model)[0];
        minded += a.direction != unminded.direction || a.speed != unminded.speed ? 1 : 0;
      }
    }
  }
  EXPECT_GT(minded, 20);
}

TEST(GivingWay, does_not_take_a_wall_for_a_way_out) {
  // Head-on, its middle 0.3 m left of the person: it goes by on the right, where it has less to go.
  Scene scene = walker_and(vehicle({12.0, 0.3}, kPi, 2.0));
  EXPECT_LT(scene.first().direction, -5.0 * kDegree);
  scene.walls = {
      {{-60.0, -0.6}, {60.0, -0.6}}};  // with room for the body, but not beside a vehicle
  EXPECT_GT(scene.first().direction, 5.0 * kDegree);
}

TEST(GivingWay, lets_nobody_stand_before_a_vehicle_that_is_about_to_reach_it) {
  // From before the bumper to the side, whatever it costs; in open space there is a way out.
  const auto model = make_model("heuristic");
  for (const double speed : {0.5, 1.5, 4.0}) {
    for (const double time : {0.1, 0.5, 0.9}) {
      for (double y = -1.3; y <= 1.3; y += 0.4) {
        for (double goal = -180.0; goal < 180.0; goal += 60.0) {
          for (const double slowing_cost : {0.0, 0.25}) {
            const double gap = 0.24 + 0.25 + speed * time;
            Scene scene = walker_and(vehicle({-2.5 - gap, y}, 0.0, speed));
            scene.parameters.slowing_cost = slowing_cost;
            scene.people[0] = walking_to({0, 0}, goal * kDegree);
            scene.people[0].velocity = Vec2::Zero();
            const Decision d = scene.decide(*model)[0];
            EXPECT_FALSE(d.waits) << speed << " " << time << " " << y << " " << goal;
            EXPECT_GT(d.speed, 0.1) << speed << " " << time << " " << y << " " << goal;
          }
        }
      }
    }
  }
}

TEST(GivingWay, slows_down_a_little_before_one_that_comes_towards_it) {
  const auto speed_at = [](double x, double heading) {
    Scene scene = walker_and(vehicle({x, 6.0}, heading, 2.5));
    return scene.first().speed / scene.people[0].speed;
  };
  EXPECT_NEAR(speed_at(8.5, kPi), 0.91, 0.01);  // clear of it by 5.1 m, so by nothing but its speed
  EXPECT_EQ(speed_at(14.0, kPi), 1.0);          // too far away
  EXPECT_EQ(speed_at(-4.0, kPi), 1.0);          // it has passed
  EXPECT_EQ(speed_at(8.5, 0.0), 1.0);           // it drives ahead of the person, the same way
  Scene scene = walker_and(vehicle({8.5, 6.0}, kPi, 2.5));
  scene.parameters.meeting = 0.0;
  EXPECT_EQ(scene.first().speed, scene.people[0].speed);
}

TEST(GivingWay, goes_on_across_whoever_is_halfway_and_walks) {
  // Half a body nearer to the side that it comes from, 0.9 s before the bumper gets there: at 1.4
  // m/s it is across in time, but it would not be back.
  const auto model = make_model("heuristic");
  for (const double across : {-1.0, 1.0}) {
    Scene scene = walker_and(vehicle({-2.5 - 0.49 - 4.0 * 0.9, 0.0}, 0.0, 4.0));
    scene.people[0] = walking_to({0, -0.12 * across}, across * kPi / 2);
    scene.people[0].velocity = {0.0, 1.4 * across};
    const Decision going = scene.decide(*model)[0];
    EXPECT_TRUE(going.escapes);
    EXPECT_GT(across * std::sin(going.direction) * going.speed, 1.3);
    scene.people[0].velocity = Vec2::Zero();  // who stands takes the nearer side
    const Decision standing = scene.decide(*model)[0];
    EXPECT_LT(across * std::sin(standing.direction) * standing.speed, -1.0);
  }
}

TEST(GivingWay, does_not_run_away_along_the_way_of_a_faster_vehicle) {
  // Straight ahead it would be reached later than now, but reached.
  const auto model = make_model("heuristic");
  for (const double y : {-0.4, 0.4}) {
    Scene scene = walker_and(vehicle({-2.5 - 0.49 - 4.0 * 0.9, 0.0}, 0.0, 4.0));
    scene.people[0] = walking_to({0, y}, 0.0);
    scene.people[0].velocity = {1.3, 0.0};
    const Decision d = scene.decide(*model)[0];
    EXPECT_GT(std::abs(std::sin(d.direction)), 0.7) << d.direction;
    EXPECT_GT(d.direction * y, 0.0);
  }
}

}  // namespace
}  // namespace pedzone::test
