// Vehicles as people at a street see them.
#include "crowd/sense/street_traffic.hpp"

#include <gtest/gtest.h>

#include "crowd/sense/vehicle_motion.hpp"

namespace pedzone {
namespace {

/// 100 m along x, 6 m wide.
Street street() {
  Street made;
  made.axis = {{0.0, 0.0}, {100.0, 0.0}};
  made.length = 100.0;
  made.low = -3.0;
  made.high = 3.0;
  made.places.assign(101, CrossingPlace{-3.0, 3.0, true, false});
  return made;
}

TEST(StreetTraffic, comes_nearer_within_a_step_before_it_turns_in) {
  const Polyline way{{20.0, -30.0}, {20.0, -5.0}, {23.0, -2.0}, {80.0, -2.0}};
  VehicleState car;
  car.length = 5.0;
  car.width = 1.8;
  car.way = way;
  car.forwards = true;
  car.heading = 0.5 * kPi;
  car.velocity = {0.0, 8.0};
  car.centre = {20.0, -27.5};
  std::vector<StreetTraffic> traffic;
  double before = 0.0;
  for (int k = 0; k < 10; ++k) {
    observe_streets({street()}, {car}, 0.1, traffic);
    ASSERT_EQ(traffic.at(0).vehicles.size(), 1U);
    const double front = traffic[0].vehicles[0].front;
    if (k > 0) {
      EXPECT_NEAR(front - before, 0.8, 0.01) << k;
    }
    before = front;
    car = moved_on(car, 0.1);
  }
}

}  // namespace
}  // namespace pedzone
