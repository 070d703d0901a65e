// Vehicles that wait at a zone's border for people whom SUMO walks, who wait for them.
#include "sumo/plan/stand_off.hpp"

#include <gmock/gmock.h>

#include "four_edges.hpp"
#include "sumo/plan/yielding.hpp"

namespace pedzone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class StandOffTest : public testing::Test, protected test::FourEdges {
 protected:
  StandOffTest() { vehicles_ = {standing("van", 80.0)}; }

  static FleetVehicle standing(const std::string& id, double x) {
    FleetVehicle vehicle;
    static_cast<VehicleSeen&>(vehicle) = test::seen_vehicle(id, {x, 0.0}, 0.0);
    vehicle.way = {{x - 4.0, 0.0}, {x, 0.0}, {x + 30.0, 0.0}};
    return vehicle;
  }

  std::vector<SpeedOrder> step(double dt) { return stand_offs_->plan(vehicles_, people_, dt); }
  /// The first orders, after so many [s] at most; none where there are none until then.
  std::vector<SpeedOrder> wait(double most, double dt = 0.1) {
    std::vector<SpeedOrder> orders;
    for (time_ = 0.0; orders.empty() && time_ < most;) {
      orders = step(dt);
      time_ += dt;
    }
    return orders;
  }

  const std::vector<Zone> zones_{zone};
  const double creep_after_ = zone.parameters.creep_after, creep_ = zone.parameters.creep_speed;
  std::optional<StandOffs> stand_offs_{std::in_place, zones_};
  std::vector<FleetVehicle> vehicles_;
  std::vector<PersonAhead> people_{{{79.0, 2.0}, {0.0, 0.0}, 0.24}};  // 1 m beside the van
  double time_ = 0.0;                                                 ///< [s]
};

TEST_F(StandOffTest, vehicle_creeps_past_people_after_seconds_and_not_after_steps) {
  for (const double dt : {0.1, 0.5, 1.0}) {
    stand_offs_.emplace(zones_);
    vehicles_[0].commanded = kOwnSpeed;
    EXPECT_THAT(wait(100.0, dt),
                ElementsAre(SpeedOrder{"van", SpeedMode::kPass}, SpeedOrder{"van", creep_}));
    EXPECT_NEAR(time_, creep_after_, dt + 1e-6) << dt;
    EXPECT_EQ(vehicles_[0].commanded, creep_);
  }
}

/// Two inside a junction who stand beside each other, their ways join ahead of the first; nobody is
/// near, but people have held the second.
class GridlockTest : public StandOffTest {
 protected:
  GridlockTest() {
    people_.clear();
    vehicles_.push_back(standing("car", 77.0));
    vehicles_[1].front.y() = 1.95;  // nearer than one would come
    vehicles_[1].way = {{73.0, 1.95}, {77.0, 1.95}, {82.0, 0.0}, {110.0, 0.0}};
    for (FleetVehicle& vehicle : vehicles_) vehicle.junction = {.junction = 3, .end = 5.0};
    vehicles_[1].left_alone = 60.0;
  }
};

TEST_F(GridlockTest, is_ended_by_the_one_whose_way_is_free) {
  EXPECT_THAT(wait(100.0),
              ElementsAre(SpeedOrder{"van", SpeedMode::kPass}, SpeedOrder{"van", creep_}));
  EXPECT_NEAR(time_, creep_after_, 0.2);
}

TEST_F(GridlockTest, is_ended_by_one_of_two_at_a_time) {
  vehicles_[1].way = {{73.0, 1.95}, {77.0, 1.95}, {110.0, 1.95}};
  EXPECT_THAT(wait(100.0),
              ElementsAre(SpeedOrder{"van", SpeedMode::kPass}, SpeedOrder{"van", creep_}));
}

