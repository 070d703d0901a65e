// What vehicles are told for people in their way, and when they are given back.
#include "sumo/plan/yielding.hpp"

#include <gmock/gmock.h>

#include <array>

namespace pedzone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kStep = 0.1;  // [s]
const std::vector<PersonAhead> kNear{{{4.0, 0.0}, {0.0, 0.0}, 0.24}};
/// No braking from 8 m/s is enough.
const std::vector<PersonAhead> kTooNear{{{2.0, 0.0}, {0.0, 0.0}, 0.24}};

class YieldingTest : public testing::Test {
 protected:
  YieldingTest() {
    vehicle_.id = "shuttle";
    vehicle_.traits.length = 4.0;
    vehicle_.traits.width = 2.0;
    vehicle_.way = {{-4.0, 0.0}, {0.0, 0.0}, {60.0, 0.0}};
    vehicle_.speed = 1.0;
    vehicle_.allowed_speed = 10.0;
  }

  std::vector<SpeedOrder> plan(const std::vector<PersonAhead>& people) {
    const SafeSpeeds safe{[this](const FleetVehicle&, double) { return safe_; },
                          [this](const FleetVehicle&, double, double) { return safe_; }};
    const auto orders =
        yielding_.plan(std::span(&vehicle_, 1), PeopleNear(people), outside_, safe, time_, kStep);
    time_ += kStep;
    return orders;
  }

  FleetVehicle vehicle_;
  std::vector<PersonAhead> outside_;  ///< whom SUMO walks
  double safe_ = 0.9;                 ///< [m/s]
  double time_ = 0.0;                 ///< [s]
  std::vector<Zone> zones_{1};
  Yielding yielding_{zones_};
};

TEST_F(YieldingTest, tells_the_safe_speed_while_somebody_is_in_the_way) {
  EXPECT_THAT(plan(kNear), ElementsAre(SpeedOrder{"shuttle", 0.9}));
  EXPECT_EQ(vehicle_.commanded, 0.9);
  safe_ = 0.8;
  EXPECT_THAT(plan(kNear), ElementsAre(SpeedOrder{"shuttle", 0.8}));
}

TEST_F(YieldingTest, gives_a_vehicle_back_once_when_its_way_is_free) {
  EXPECT_THAT(plan({}), IsEmpty()) << "it was never told a speed";
  plan(kNear);
  while (vehicle_.commanded >= 0.0 && time_ < 10.0) plan({});
  EXPECT_EQ(vehicle_.commanded, kOwnSpeed);
  EXPECT_THAT(plan({}), IsEmpty());
}

TEST_F(YieldingTest, tells_the_next_vehicle_of_that_id_nothing) {
  plan(kNear);
  yielding_.stop("shuttle");
  yielding_.forget("shuttle");
  vehicle_.commanded = kOwnSpeed;
  EXPECT_THAT(plan({}), IsEmpty());
}

TEST_F(YieldingTest, lets_a_vehicle_go_without_a_jump) {
  safe_ = 0.0;
  vehicle_.speed = 8.0;
  plan({{{12.0, 0.0}, {0.0, 0.0}, 0.24}});
  double before = (vehicle_.commanded - vehicle_.speed) / kStep;
  EXPECT_NEAR(before, -vehicle_.traits.decel, 1e-9);
  while (time_ < 10.0) {
    vehicle_.speed = vehicle_.commanded;
    const auto orders = plan({});
    if (orders == std::vector{SpeedOrder{"shuttle", kOwnSpeed}}) break;
    const double now = (vehicle_.commanded - vehicle_.speed) / kStep;
    EXPECT_GT(now, before);
    EXPECT_LE(now, before + 0.6) << "m/s² more in a step";
    before = now;
  }
  EXPECT_GT(before, vehicle_.traits.accel - 0.6) << "from here on SUMO drives as it did";
  EXPECT_LT(time_, 2.0);
}

