// Groups: who waits for whom, how they stay together, part and join again.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "group_scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kMaximum = 4.0, kPreferred = 1.5;  // [m] the parameters' defaults
constexpr double kStopping = 1.0;  // [m] 0.5 s at up to 2 m/s: a walking body does not stop at once

/// Six persons of very different speeds side by side, who go 100 m along +x.
class Six {
 public:
  explicit Six(const Zone& zone, std::uint64_t seed = 1, std::uint64_t group = 7)
      : scene(zone, seed) {
    const double speeds[] = {1.0, 1.15, 1.3, 1.4, 1.55, 1.7};
    for (int k = 0; k < 6; ++k) add({2.0 + (k % 2), 7.0 + k}, speeds[k], group);
  }

  std::size_t add(const Vec2& from, double speed, std::uint64_t group) {
    NewPerson person = member(from, line_at_x(kEnd, 1, 19), group);
    person.preferred_speed = speed;
    return scene.add(person);
  }

  /// [m] way left, as the plane has it: there is nothing to go round.
  double left(std::size_t person) const { return kEnd - scene.people[person].view.position.x(); }

  double spread() const {
    double least = 1e9, most = -1e9;
    for (std::size_t k = 0; k < scene.people.size(); ++k) {
      if (!scene.people[k].here) continue;
      least = std::min(least, left(k));
      most = std::max(most, left(k));
    }
    return most - least;
  }

  static constexpr double kEnd = 100.0;
  Scene scene;
};

Zone open_space() { return zone_of(box(0, 0, 101, 20), {}, true); }

TEST(Group, stays_together_where_its_persons_alone_would_not) {
  const Zone zone = open_space();
  Six group(zone), alone(zone, 1, 0);
  double widest = 0.0, widest_alone = 0.0;
  while (group.scene.arrived() == 0 && group.scene.time < 200) {
    group.scene.step();
    widest = std::max(widest, group.spread());
    if (alone.scene.arrived() == 0) alone.scene.step();
    widest_alone = std::max(widest_alone, alone.spread());
  }
  EXPECT_LE(widest, kMaximum + kStopping);
  EXPECT_GT(widest_alone, 3.0 * (kMaximum + kStopping));
  group.scene.run(300);
  EXPECT_EQ(group.scene.arrived(), 6u);
}

TEST(Group, somebody_waits_and_walks_on_and_never_the_last) {
  const Zone zone = open_space();
  Six group(zone);
  std::vector<bool> waited(6), walked_on(6);
  while (group.scene.arrived() == 0 && group.scene.time < 200) {
    std::vector<double> left;  // before the step: what its waiting rests on
    for (std::size_t k = 0; k < 6; ++k) left.push_back(group.left(k));
    const double last = *std::max_element(left.begin(), left.end());
    group.scene.step();
    for (std::size_t k = 0; k < 6; ++k) {
      const bool waits = group.scene.people[k].view.waits_for_group, before = waited[k];
      EXPECT_TRUE(!waits || last - left[k] > kPreferred);
      EXPECT_TRUE(!waits || before || last - left[k] > kMaximum);
      if (before && !waits) {
        EXPECT_LE(last - left[k], kPreferred);
        walked_on[k] = true;
      }
      waited[k] = waits;
    }
  }
  EXPECT_GE(std::count(walked_on.begin(), walked_on.end(), true), 2);
}

TEST(Group, who_waits_stands_and_turns_to_the_others) {
  const Zone zone = open_space();
  Scene scene(zone);
  const auto ahead = scene.add(member({20, 10}, line_at_x(100, 1, 19), 1));
  scene.add(member({12, 10}, line_at_x(100, 1, 19), 1));
  for (int k = 0; k < 30; ++k) scene.step();
  const PersonView& view = scene.people[ahead].view;
  EXPECT_TRUE(view.waits_for_group);
  EXPECT_LT(view.velocity.norm(), 0.05);
  EXPECT_LT(std::cos(view.heading), -0.9);
  EXPECT_EQ(view.motion, Motion::kStanding);
  scene.run(120);
  EXPECT_EQ(scene.arrived(), 2u);
}