TEST_F(GridlockTest, is_none_where_people_held_nobody_or_another_drives_or_is_elsewhere) {
  const std::vector<FleetVehicle> before = vehicles_;
  const auto expect_none = [&](const char* why) {
    stand_offs_.emplace(zones_);
    EXPECT_THAT(wait(3.0 * creep_after_), IsEmpty()) << why;
    vehicles_ = before;
  };
  vehicles_[1].left_alone = std::numeric_limits<double>::infinity();
  expect_none("people held nobody: SUMO's matter");
  vehicles_[1].speed = 1.0;
  expect_none("the other drives");
  vehicles_[1].junction.junction = 4;
  expect_none("the other is elsewhere");
  vehicles_[1].junction.begin = 1.0;
  expect_none("the other has not come in");
  vehicles_[0].junction.begin = 1.0;
  expect_none("it has not come in itself");
}

TEST_F(StandOffTest, ends_when_nobody_is_beside_any_more) {
  wait(100.0);
  vehicles_[0].commanded = kOwnSpeed;  // as Yielding leaves it
  vehicles_[0].speed = creep_;
  EXPECT_THAT(step(0.1), ElementsAre(SpeedOrder{"van", creep_})) << "goes on while it passes";
  vehicles_[0].commanded = kOwnSpeed;
  people_.clear();
  EXPECT_THAT(step(0.1),
              ElementsAre(SpeedOrder{"van", SpeedMode::kOwn}, SpeedOrder{"van", kOwnSpeed}));
  EXPECT_THAT(step(0.1), IsEmpty());
}

TEST_F(StandOffTest, goes_on_though_yielding_finds_nobody_whom_it_would_let_go_gently) {
  const SafeSpeeds any{[](const FleetVehicle&, double) { return 10.0; },
                       [](const FleetVehicle&, double, double) { return 10.0; }};
  for (const double dt : {0.1, 0.5, 1.0}) {
    stand_offs_.emplace(zones_);
    Yielding yielding(zones_);
    vehicles_ = {standing("van", 80.0)};
    vehicles_[0].allowed_speed = 10.0;
    wait(100.0, dt);
    for (int k = 0; k < 10; ++k) {  // what it was told carries over
      vehicles_[0].speed = k == 0 ? 0.0 : creep_;
      EXPECT_THAT(yielding.plan(vehicles_, PeopleNear({}), {}, any, 0.0, dt), IsEmpty());
      EXPECT_THAT(step(dt), ElementsAre(SpeedOrder{"van", creep_})) << dt << ' ' << k;
    }
  }
}

TEST_F(StandOffTest, ends_at_a_stop_of_the_vehicles_own) {
  wait(100.0);
  vehicles_[0].commanded = kOwnSpeed;
  vehicles_[0].stopped = true;
  EXPECT_THAT(step(0.1),
              ElementsAre(SpeedOrder{"van", SpeedMode::kOwn}, SpeedOrder{"van", kOwnSpeed}))
      << "it drives on after the stop as fast as it likes";
  EXPECT_THAT(step(0.1), IsEmpty());
}

TEST_F(StandOffTest, time_at_a_stop_of_its_own_does_not_count) {
  vehicles_[0].stopped = true;
  wait(creep_after_ + 10.0);
  vehicles_[0].stopped = false;
  EXPECT_THAT(wait(creep_after_ - 0.15), IsEmpty());
  EXPECT_THAT(wait(1.0), testing::SizeIs(2));
}

TEST_F(StandOffTest, passes_in_a_junction_for_as_long_as_it_takes) {
  vehicles_[0].junction = {.junction = 3, .end = 90.0};
  wait(100.0);
  for (double passed = 0.0; passed < 3.0 * creep_after_; passed += 1.0) {
    vehicles_[0].commanded = kOwnSpeed;
    vehicles_[0].speed = creep_;
    EXPECT_THAT(step(1.0), ElementsAre(SpeedOrder{"van", creep_})) << passed;
  }
}

TEST_F(StandOffTest, passes_on_a_street_by_its_length_and_five_metres_whoever_else_walks_there) {
  wait(100.0);
  double passed = 0.0;
  for (; passed < 60.0; passed += creep_) {
    vehicles_[0].commanded = kOwnSpeed;
    vehicles_[0].speed = creep_;
    if (step(1.0).back() == SpeedOrder{"van", kOwnSpeed}) break;
  }
  EXPECT_NEAR(passed, vehicles_[0].traits.length + 5.0, creep_);
}