TEST_F(YieldingTest, lets_a_vehicle_brake_harder_only_for_as_long_as_it_must) {
  vehicle_.speed = 8.0;
  const double hard = 8.0 - 9.0 * kStep;  // the traits' emergency deceleration
  EXPECT_THAT(plan(kTooNear), ElementsAre(SpeedOrder{"shuttle", SpeedMode::kEmergency},
                                          SpeedOrder{"shuttle", hard}));
  EXPECT_THAT(plan(kTooNear), ElementsAre(SpeedOrder{"shuttle", hard})) << "SUMO knows the mode";
  vehicle_.speed = 1.0;
  EXPECT_THAT(plan(kNear), testing::Contains(SpeedOrder{"shuttle", SpeedMode::kOwn}));
}

TEST_F(YieldingTest, tells_who_braked_hard_once_with_time_and_place) {
  vehicle_.speed = 8.0;
  plan({});
  plan(kTooNear);
  plan(kTooNear);
  ASSERT_EQ(yielding_.late_brakings().size(), 1U);
  const LateBraking& braking = yielding_.late_brakings()[0];
  EXPECT_EQ(braking.vehicle, "shuttle");
  EXPECT_NEAR(braking.time, kStep, 1e-9);
  EXPECT_EQ(braking.deceleration, 9.0);
  time_ += 5.0;
  plan(kTooNear);
  EXPECT_EQ(yielding_.late_brakings().size(), 2U);
}

TEST_F(YieldingTest, gives_a_vehicle_that_brakes_hard_back_as_it_was) {
  vehicle_.speed = 8.0;
  plan(kTooNear);
  vehicle_.stopped = true;
  EXPECT_THAT(plan({}), ElementsAre(SpeedOrder{"shuttle", kOwnSpeed},
                                    SpeedOrder{"shuttle", SpeedMode::kOwn}));
}

TEST_F(YieldingTest, leaves_vehicles_alone_that_do_not_yield_or_are_others) {
  vehicle_.traits.yields = false;
  EXPECT_THAT(plan(kNear), IsEmpty());
  vehicle_.traits.yields = true;
  vehicle_.traits.external = true;
  vehicle_.commanded = 0.4;
  EXPECT_THAT(plan(kNear), IsEmpty());
  EXPECT_EQ(vehicle_.commanded, 0.4) << "pedzone never touches it";
  EXPECT_THAT(yielding_.yielded(), IsEmpty());
}

TEST_F(YieldingTest, gives_a_vehicle_back_that_stops_at_a_stop_of_its_own) {
  plan(kNear);
  vehicle_.stopped = true;
  EXPECT_THAT(plan({}), ElementsAre(SpeedOrder{"shuttle", kOwnSpeed}));
}

TEST_F(YieldingTest, lets_none_drive_off_from_a_stop_onto_people) {
  vehicle_.stopped = true;
  vehicle_.speed = 0.0;
  vehicle_.claim = 10.0;
  const PersonAhead at_bumper{{0.5, 0.0}, {0.0, 0.0}}, farther{{20.0, 0.0}, {0.0, 0.0}};
  EXPECT_THAT(plan({at_bumper}), ElementsAre(SpeedOrder{"shuttle", 0.0}));
  EXPECT_EQ(vehicle_.claim, 0.0) << "it asks nobody for room";
  EXPECT_THAT(plan({farther}), ElementsAre(SpeedOrder{"shuttle", kOwnSpeed}));
  vehicle_.traits.yields = false;
  EXPECT_THAT(plan({at_bumper}), IsEmpty());
}

TEST_F(YieldingTest, stops_one_that_has_run_into_somebody_whether_it_yields_or_not) {
  for (const bool yields : {true, false}) {
    vehicle_.traits.yields = yields;
    vehicle_.speed = 2.0;
    yielding_.stop("shuttle");
    EXPECT_THAT(plan({}), ElementsAre(SpeedOrder{"shuttle", SpeedMode::kEmergency},
                                      SpeedOrder{"shuttle", 2.0 - 9.0 * 0.1}));
    vehicle_.speed = 0.0;
    // It stands for 5 s, even where nobody is in its way any more.
    for (int k = 0; k < 50; ++k) {
      ASSERT_THAT(plan({}), ElementsAre(SpeedOrder{"shuttle", 0.0})) << k;
    }
    EXPECT_THAT(plan({}), ElementsAre(SpeedOrder{"shuttle", kOwnSpeed},
                                      SpeedOrder{"shuttle", SpeedMode::kOwn}));
    EXPECT_THAT(plan({}), IsEmpty());
    EXPECT_THAT(yielding_.yielded(), IsEmpty()) << "that is not giving way";
  }
}

