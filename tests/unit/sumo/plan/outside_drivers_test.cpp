#include "sumo/plan/outside_drivers.hpp"

#include <gtest/gtest.h>

namespace pedzone {
namespace {

constexpr double kStep = 0.1;  // [s]

class OutsideDriversTest : public testing::Test {
 protected:
  /// One step in which it drives at `speed` [m/s] and would at `own` [m/s]. Whether it is external.
  bool step(double speed, double own, bool stopped = false) {
    VehicleSeen vehicle;
    vehicle.id = "car";
    vehicle.speed = speed;
    vehicle.own_speed = own;
    vehicle.stopped = stopped;
    std::vector<VehicleSeen> seen{vehicle};
    time_ += kStep;
    drivers_.mark(seen, steered_, time_, kStep);
    return seen.front().traits.external;
  }
  void tell(double speed) { told_.note(std::vector<SpeedOrder>{{"car", speed}}); }

  Told told_;
  OutsideDrivers drivers_{told_};
  std::unordered_set<std::string> steered_;
  double time_ = 0.0;
};

TEST_F(OutsideDriversTest, who_drives_as_sumo_lets_it_is_sumos) {
  for (const double speed : {0.0, 2.0, 5.0, 5.0, 0.0}) EXPECT_FALSE(step(speed, speed));
  EXPECT_TRUE(drivers_.found().empty());
}

TEST_F(OutsideDriversTest, who_drives_otherwise_for_two_steps_is_driven_by_another_program) {
  EXPECT_FALSE(step(3.0, 5.0));
  EXPECT_TRUE(step(3.0, 5.0));
  EXPECT_TRUE(step(3.0, 5.0));
  ASSERT_EQ(drivers_.found().size(), 1u);
  EXPECT_EQ(drivers_.found().front().id, "car");
  EXPECT_DOUBLE_EQ(drivers_.found().front().time, 2 * kStep);
}

TEST_F(OutsideDriversTest, who_brakes_is_sumos_though_its_own_speed_is_lower_yet) {
  step(5.0, 5.0);
  for (double speed = 4.55; speed > 0.5; speed -= 4.5 * kStep) {
    EXPECT_FALSE(step(speed, speed - 0.4)) << speed;
  }
}

TEST_F(OutsideDriversTest, the_next_vehicle_of_its_id_is_sumos) {
  step(3.0, 5.0);
  EXPECT_TRUE(step(3.0, 5.0));
  drivers_.forget("car");
  EXPECT_FALSE(step(13.0, 13.0));
  EXPECT_FALSE(step(3.0, 5.0));
  EXPECT_TRUE(step(3.0, 5.0));
  EXPECT_EQ(drivers_.found().size(), 2u) << "is told of, too";
}

TEST_F(OutsideDriversTest, one_odd_step_is_an_insertion_or_a_stop) {
  EXPECT_FALSE(step(3.0, 5.0));
  EXPECT_FALSE(step(5.0, 5.0));
  EXPECT_FALSE(step(3.0, 5.0));
}

TEST_F(OutsideDriversTest, what_pedzone_has_told_it_is_no_other_program) {
  (void)step(5.0, 5.0);
  tell(4.0);
  for (int k = 0; k < 5; ++k) EXPECT_FALSE(step(4.0, 5.0));
  tell(-1.0);
  EXPECT_FALSE(step(5.0, 5.0));
}

TEST_F(OutsideDriversTest, who_drives_faster_than_told_is_driven_by_another_program) {
  (void)step(5.0, 5.0);
  tell(1.0);
  EXPECT_FALSE(step(4.1, 5.0)) << "it cannot brake harder";
  EXPECT_FALSE(step(5.0, 5.0));
  EXPECT_TRUE(step(5.0, 5.0));
}

TEST_F(OutsideDriversTest, one_told_to_stand_brakes_as_sumo_lets_it_and_is_no_other_programs) {
  (void)step(1.0, 5.0);
  tell(0.0);
  for (const double speed : {0.55, 0.1, 0.0, 0.0}) EXPECT_FALSE(step(speed, 5.0)) << speed;
}

TEST_F(OutsideDriversTest, it_is_sumos_again_after_two_seconds_as_sumo_lets_it) {
  (void)step(3.0, 5.0);
  EXPECT_TRUE(step(3.0, 5.0));
  for (int k = 0; k < 18; ++k) EXPECT_TRUE(step(5.0, 5.0)) << k;
  for (int k = 0; k < 50; ++k) EXPECT_EQ(step(0.0, 0.0), true) << "who stands says nothing";
  (void)step(5.0, 5.0);
  (void)step(5.0, 5.0);
  EXPECT_FALSE(step(5.0, 5.0));
}

TEST_F(OutsideDriversTest, it_is_sumos_again_though_it_drives_faster_than_pedzone_told_it_before) {
  (void)step(5.0, 5.0);
  tell(0.0);
  for (int k = 0; k < 20; ++k) (void)step(5.0, 6.0);
  EXPECT_TRUE(step(5.0, 6.0));
  for (int k = 0; k < 18; ++k) EXPECT_TRUE(step(6.0, 6.0)) << k;
  (void)step(6.0, 6.0);
  (void)step(6.0, 6.0);
  EXPECT_FALSE(step(6.0, 6.0)) << "what it was told counts no more";
}

TEST_F(OutsideDriversTest, it_is_sumos_again_too_where_it_drives_as_pedzone_told_it_before) {
  (void)step(5.0, 5.0);
  tell(1.0);
  for (int k = 0; k < 20; ++k) (void)step(5.0, 6.0);
  EXPECT_TRUE(step(5.0, 6.0));
  for (int k = 0; k < 25; ++k) (void)step(1.0, 6.0);
  EXPECT_FALSE(step(1.0, 6.0)) << "it would crawl for ever";
}

TEST_F(OutsideDriversTest, knows_whom_pedzone_has_told_a_speed) {
  EXPECT_FALSE(told_.speed("car"));
  tell(0.0);
  EXPECT_TRUE(told_.speed("car"));
  told_.note(std::vector<SpeedOrder>{{"car", SpeedMode::kOwn}});
  EXPECT_TRUE(told_.speed("car"));
  tell(-1.0);
  EXPECT_FALSE(told_.speed("car"));
}

TEST_F(OutsideDriversTest, neither_who_is_at_a_stop_nor_whom_pedzone_steers_itself) {
  for (int k = 0; k < 5; ++k) EXPECT_FALSE(step(0.0, 5.0, true));
  steered_.insert("car");
  for (int k = 0; k < 5; ++k) EXPECT_FALSE(step(3.0, 5.0));
}

}  // namespace
}  // namespace pedzone