TEST_F(StandOffTest, is_none_at_a_red_light) {
  vehicles_[0].junction = {.junction = 3, .begin = 1.0, .end = 15.0, .signalled = true};
  EXPECT_THAT(wait(119.0), IsEmpty());
  EXPECT_THAT(wait(2.0), testing::SizeIs(2)) << "no light is red for so long";
}

TEST_F(StandOffTest, each_try_has_its_own_way) {
  vehicles_[0].junction = {.junction = 3, .end = 90.0};
  wait(100.0);
  const auto told = [&](double speed, double dt) {
    vehicles_[0].commanded = kOwnSpeed;
    vehicles_[0].speed = speed;
    return step(dt);
  };
  for (int k = 0; k < 30; ++k) told(creep_, 1.0);  // farther than on a street
  while (told(0.0, 0.5).back() != SpeedOrder{"van", kOwnSpeed}) continue;
  vehicles_[0].junction = {};
  wait(100.0);
  EXPECT_THAT(told(creep_, 1.0), ElementsAre(SpeedOrder{"van", creep_}));
}

TEST_F(StandOffTest, nobody_is_let_go_between_lights) {
  people_ = {{{83.0, 0.0}, {0.0, 0.0}, 0.24}};  // before the van
  vehicles_[0].junction = {.junction = 3, .begin = -5.0, .end = 15.0, .signalled = true};
  EXPECT_THAT(wait(3.0 * creep_after_), IsEmpty());
  vehicles_[0].junction.begin = 30.0;
  EXPECT_THAT(wait(1.0), ElementsAre(SpeedOrder{"van", 0.0})) << "far before them they are";
}

TEST_F(StandOffTest, waits_again_where_sumo_does_not_let_it_past) {
  const auto step_back = [&](double dt) {
    vehicles_[0].commanded = kOwnSpeed;
    return step(dt);
  };
  for (const double dt : {0.1, 0.5}) {
    stand_offs_.emplace(zones_);
    vehicles_[0].commanded = kOwnSpeed;
    wait(100.0, dt);
    for (double tried = dt; tried < 2.0 - 0.5 * dt; tried += dt) {
      ASSERT_THAT(step_back(dt), ElementsAre(SpeedOrder{"van", creep_})) << tried;
    }
    EXPECT_THAT(step_back(dt),
                ElementsAre(SpeedOrder{"van", SpeedMode::kOwn}, SpeedOrder{"van", kOwnSpeed}));
    EXPECT_THAT(wait(creep_after_ - 1.5 * dt, dt), IsEmpty());
    EXPECT_THAT(wait(2.0 * dt, dt), testing::SizeIs(2)) << "and tries again";
  }
}

TEST_F(StandOffTest, tries_for_as_long_however_long_it_has_waited_before) {
  vehicles_.push_back(standing("lorry", 80.0 + 4.0 + 4.9));
  vehicles_.back().traits.yields = false;
  EXPECT_THAT(wait(3.0 * creep_after_), IsEmpty()) << "it could not go either";
  people_.push_back({{83.0, 0.0}, {0.0, 0.0}, 0.24});
  for (double told = 0.0; told < creep_after_ - 0.15; told += 0.1) {
    ASSERT_THAT(step(0.1), ElementsAre(SpeedOrder{"van", 0.0})) << told;
  }
}

TEST_F(StandOffTest, ends_for_one_that_has_gone_and_comes_back) {
  const std::vector<SpeedOrder> mode{{"van", SpeedMode::kOwn}}, own{{"van", kOwnSpeed}};
  for (const bool passes : {true, false}) {
    stand_offs_.emplace(zones_);
    people_ = {{{passes ? 79.0 : 83.0, passes ? 2.0 : 0.0}, {0.0, 0.0}, 0.24}};
    vehicles_ = {standing("van", 80.0)};
    wait(100.0);
    vehicles_.clear();  // SUMO teleports it
    EXPECT_THAT(step(0.1), IsEmpty()) << "SUMO would end at an order for one that is not there";
    EXPECT_THAT(step(0.1), IsEmpty());
    vehicles_ = {standing("van", 80.0)};
    vehicles_[0].speed = 5.0;
    std::vector<SpeedOrder> expected = own;
    if (passes) expected.insert(expected.begin(), mode.front());
    EXPECT_EQ(step(0.1), expected) << passes;
    EXPECT_THAT(step(0.1), IsEmpty());
  }
}