TEST_F(YieldingTest, lets_it_stand_for_as_long_as_bodies_overlap) {
  vehicle_.speed = 0.0;
  for (int k = 0; k < 200; ++k) {
    yielding_.stop("shuttle");
    ASSERT_EQ(plan({}).back(), (SpeedOrder{"shuttle", 0.0}));
  }
}

/// A queue that drives at 10 m/s so close that nobody runs into the one ahead as long as all brake
/// as they like to.
class QueueTest : public testing::Test {
 protected:
  static constexpr double kSecond = 1.0;                              // [s] steps
  static constexpr std::array<double, 3> kFronts{0.0, -10.0, -18.0};  // [m]

  QueueTest() {
    for (std::size_t i = 0; i < kFronts.size(); ++i) {
      FleetVehicle& vehicle = queue_.emplace_back();
      vehicle.id = "v" + std::to_string(i);
      vehicle.speed = vehicle.allowed_speed = 10.0;
      vehicle.front.x() = kFronts[i];
      if (i > 0) vehicle.leader = {i - 1, 0.0};
    }
    aim();
  }

  void aim() {
    for (FleetVehicle& vehicle : queue_) {
      const double x = vehicle.front.x();
      vehicle.way = {{x - 5.0, 0.0}, {x, 0.0}, {x + 60.0, 0.0}};
      if (vehicle.leader) {
        const FleetVehicle& leader = queue_[vehicle.leader->index];
        vehicle.leader->gap = leader.front.x() - leader.traits.length - x;
      }
    }
  }

  /// As SUMO drives on at its clients' word: who is told nothing brakes as it likes to.
  void step(const std::vector<PersonAhead>& people) {
    const SafeSpeeds safe{[](const FleetVehicle&, double) { return 0.0; },
                          [](const FleetVehicle&, double, double) { return 0.0; }};
    yielding_.plan(queue_, PeopleNear(people), {}, safe, time_, kSecond);
    time_ += kSecond;
    for (FleetVehicle& vehicle : queue_) {
      const double likes = std::max(0.0, vehicle.speed - vehicle.traits.decel * kSecond);
      vehicle.speed = vehicle.commanded >= 0.0 ? vehicle.commanded : likes;
      vehicle.front.x() += vehicle.speed * kSecond;
    }
    aim();
  }

  std::vector<FleetVehicle> queue_;
  double time_ = 0.0;  ///< [s]
  std::vector<Zone> zones_{1};
  Yielding yielding_{zones_};
};

TEST_F(QueueTest, keeps_its_gaps_behind_one_that_brakes_hard) {
  const std::vector<PersonAhead> stepped_in{{{3.5, 0.0}, {0.0, 0.0}, 0.24}};
  for (int k = 0; k < 3; ++k) {
    step(stepped_in);
    for (std::size_t i = 1; i < queue_.size(); ++i) {
      EXPECT_GE(queue_[i].leader->gap, queue_[i].traits.min_gap) << i << " at " << time_;
    }
  }
  for (const FleetVehicle& vehicle : queue_) EXPECT_EQ(vehicle.speed, 0.0) << vehicle.id;
  EXPECT_EQ(yielding_.late_brakings().size(), 3u) << "all of them, and said";
}

TEST_F(QueueTest, is_left_alone_where_the_first_brakes_as_it_likes_to) {
  const std::vector<PersonAhead> far{{{14.0, 0.0}, {0.0, 0.0}, 0.24}};
  for (int k = 0; k < 6; ++k) step(far);
  EXPECT_EQ(queue_[0].speed, 0.0);
  EXPECT_THAT(yielding_.late_brakings(), IsEmpty());
  EXPECT_LT(queue_[1].commanded, 0.0);
}

