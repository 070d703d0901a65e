// Who meets nobody within a long step walks it at once; everybody else in substeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

/// Decides as another model does, and counts the decisions for each place in the crowd's order.
class CountingModel : public WalkingModel {
 public:
  CountingModel(const std::string& name, std::map<std::uint64_t, int>& decisions)
      : model_(make_model(name)), decisions_(decisions) {}
  void prepare(const Snapshot& snapshot) override {
    persons_ = snapshot.persons;
    model_->prepare(snapshot);
  }
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override {
    for (std::size_t i = first; i < last; ++i) ++decisions_[persons_->key[i]];
    model_->decide(first, last, decisions);
  }
  bool sets_velocity() const override { return model_->sets_velocity(); }
  VehicleForm vehicle_form() const override { return model_->vehicle_form(); }

 private:
  std::unique_ptr<WalkingModel> model_;
  std::map<std::uint64_t, int>& decisions_;
  const Persons* persons_ = nullptr;
};

/// A footway along which people are under way for some seconds, before the step that is looked at.
struct Footway {
  explicit Footway(const std::string& model = "heuristic", const Ring& ground = box(0, 0, 200, 4))
      : zone(zone_of(ground, {}, true)),
        scene(zone, 1, std::make_unique<CountingModel>(model, decisions)) {}

  void walk(double x, double y, double to) { scene.add({x, y}, point(to, y)); }

  /// Decisions of that person in the last of `steps` steps of 1 s.
  int decisions_of(std::uint64_t key, int steps = 3) {
    for (int k = 0; k < steps; ++k) {
      decisions.clear();
      scene.step(1.0);
    }
    return decisions[key];
  }

  std::map<std::uint64_t, int> decisions;
  Zone zone;
  Scene scene;
};

TEST(FreeWalk, is_one_decision_for_who_is_alone) {
  Footway footway;
  footway.walk(10, 2, 190);
  EXPECT_EQ(footway.decisions_of(1), 1);
}

TEST(FreeWalk, is_not_for_models_that_set_velocities) {
  Footway footway("social-force");
  footway.walk(10, 2, 190);
  EXPECT_EQ(footway.decisions_of(1), 10);
}

TEST(FreeWalk, ends_where_two_could_touch_if_both_hurried) {
  // 2 x 1.34 m of way, bodies of 0.24 m, a metre between them.
  Footway near, far;
  near.walk(10, 2, 190);
  near.walk(14, 2, 190);
  far.walk(10, 2, 190);
  far.walk(15, 2, 190);
  EXPECT_EQ(near.decisions_of(1), 10);
  EXPECT_EQ(near.decisions_of(2), 10);
  EXPECT_EQ(far.decisions_of(1), 1);
  EXPECT_EQ(far.decisions_of(2), 1);
}

TEST(FreeWalk, ends_where_two_turn_their_shoulders_before_each_other) {
  // In short steps, too: they do a second before they meet.
  for (const double distance : {4.5, 6.0}) {
    Footway footway;
    footway.walk(10, 2, 190);
    footway.walk(10 + distance, 2, 0);
    footway.scene.step(0.2);
    footway.decisions.clear();
    footway.scene.step(0.2);
    EXPECT_EQ(footway.decisions[1], distance < 5.0 ? 2 : 1) << distance;
  }
}

/// Goes straight on, and turns its shoulders in steps of more than a substep: who walks freely.
class TurningModel : public WalkingModel {
 public:
  void prepare(const Snapshot& snapshot) override { long_step_ = snapshot.step > 0.5; }
  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override {
    Decision decision;
    decision.speed = 1.34;
    decision.free_distance = 10.0;
    decision.turns = long_step_;
    std::fill(decisions.begin() + static_cast<std::ptrdiff_t>(first),
              decisions.begin() + static_cast<std::ptrdiff_t>(last), decision);
  }

 private:
  bool long_step_ = false;
};

/// Without this a stale list is read: the memory sanitizer and -D_GLIBCXX_ASSERTIONS see it.
TEST(FreeWalk, has_nobody_before_it_whatever_its_model_says) {
  const Zone zone = zone_of(box(0, 0, 900, 4), {}, true);
  Scene scene(zone, 1, std::make_unique<TurningModel>());
  for (int k = 0; k < 100; ++k) {  // one after the other: only who is new walks in substeps
    scene.add({2, 2}, point(890, 2));
    for (int n = 0; n < 5; ++n) scene.step(1.0);
  }
  EXPECT_TRUE(scene.crowd.jams().empty());
}

TEST(FreeWalk, minds_people_in_SUMOs_hands) {
  Footway footway;
  footway.walk(10, 2, 190);
  const SeenPerson standing{{15, 2}, Vec2::Zero(), 0.24, 7, 0.0, true};
  footway.scene.crowd.see(std::span(&standing, 1));
  EXPECT_EQ(footway.decisions_of(1, 3), 10);
}

TEST(FreeWalk, ends_where_a_vehicle_can_be_seen) {
  for (const double distance : {20.0, 120.0}) {
    Footway footway;
    footway.walk(10, 2, 190);
    footway.scene.vehicles.push_back(vehicle_at({10 + distance, 2}, kPi, 2.0));
    EXPECT_EQ(footway.decisions_of(1), distance < 30.0 ? 10 : 1) << distance;
  }
}