TEST_F(StandOffTest, tells_one_nothing_that_another_program_drives_until_it_no_longer_does) {
  wait(100.0);
  vehicles_[0].traits.external = true;
  vehicles_[0].speed = 5.0;
  for (int k = 0; k < 300; ++k) ASSERT_THAT(step(0.1), IsEmpty());
  vehicles_[0].traits.external = false;
  vehicles_[0].commanded = kOwnSpeed;
  EXPECT_THAT(step(0.1),
              ElementsAre(SpeedOrder{"van", SpeedMode::kOwn}, SpeedOrder{"van", kOwnSpeed}));
  EXPECT_THAT(step(0.1), IsEmpty());
}

TEST_F(StandOffTest, ends_when_the_vehicle_has_left_the_zone) {
  wait(100.0);
  vehicles_[0] = standing("van", 24.0);
  people_[0].position.x() = 23.0;
  EXPECT_THAT(step(0.1),
              ElementsAre(SpeedOrder{"van", SpeedMode::kOwn}, SpeedOrder{"van", kOwnSpeed}));
}

TEST_F(StandOffTest, leaves_the_speed_to_yielding_once_that_holds_the_vehicle) {
  wait(100.0);
  vehicles_[0].commanded = 0.1;
  EXPECT_THAT(step(0.1), ElementsAre(SpeedOrder{"van", SpeedMode::kOwn}));
  EXPECT_EQ(vehicles_[0].commanded, 0.1);
}

TEST_F(StandOffTest, creeps_past_too_where_yielding_lets_it_drive_and_sumo_does_not) {
  for (const double told : {0.26, 2.6}) {
    stand_offs_.emplace(zones_);
    std::vector<SpeedOrder> orders;
    for (time_ = 0.0; orders.empty() && time_ < 100.0; time_ += 0.1) {
      vehicles_[0].commanded = told;
      orders = step(0.1);
    }
    EXPECT_NEAR(time_, creep_after_, 0.1 + 1e-6);
    const double speed = std::min(told, creep_);
    EXPECT_THAT(orders, ElementsAre(SpeedOrder{"van", SpeedMode::kPass}, SpeedOrder{"van", speed}));
    EXPECT_EQ(vehicles_[0].commanded, speed);
  }
}

TEST_F(StandOffTest, is_none_while_yielding_holds_the_vehicle) {
  vehicles_[0].commanded = 0.0;
  EXPECT_THAT(wait(100.0), IsEmpty());
}

TEST_F(StandOffTest, is_none_at_a_stop_of_its_own) {
  vehicles_[0].stopped = true;
  EXPECT_THAT(wait(100.0), IsEmpty());
}

TEST_F(StandOffTest, is_none_of_vehicles_that_do_not_yield_or_are_others) {
  vehicles_[0].traits.yields = false;
  EXPECT_THAT(wait(100.0), IsEmpty());
  vehicles_[0].traits = {};
  vehicles_[0].traits.external = true;
  EXPECT_THAT(wait(100.0), IsEmpty());
}

TEST_F(StandOffTest, needs_somebody_within_three_metres) {
  people_[0].position = {79.0, 1.0 + 3.1};
  EXPECT_THAT(wait(100.0), IsEmpty());
  people_[0].position = {79.0, 1.0 + 2.9};
  EXPECT_THAT(wait(100.0), testing::SizeIs(2));
}