TEST_F(QueueTest, does_not_speed_up_behind_one_that_brakes_hard) {
  queue_.resize(2);
  queue_[1].speed = 0.0;
  const SafeSpeeds safe{[](const FleetVehicle& v, double) { return v.speed > 0.0 ? 0.0 : 9.0; },
                        [](const FleetVehicle&, double, double speed) { return 0.1 * speed; }};
  const std::vector<PersonAhead> stepped_in{{{3.5, 0.0}, {0.0, 0.0}, 0.24}};
  yielding_.plan(queue_, PeopleNear(stepped_in), {}, safe, 0.0, kSecond);
  ASSERT_EQ(yielding_.late_brakings().size(), 1U);
  EXPECT_NEAR(queue_[1].commanded, 0.1 * queue_[0].commanded, 1e-9) << "safe behind what is left";
}

TEST_F(YieldingTest, does_not_touch_one_that_others_drive_whomever_it_runs_into) {
  vehicle_.traits.external = true;
  yielding_.stop("shuttle");
  EXPECT_THAT(plan({}), IsEmpty());
}

TEST_F(YieldingTest, leaves_room_at_the_end_of_a_lane_that_it_fills_while_somebody_comes_in) {
  vehicle_.tight_end = 10.0;
  outside_ = {{{12.0, 2.0}, {0.0, 0.0}, 0.24}};
  EXPECT_THAT(plan({}), ElementsAre(SpeedOrder{"shuttle", 0.9}));
  outside_.clear();  // for a moment: SUMO puts people from place to place where lanes meet
  for (int k = 0; k < 9; ++k) EXPECT_FALSE(plan({}).empty()) << k;
  for (int k = 0; k < 30 && vehicle_.commanded >= 0.0; ++k) plan({});
  EXPECT_EQ(vehicle_.commanded, kOwnSpeed) << "nobody comes any more";
}

TEST_F(YieldingTest, leaves_room_at_the_end_of_a_lane_that_it_fills_for_who_leaves_there) {
  vehicle_.tight_end = 10.0;
  vehicle_.lane = 7;
  std::vector<PersonAhead> people{{{8.0, 3.0}, {0.0, 0.0}, 0.24}};  // not in its way
  EXPECT_THAT(plan(people), IsEmpty());
  people[0].exit_lane = vehicle_.lane;
  EXPECT_THAT(plan(people), ElementsAre(SpeedOrder{"shuttle", 0.9}));
}

TEST_F(YieldingTest, does_not_leave_room_for_ever) {
  vehicle_.tight_end = 10.0;
  vehicle_.speed = safe_ = 0.0;
  outside_ = {{{12.0, 0.0}, {0.0, 0.0}, 0.24}};
  for (int k = 0; k < 300; ++k) ASSERT_FALSE(plan({}).empty()) << k;
  for (int k = 0; k < 30 && vehicle_.commanded >= 0.0; ++k) plan({});
  EXPECT_EQ(vehicle_.commanded, kOwnSpeed);
}

TEST_F(YieldingTest, does_not_brake_hard_to_leave_room) {
  outside_ = {{{12.0, 0.0}, {0.0, 0.0}, 0.24}};
  for (const double late : {8.05, 1.0}) {
    vehicle_.tight_end = late;
    EXPECT_THAT(plan({}), IsEmpty()) << late << " m before its end";
  }
  vehicle_.tight_end = 10.0;
  vehicle_.traits.external = true;
  EXPECT_THAT(plan({}), IsEmpty()) << "it is another program's";
}

TEST_F(YieldingTest, knows_who_ever_gave_way) {
  plan(kNear);
  while (vehicle_.commanded >= 0.0 && time_ < 10.0) plan({});
  EXPECT_THAT(yielding_.yielded(), ElementsAre("shuttle"));
}

}  // namespace
}  // namespace pedzone
