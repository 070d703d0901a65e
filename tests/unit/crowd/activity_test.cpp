// What people do beside walking: how often, how long, and what it does to them.
#include <gtest/gtest.h>

#include <cmath>

#include "scene.hpp"

namespace pedzone::test {
namespace {

NewPerson walker(const Vec2& from, const Destination& to, Activity activity, double rate) {
  NewPerson person;
  person.position = from;
  person.destination = to;
  person.heading = angle_of(0.5 * (to.a + to.b) - from);
  person.rates[static_cast<std::size_t>(activity)] = rate;
  return person;
}

TEST(Activities, begin_and_end_by_their_rates) {
  // A process that begins at rate a and ends at rate b is on for a share a/(a + b) of the time.
  constexpr double kRate = 3.0;
  const double share = kRate / 60.0 / (kRate / 60.0 + 1.0 / info_of(Activity::kTexting).duration);
  const Zone zone = zone_of(box(0, 0, 2000, 400));
  Scene scene(zone, 3);
  constexpr int kPeople = 200;
  for (int k = 0; k < kPeople; ++k) {
    scene.add(walker({5, 2.0 * k + 1}, {{1999, 0}, {1999, 400}}, Activity::kTexting, kRate));
  }
  scene.run(100.0, 0.1);
  long texting = 0, all = 0;
  for (int k = 0; k < 1000; ++k) {
    scene.step();
    for (const auto& person : scene.people) {
      ++all;
      texting += person.view.activity == Activity::kTexting ? 1 : 0;
    }
  }
  // The process forgets itself in about 10 s, so 100 s of one person are about five looks at it.
  const double bound = 4.5 * std::sqrt(share * (1.0 - share) / (5.0 * kPeople));
  EXPECT_NEAR(static_cast<double>(texting) / static_cast<double>(all), share, bound);
}

TEST(Activities, slow_down_or_stop) {
  const Zone zone = zone_of(box(0, 0, 400, 20));
  for (const Activity activity : {Activity::kTexting, Activity::kPhoning, Activity::kChatting}) {
    Scene scene(zone);
    const auto person = scene.add(walker({5, 10}, {{399, 1}, {399, 19}}, activity, 60.0));
    while (scene.people[person].view.activity != activity) scene.step();
    const double wanted = 1.34 * info_of(activity).speed;
    double settled = -1.0;
    for (int k = 0; k < 40 && scene.people[person].view.activity == activity; ++k) {
      scene.step();
      if (k >= 25) settled = scene.people[person].view.velocity.norm();
    }
    if (settled >= 0.0) {
      EXPECT_NEAR(settled, wanted, 0.02) << info_of(activity).id;
    }
  }
}

TEST(Weather, changes_how_fast_people_walk) {
  double time[2];
  for (const bool ice : {false, true}) {
    Zone zone = zone_of(box(0, 0, 60, 20));
    if (ice) zone.weather = find_weather("ice");
    Scene scene(zone);
    scene.add(walker({5, 10}, {{55, 1}, {55, 19}}, Activity::kNone, 0.0));
    scene.run(200.0);
    time[ice ? 1 : 0] = scene.people[0].arrival_time;
  }
  EXPECT_NEAR(time[0] / time[1], find_weather("ice")->speed, 0.02);
}

TEST(Activities, people_sit_down_on_seats) {
  Zone zone = zone_of(box(0, 0, 60, 30));
  zone.seats = {{20, 22}, {50, 2}};
  int on_seats = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Scene scene(zone, seed);
    const auto person = scene.add(walker({5, 15}, {{59, 14}, {59, 16}}, Activity::kSitting, 6.0));
    while (scene.time < 900 && scene.arrived() == 0) {
      scene.step();
      const PersonView& view = scene.people[person].view;
      if (view.activity != Activity::kSitting || view.velocity.norm() > 0.01) continue;
      const double to_seat =
          std::min((view.position - zone.seats[0]).norm(), (view.position - zone.seats[1]).norm());
      ASSERT_LT(to_seat, 0.5) << "seed " << seed << ", " << scene.time << " s";
      ++on_seats;
    }
    EXPECT_EQ(scene.arrived(), 1u) << seed;
  }
  EXPECT_GT(on_seats, 100);
}

TEST(Weather, heat_leads_through_the_shade) {
  double share[2];
  for (const bool hot : {false, true}) {
    Zone zone = zone_of(box(0, 0, 80, 20));
    if (hot) {
      zone.weather = find_weather("heat");
      zone.shades = {repair(box(20, 12, 60, 18)), repair(box(20, -200, 60, -190))};
    }
    Scene scene(zone);
    const auto person = scene.add(walker({2, 8}, {{78, 7}, {78, 9}}, Activity::kNone, 0.0));
    scene.run(200.0);
    int shaded = 0;
    for (const Vec2& at : scene.people[person].path) {
      shaded += at.x() > 20 && at.x() < 60 && at.y() > 12 && at.y() < 18 ? 1 : 0;
    }
    EXPECT_EQ(scene.arrived(), 1u);
    share[hot ? 1 : 0] = shaded / static_cast<double>(scene.people[person].path.size());
  }
  EXPECT_EQ(share[0], 0.0);
  EXPECT_GT(share[1], 0.4);
}

TEST(Weather, heat_sends_nobody_back_who_is_in_the_shade) {
  Zone zone = zone_of(box(0, 0, 80, 20));
  zone.weather = find_weather("heat");
  zone.shades = {repair(box(20, 2, 60, 18))};
  Scene scene(zone);
  const auto person = scene.add(walker({23, 10}, {{78, 9}, {78, 11}}, Activity::kNone, 0.0));
  scene.run(100.0);
  EXPECT_EQ(scene.arrived(), 1u);
  for (const Vec2& at : scene.people[person].path) EXPECT_GT(at.x(), 22.5);
}

TEST(Impulse, sends_people_in_front_of_a_vehicle) {
  Profile child = *Profiles().find("child");
  child.impulsiveness = 60.0;
  int nearer = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    double least[2];
    for (const bool impulsive : {false, true}) {
      const Zone zone = zone_of(box(0, 0, 80, 40));
      Scene scene(zone, seed);
      NewPerson person = walker({60, 14}, {{1, 1}, {1, 16}}, Activity::kNone, 0.0);
      Profile calm = child;
      calm.impulsiveness = 0.0;
      person.profile = impulsive ? &child : &calm;
      person.aware = true;
      scene.add(person);
      scene.vehicles = {vehicle_at({20, 20}, 0.0, 3.0)};
      scene.run(25.0);
      least[impulsive ? 1 : 0] = scene.least_vehicle_gap();
    }
    nearer += least[1] < least[0] - 1.0 ? 1 : 0;
  }
  EXPECT_GE(nearer, 15);
}

}  // namespace
}  // namespace pedzone::test