// Two waypoints 20 m apart: the first of the two has passed one and has the next before it.
TEST(Group, members_on_different_waypoints_of_a_path_compare) {
  const Zone zone = open_space();
  Scene scene(zone);
  NewPerson slow = member({5, 10}, line_at_x(100, 1, 19), 1);
  NewPerson quick = member({5, 11}, line_at_x(100, 1, 19), 1);
  slow.preferred_speed = 0.9;
  slow.path = quick.path = {{{20, 10}, 1.0}, {{40, 14}, 1.0}, {{60, 6}, 1.0}};
  const auto last = scene.add(slow);
  const auto first = scene.add(quick);
  double widest = 0.0;
  while (scene.arrived() == 0 && scene.time < 200) {
    scene.step();
    if (scene.people[last].here && scene.people[first].here) {
      widest = std::max(
          widest, (scene.people[first].view.position - scene.people[last].view.position).norm());
    }
  }
  EXPECT_GT(widest, 3.0);
  EXPECT_LE(widest, kMaximum + kStopping + 1.0);  // and some metre aside
}

TEST(Group, others_do_not_count) {
  const Zone zone = open_space();
  Scene scene(zone);
  const auto ahead = scene.add(member({20, 10}, line_at_x(100, 1, 19), 1));
  scene.add(member({10, 8}, line_at_x(100, 1, 19), 2));
  scene.add(member({8, 12}, line_at_x(100, 1, 19), 0));
  while (scene.people[ahead].here && scene.time < 100) {
    scene.step();
    ASSERT_FALSE(scene.people[ahead].view.waits_for_group);
  }
}

TEST(Group, nobody_waits_for_one_who_goes_to_another_place) {
  const Zone zone = open_space();
  const double ends[] = {1.0, 60.0};  // the other way; the same way, less far
  for (const double end : ends) {
    Scene scene(zone);
    const auto one = scene.add(member({30, 10}, line_at_x(100, 1, 19), 1));
    NewPerson slow = member({30, 12}, line_at_x(end, 1, 19), 1);
    slow.preferred_speed = 0.6;
    scene.add(slow);
    while (scene.arrived() < 2 && scene.time < 120) {
      scene.step();
      ASSERT_FALSE(scene.people[one].here && scene.people[one].view.waits_for_group) << end;
    }
    EXPECT_EQ(scene.arrived(), 2u) << end;
    EXPECT_LT(scene.time, 75.0) << end;
  }
}

TEST(Group, who_goes_to_the_same_place_still_belongs_together) {
  const Zone zone = open_space();
  Scene scene(zone);
  const auto quick = scene.add(member({30, 10}, line_at_x(100, 1, 19), 1));
  scene.add(member({30, 8}, line_at_x(1, 1, 19), 1));
  NewPerson slow = member({20, 12}, line_at_x(100, 1, 19), 1);
  scene.add(slow);
  scene.step();
  EXPECT_TRUE(scene.people[quick].view.waits_for_group);
}

TEST(Group, whoever_has_gone_counts_no_more) {
  const Zone zone = open_space();
  Crowd crowd(zone, 1);
  const auto ahead = crowd.add(member({20, 10}, line_at_x(100, 1, 19), 1));
  const auto behind = crowd.add(member({5, 10}, line_at_x(100, 1, 19), 1));
  crowd.step(0.5, {});
  ASSERT_TRUE(crowd.view(ahead).waits_for_group);
  crowd.remove(behind);
  crowd.step(0.1, {});
  EXPECT_FALSE(crowd.view(ahead).waits_for_group);
}

// The last one is as slow as if it stood: the other goes on after its patience, waits again, and
// still comes to its end.
TEST(Group, does_not_wait_for_ever_for_one_who_is_stuck) {
  const Zone zone = open_space();
  Scene scene(zone);
  NewPerson stuck = member({2, 10}, line_at_x(100, 1, 19), 1);
  stuck.preferred_speed = 0.01;
  scene.add(stuck);
  const auto other = scene.add(member({10, 10}, line_at_x(100, 1, 19), 1));
  int turns = 0;
  bool before = false;
  while (scene.people[other].here && scene.time < 400) {
    scene.step();
    turns += scene.people[other].view.waits_for_group != before ? 1 : 0;
    before = scene.people[other].view.waits_for_group;
  }
  const double alone = 90.0 / 1.34;
  EXPECT_GT(scene.people[other].arrival_time, 1.5 * alone);
  EXPECT_LT(scene.people[other].arrival_time, 2.5 * alone);
  EXPECT_GE(turns, 6);
}