TEST(FreeWalk, goes_on_behind_a_vehicle_that_has_driven_past) {
  const auto decisions_behind = [](double from, double speed, int steps = 3) {
    Footway footway;
    footway.walk(10, 2, 190);
    footway.scene.vehicles.push_back(vehicle_at({10 + from, 2}, 0.0, speed));
    return footway.decisions_of(1, steps);
  };
  EXPECT_EQ(decisions_behind(8.0, 5.0), 1);
  EXPECT_EQ(decisions_behind(8.0, 1.0), 10) << "it may catch up";
  EXPECT_EQ(decisions_behind(8.0, -5.0), 10) << "it comes back";
  EXPECT_EQ(decisions_behind(8.0, 3.1, 2), 1);
  EXPECT_EQ(decisions_behind(3.1, 3.1, 2), 10) << "it is at hand";
}

TEST(FreeWalk, ends_where_a_vehicle_can_be_heard) {
  // Farther than it is seen: 45 m. The zone says 8 m of hearing.
  for (const double hearing : {8.0, 50.0}) {
    Profile profile = *Profiles().find("adult");
    profile.hearing = hearing;
    Footway footway;
    NewPerson person;
    person.position = {10, 2};
    person.destination = point(190, 2);
    person.profile = &profile;
    person.aware = true;
    footway.scene.add(person);
    footway.scene.vehicles.push_back(vehicle_at({55, 2}, 0.0, 2.0));
    EXPECT_EQ(footway.decisions_of(1), hearing > 45.0 ? 10 : 1) << hearing;
  }
}

TEST(FreeWalk, ends_before_a_corner_and_the_destination) {
  Footway footway("heuristic", {{0, 0}, {32, 0}, {32, 40}, {29, 40}, {29, 3}, {0, 3}});
  const auto person = footway.scene.add({2, 1.5}, point(30.5, 38));
  int at_once = 0, in_substeps = 0;
  while (footway.scene.people[person].here && footway.scene.time < 100.0) {
    footway.decisions_of(1, 1) == 1 ? ++at_once : ++in_substeps;
  }
  EXPECT_GT(at_once, 30);
  EXPECT_GT(in_substeps, 3);
  EXPECT_GE(footway.scene.least_wall_gap(), -1e-6);
}

TEST(FreeWalk, ends_before_a_waypoint) {
  for (const double distance : {4.5, 8.0}) {  // it walks 1.3 m of it in each second
    Footway footway;
    NewPerson person;
    person.position = {10, 2};
    person.destination = point(190, 2);
    person.path = {{{10 + distance, 2}, 1.0}};
    footway.scene.add(person);
    EXPECT_EQ(footway.decisions_of(1), distance < 7.0 ? 10 : 1) << distance;
  }
}

TEST(FreeWalk, takes_as_long_as_in_substeps) {
  for (const double speed : {0.6, 1.34, 2.0}) {
    double times[2];
    for (const bool short_steps : {false, true}) {
      const Zone zone =
          zone_of(Ring{{0, 0}, {60, 0}, {60, 60}, {57, 60}, {57, 3}, {0, 3}}, {}, true);
      Scene scene(zone);
      scene.add({1, 1.5}, line_at_y(59, 57, 60), speed);
      scene.run(300, short_steps ? 0.1 : 1.0);
      ASSERT_EQ(scene.arrived(), 1u);
      times[short_steps] = scene.people[0].arrival_time;
    }
    EXPECT_NEAR(times[0], times[1], 1.0 + 0.01 * times[1]) << speed;
  }
}

Zone square_with_house() { return zone_of(box(0, 0, 60, 60), {box(25, 25, 31, 33)}, true); }

/// Sparse enough for many to walk freely, and for many to meet.
Scene sparse_square(const Zone& zone, bool reversed) {
  Scene scene(zone, 4);
  constexpr std::uint64_t kPeople = 40;
  for (std::uint64_t n = 0; n < kPeople; ++n) {
    const std::uint64_t k = reversed ? kPeople - 1 - n : n;
    const auto place = [&](std::uint64_t what) {
      return 2.0 + 56.0 * random_uniform(31, k, what, Purpose::kPlacement);
    };
    NewPerson person;
    person.key = 100 + k;
    person.position = {place(1), k % 2 == 0 ? 2.0 + 0.3 * place(2) : 40.0 + 0.3 * place(2)};
    person.destination = point(place(3), k % 2 == 0 ? 58.0 : 2.0);
    scene.add(person);
  }
  return scene;
}

TEST(FreeWalk, lets_nobody_into_others_or_walls) {
  const Zone zone = square_with_house();
  Scene scene = sparse_square(zone, false);
  double worst = 0.0;
  while (scene.time < 60.0) {
    scene.step(1.0);
    worst = std::max(worst, scene.worst_present_overlap());
  }
  EXPECT_LT(worst, 0.01);
  EXPECT_GE(scene.least_wall_gap(), -1e-6);
  EXPECT_GT(scene.arrived(), 35u);
}

TEST(FreeWalk, does_not_depend_on_the_order_of_people) {
  const Zone zone = square_with_house();
  Scene forth = sparse_square(zone, false), back = sparse_square(zone, true);
  for (int k = 0; k < 40; ++k) {
    forth.step(1.0);
    back.step(1.0);
  }
  for (const Scene::Person& person : forth.people) {
    const auto same = std::ranges::find(back.people, person.given.key,
                                        [](const Scene::Person& p) { return p.given.key; });
    EXPECT_EQ(person.path, same->path);
  }
}

}  // namespace
}  // namespace pedzone::test
