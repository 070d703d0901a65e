// Which vehicles people mind: reaction time, what hides vehicles, those who are unaware, horns,
// engines and invitations.
#include <gtest/gtest.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr std::uint64_t kCar = 77;

Profile adult() { return *Profiles().find("adult"); }

VehicleState car(const Vec2& centre, double heading, double speed, double length = 5.0) {
  VehicleState vehicle = vehicle_at(centre, heading, speed, length);
  vehicle.key = kCar;
  return vehicle;
}

/// Somebody at `from` who walks to the east end of a street.
std::size_t add_walker(Scene& scene, const Vec2& from, const Profile* profile,
                       std::optional<bool> aware = true) {
  NewPerson person;
  person.position = from;
  person.destination = {{78, 1}, {78, 19}};
  person.velocity = {1.34, 0.0};
  person.profile = profile;
  person.aware = aware;
  return scene.add(person);
}

/// Whether the person minds the first vehicle.
bool minds(const Scene& scene, std::size_t person) {
  return scene.crowd.aware_of(scene.people[person].handle, scene.vehicles.front());
}

/// [s] at which the person first minds the first vehicle; negative: not until `until`.
double minds_at(Scene& scene, std::size_t person, double until) {
  while (scene.time < until) {
    scene.step();
    if (minds(scene, person)) return scene.time;
  }
  return -1.0;
}

class PerceptionInACrowd : public ::testing::Test {
 protected:
  Zone street_ = zone_of(box(0, 0, 80, 20));
};

TEST_F(PerceptionInACrowd, a_new_vehicle_counts_after_the_reaction_time) {
  Profile slow = adult(), quick = adult();
  slow.reaction_time = 1.5;
  quick.reaction_time = 0.0;
  Scene scene(street_);
  const auto first = add_walker(scene, {20, 8}, &quick);
  const auto second = add_walker(scene, {20, 12}, &slow);
  scene.vehicles = {car({44, 10}, kPi, 1.0)};
  scene.step();
  EXPECT_TRUE(minds(scene, first));
  EXPECT_FALSE(minds(scene, second));
  EXPECT_NEAR(minds_at(scene, second, 5.0), 1.6, 0.15);
}

TEST_F(PerceptionInACrowd, the_unaware_mind_what_is_very_near_only) {
  const Profile profile = adult();
  Scene scene(street_);
  const auto person = add_walker(scene, {20, 10}, &profile, false);
  scene.vehicles = {car({60, 10}, kPi, 3.0)};
  double least = 1e9;
  while (scene.time < 15) {
    scene.step();
    const double gap = clearance(scene.vehicles.front(), scene.people[person].view.position);
    least = std::min(least, gap);
    if (gap > 2.0) {
      ASSERT_FALSE(minds(scene, person)) << scene.time;
    }
  }
  EXPECT_LT(least, 1.0);  // it has been let come near
  EXPECT_GT(scene.least_vehicle_gap(), -0.01);
}

TEST_F(PerceptionInACrowd, a_horn_makes_them_aware) {
  const Profile profile = adult();
  Scene scene(street_);
  const auto person = add_walker(scene, {20, 10}, &profile, false);
  scene.vehicles = {car({60, 10}, kPi, 1.0)};
  EXPECT_LT(minds_at(scene, person, 3.0), 0.0);
  scene.vehicles.front().horn = true;
  const double at = minds_at(scene, person, 8.0);
  EXPECT_NEAR(at - 3.0, adult().reaction_time, 0.25);
  scene.vehicles.front().horn = false;
  scene.step();
  EXPECT_TRUE(minds(scene, person)) << "it knows now";
}

TEST_F(PerceptionInACrowd, walls_and_parked_vehicles_hide_what_is_behind) {
  const Profile profile = adult();
  const Zone walled = zone_of(box(0, 0, 80, 20), {box(35, 2, 36, 18)});
  Scene behind_wall(walled), behind_bus(street_), open(street_);
  for (Scene* scene : {&behind_wall, &behind_bus, &open}) {
    add_walker(*scene, {28, 10}, &profile);
    scene->vehicles = {car({44, 10}, 0.0, 0.5)};
  }
  behind_bus.vehicles.push_back(vehicle_at({36, 10}, kPi / 2, 0.0, 12.0, 2.5));
  EXPECT_LT(minds_at(behind_wall, 0, 2.0), 0.0);
  EXPECT_LT(minds_at(behind_bus, 0, 2.0), 0.0);
  EXPECT_GT(minds_at(open, 0, 2.0), 0.0);
}

TEST_F(PerceptionInACrowd, electric_vehicles_are_heard_nearer) {
  const Profile profile = adult();
  Scene engine(street_), electric(street_);
  for (Scene* scene : {&engine, &electric}) {
    const auto person = add_walker(*scene, {30, 10}, &profile);
    scene->vehicles = {car({10, 10}, 0.0, 3.0)};
    scene->vehicles.front().electric = scene == &electric;
    ASSERT_GT(minds_at(*scene, person, 20.0), 0.0);
  }
  EXPECT_GT(electric.time, engine.time + 1.0);
}

TEST_F(PerceptionInACrowd, who_is_invited_goes_first) {
  const Profile profile = adult();
  double crossed[2];
  for (const bool invites : {false, true}) {
    const Zone square = zone_of(box(0, 0, 80, 40));
    Scene scene(square);
    NewPerson person;
    person.position = {40, 10};
    person.destination = {{0, 38}, {80, 38}};
    person.velocity = {0.0, 1.34};
    person.heading = kPi / 2;
    person.profile = &profile;
    person.aware = true;
    const auto handle = scene.add(person);
    scene.vehicles = {car({21, 20}, 0.0, 3.0)};
    scene.vehicles.front().invites = invites;
    while (scene.time < 60 && scene.people[handle].view.position.y() < 24) scene.step();
    crossed[invites ? 1 : 0] = scene.time;
    EXPECT_GT(scene.least_vehicle_gap(), 0.0);
  }
  EXPECT_LT(crossed[1], crossed[0] - 0.5);
}

}  // namespace
}  // namespace pedzone::test