// The one who comes late is 60 m behind: as long as it comes nearer, it is waited for.
TEST(Group, waits_for_whoever_comes_nearer) {
  const Zone zone = open_space();
  Scene scene(zone);
  const auto first = scene.add(member({62, 10}, line_at_x(100, 1, 19), 1));
  scene.add(member({2, 10}, line_at_x(100, 1, 19), 1));
  scene.step();
  double waited = 0.0;
  while (scene.people[first].view.waits_for_group && scene.time < 100) {
    scene.step();
    waited = scene.time;
  }
  EXPECT_NEAR(waited, 58.0 / 1.34, 3.0);
}

TEST(Group, makes_room_in_a_passage_for_one_of_its_own) {
  // 1.3 m wide: two bodies fit side by side only if one of them steps aside.
  const Zone zone = zone_of(box(0, 0, 60, 1.3), {}, false);
  Scene scene(zone);
  NewPerson last = member({2, 0.65}, line_at_x(59, 0, 1.3), 1);
  last.preferred_speed = 0.3;
  scene.add(last);
  const auto waiting = scene.add(member({14, 0.65}, line_at_x(59, 0, 1.3), 1));
  const auto behind = scene.add(member({9, 0.65}, line_at_x(59, 0, 1.3), 1));
  (void)waiting;
  scene.run(600);
  EXPECT_EQ(scene.arrived(), 3u) << scene.people[behind].view.position.x();
  EXPECT_GE(scene.least_wall_gap(), -1e-3);
}

TEST(Group, who_waits_steps_to_the_side_on_which_it_stands_already) {
  const Zone zone = zone_of(box(0, 0, 60, 10));
  for (const double side : {1.0, -1.0}) {
    // The first has 21 m left, and so waits for the second, which has 32 m left and sets out from
    // 1.8 m behind it.
    const double y = 5.0 + 0.1 * side;
    NewPerson first = member({20.0, y}, Destination{{41.0, y}, {41.0, y}}, 7);
    NewPerson second = member({18.2, 5.0}, Destination{{50.0, 5.0}, {50.0, 5.0}}, 7);
    first.velocity = second.velocity = Vec2::Zero();
    Scene scene(zone);
    const std::size_t one = scene.add(first);
    scene.add(second);
    for (int k = 0; k < 6; ++k) scene.step();
    ASSERT_TRUE(scene.people[one].view.waits_for_group);
    EXPECT_GT(side * (scene.people[one].view.position.y() - y), 0.02) << side;
  }
}

TEST(Group, nobody_waits_in_the_way_of_a_vehicle) {
  const Zone zone = open_space();
  Scene scene(zone);
  scene.add(member({8, 10}, line_at_x(100, 1, 19), 1));
  const auto ahead = scene.add(member({20, 10}, line_at_x(100, 1, 19), 1));
  for (int k = 0; k < 20; ++k) scene.step();
  ASSERT_TRUE(scene.people[ahead].view.waits_for_group);
  const double x = scene.people[ahead].view.position.x();
  scene.vehicles = {vehicle_at({x, 10 - 12}, kPi / 2, 3.0)};  // across, from its right
  for (int k = 0; k < 60; ++k) scene.step();
  EXPECT_GE(scene.least_vehicle_gap(), 0.2);
  scene.run(200);
  EXPECT_EQ(scene.arrived(), 2u);
}

TEST(Group, joins_again_behind_an_obstacle) {
  const Zone zone = zone_of(box(0, 0, 101, 20), {box(40, 8, 46, 14)}, true);
  Six group(zone, 3);
  double before = 0.0, after = 0.0;
  while (group.scene.arrived() == 0 && group.scene.time < 200) {
    group.scene.step();
    const double x = group.scene.people[0].view.position.x();
    if (x < 36) before = std::max(before, group.spread());
    if (x > 56) after = std::max(after, group.spread());
  }
  EXPECT_LE(before, kMaximum + kStopping);
  EXPECT_LE(after, kMaximum + kStopping);
  group.scene.run(300);
  EXPECT_EQ(group.scene.arrived(), 6u);
}