TEST_F(StandOffTest, lets_people_in_its_way_go_first) {
  people_.push_back({{83.0, 0.0}, {0.0, 0.0}, 0.24});
  EXPECT_THAT(wait(100.0), ElementsAre(SpeedOrder{"van", 0.0}));
  EXPECT_NEAR(time_, creep_after_, 0.1 + 1e-6);
  EXPECT_LT(vehicles_[0].commanded, 0.0) << "nobody whom pedzone walks holds it";
  EXPECT_THAT(step(0.1), ElementsAre(SpeedOrder{"van", 0.0})) << "as long as they are there";
  people_.clear();
  EXPECT_THAT(step(0.1), ElementsAre(SpeedOrder{"van", kOwnSpeed}));
  EXPECT_THAT(step(0.1), IsEmpty());
}

TEST_F(StandOffTest, waits_again_where_people_do_not_go) {
  people_.push_back({{83.0, 0.0}, {0.0, 0.0}, 0.24});
  wait(100.0);
  std::vector<SpeedOrder> orders;
  for (double told = 0.0; told < creep_after_ - 0.15; told += 0.1) orders = step(0.1);
  EXPECT_THAT(orders, ElementsAre(SpeedOrder{"van", 0.0}));
  EXPECT_THAT(step(0.1), ElementsAre(SpeedOrder{"van", kOwnSpeed}));
  EXPECT_THAT(wait(creep_after_ - 0.15), IsEmpty());
  EXPECT_THAT(wait(1.0), ElementsAre(SpeedOrder{"van", 0.0}));
}

TEST_F(StandOffTest, goes_from_passing_to_letting_go) {
  wait(100.0);
  vehicles_[0].commanded = kOwnSpeed;
  people_.push_back({{83.0, 0.0}, {0.0, 0.0}, 0.24});
  EXPECT_THAT(step(0.1), ElementsAre(SpeedOrder{"van", SpeedMode::kOwn}, SpeedOrder{"van", 0.0}));
}

TEST_F(StandOffTest, brakes_for_people_no_harder_than_sumo_does_at_its_word) {
  wait(100.0);
  vehicles_[0].commanded = kOwnSpeed;
  vehicles_[0].speed = 1.0;
  people_.push_back({{83.0, 0.0}, {0.0, 0.0}, 0.24});
  const auto orders = step(0.1);
  ASSERT_THAT(orders, testing::SizeIs(2));
  EXPECT_DOUBLE_EQ(std::get<double>(orders[1].what), 1.0 - vehicles_[0].traits.decel * 0.1);
  EXPECT_TRUE(vehicles_[0].lets_go);
}

TEST_F(StandOffTest, looks_five_metres_ahead) {
  people_ = {{{80.0 + 5.0 + 1.0, 0.0}, {0.0, 0.0}, 0.24}};
  EXPECT_THAT(wait(100.0), IsEmpty());
  people_[0].position.x() = 80.0 + 5.0;
  EXPECT_THAT(wait(100.0), ElementsAre(SpeedOrder{"van", 0.0}));
}

TEST_F(StandOffTest, is_none_with_a_vehicle_in_the_way) {
  vehicles_.push_back(standing("lorry", 80.0 + 4.0 + 4.9));
  vehicles_.back().traits.yields = false;
  EXPECT_THAT(wait(100.0), IsEmpty());
  vehicles_.back().front.x() = 80.0 + 4.0 + 7.0;
  EXPECT_THAT(wait(100.0), testing::SizeIs(2));
}

TEST_F(StandOffTest, is_none_far_from_the_zone) {
  vehicles_[0] = standing("van", 24.0);  // the zone begins at 50, and what is 5 m from it counts
  people_[0].position.x() = 23.0;
  EXPECT_THAT(wait(100.0), IsEmpty());
}

TEST_F(StandOffTest, ends_before_the_zone_too_for_one_that_comes_to_it) {
  vehicles_[0] = standing("van", 40.0);
  people_[0].position.x() = 39.0;
  EXPECT_THAT(wait(100.0), testing::SizeIs(2));
}

TEST_F(StandOffTest, counts_anew_when_the_vehicle_has_moved) {
  wait(creep_after_ - 1.0);
  vehicles_[0].speed = 0.2;
  EXPECT_THAT(step(0.1), IsEmpty());
  vehicles_[0].speed = 0.0;
  EXPECT_THAT(wait(creep_after_ - 1.0), IsEmpty());
}

}  // namespace
}  // namespace pedzone