// The paper's 5.3, with a vehicle that brakes for nobody.
TEST(Group, is_parted_by_a_vehicle_in_a_narrow_zone_and_joins_again) {
  const Zone zone = zone_of(box(0, 0, 101, 20), {box(20, 0, 80, 6.5), box(20, 13.5, 80, 20)}, true);
  Six group(zone, 5);
  group.scene.vehicles = {vehicle_at({100, 10}, kPi, 1.5)};
  bool left_of_it = false, right_of_it = false;
  while (group.scene.vehicles[0].centre.x() > -20) {
    group.scene.step();
    const VehicleState& vehicle = group.scene.vehicles[0];
    for (const auto& person : group.scene.people) {
      const Vec2 away = person.view.position - vehicle.centre;
      if (std::abs(away.x()) > 0.5 * vehicle.length) continue;
      (away.y() > 0 ? left_of_it : right_of_it) = true;
    }
  }
  EXPECT_TRUE(left_of_it && right_of_it);
  EXPECT_LE(group.spread(), kMaximum + kStopping);
  EXPECT_GE(group.scene.least_vehicle_gap(), 0.0);
  group.scene.run(300);
  EXPECT_EQ(group.scene.arrived(), 6u);
}

TEST(Group, fifty_seeds_give_fifty_outcomes_all_of_them_valid) {
  const Zone zone = zone_of(box(0, 0, 101, 20), {box(40, 7, 44, 12)}, true);
  std::set<std::vector<double>> outcomes;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Six group(zone, seed);
    group.scene.vehicles = {vehicle_at({60, 40}, -kPi / 2, 2.0)};
    std::vector<double> outcome;
    group.scene.run(240);
    EXPECT_EQ(group.scene.arrived(), 6u) << seed;
    EXPECT_GE(group.scene.least_wall_gap(), -1e-3) << seed;
    EXPECT_GE(group.scene.least_vehicle_gap(), -0.01) << seed;
    for (const auto& person : group.scene.people) {
      outcome.push_back(person.arrival_time);
      outcome.push_back(person.walked);
    }
    outcomes.insert(outcome);
  }
  EXPECT_EQ(outcomes.size(), 50u);
}

TEST(Group, neither_order_nor_threads_change_a_bit) {
  const Zone zone = zone_of(box(0, 0, 60, 60), {box(20, 20, 24, 30)}, true);
  const std::vector<VehicleState> traffic{vehicle_at({-5, 28}, 0.0, 2.0)};
  std::vector<NewPerson> people;
  for (int k = 0; k < 300; ++k) {
    NewPerson person = member({2.0 + (k % 20), 2.0 + (k / 20) * 1.2},
                              k % 3 == 0 ? line_at_x(59, 1, 59) : line_at_y(59, 1, 59),
                              static_cast<std::uint64_t>(1 + k / 6));
    person.key = person_key(std::to_string(k));
    person.preferred_speed = 0.8 + 0.15 * (k % 6);
    person.profile = k % 6 == 5 ? profile("infant") : nullptr;
    people.push_back(person);
  }
  const auto places = [&](std::size_t threads) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                            threads);
    Crowd crowd(zone, 4);
    std::vector<std::pair<std::uint64_t, Crowd::Handle>> handles;
    for (const NewPerson& person : people) handles.emplace_back(person.key, crowd.add(person));
    for (int k = 0; k < 100; ++k) crowd.step(0.1, traffic);
    std::sort(handles.begin(), handles.end());
    std::vector<double> found;
    for (const auto& [key, handle] : handles) {
      const PersonView view = crowd.view(handle);
      found.insert(found.end(), {view.position.x(), view.position.y(), view.heading});
    }
    return found;
  };
  const auto first = places(1);
  EXPECT_EQ(first, places(4));
  std::reverse(people.begin(), people.end());
  EXPECT_EQ(first, places(2));
}

TEST(Group, patience_does_not_run_out_while_one_waits_for_the_others) {
  const Zone zone = zone_of(box(0, 0, 60, 10));
  Scene scene(zone);
  const Destination end{{30.0, 5.0}, {30.0, 5.0}};
  // Ahead, 2.5 m before its destination; the other comes nearer all the time, at a third of the
  // pace. It is 19 m behind: some 35 s of waiting, three times the patience.
  NewPerson ahead = member({27.5, 5.0}, end, 7), behind = member({8.0, 5.0}, end, 7);
  behind.preferred_speed = 0.5;
  const std::size_t waiting = scene.add(ahead), coming = scene.add(behind);
  while (scene.people[coming].view.position.x() < 24.0 && scene.time < 60.0) {
    scene.step();
    const PersonView& view = scene.people[waiting].view;
    ASSERT_TRUE(scene.people[waiting].here && !view.gave_up && !view.arrived) << scene.time;
  }
  EXPECT_GT(scene.time, 2.0 * zone.parameters.patience);
}

}  // namespace
}  // namespace pedzone::test
