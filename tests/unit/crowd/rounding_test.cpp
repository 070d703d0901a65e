// Who gets no further before a vehicle that stands goes round it.
#include <gtest/gtest.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

/// A street of 4 m in which a van stands, with 0.95 m beside it.
struct Street {
  explicit Street(double centre = 2.0) {
    VehicleState van = vehicle_at({40, centre}, 0.0, 0.0);
    van.length = 6.5;
    van.width = 2.1;
    scene.vehicles.push_back(van);
  }

  /// So many people come from ahead, one every two seconds. Returns how many get past in `time`
  /// [s].
  std::size_t past(int people, double time) {
    for (int k = 0; k < people; ++k) {
      scene.add({60, 2}, point(20, 2));
      for (int n = 0; n < 4; ++n) scene.step(0.5);
    }
    while (scene.time < time) scene.step(0.5);
    return scene.arrived();
  }

  Zone zone = zone_of(box(0, 0, 80, 4), {}, true);
  Scene scene{zone};
};

TEST(Rounding, leads_a_crowd_past_a_vehicle_that_stands) {
  Street street;
  EXPECT_EQ(street.past(60, 200.0), 60u);
}

TEST(Rounding, takes_the_side_that_has_room) {
  for (const double centre : {1.1, 2.9}) {
    Street street(centre);
    EXPECT_EQ(street.past(10, 90.0), 10u) << centre;
  }
}

/// Three bodies of 8 m in a row across the way, `gap` [m] apart.
std::size_t past_a_row(double gap, bool of_one_vehicle) {
  const Zone zone = zone_of(box(0, -60, 60, 60), {}, true);
  Scene scene(zone);
  for (const int k : {-1, 0, 1}) {
    VehicleState body = vehicle_at({30, k * (8.0 + gap)}, 0.5 * kPi, 0.0, 8.0, 2.4);
    body.key = of_one_vehicle ? 7 : 7 + static_cast<std::uint64_t>(k + 1);
    scene.vehicles.push_back(body);
  }
  for (const double y : {-4.3, -2.0, 0.5, 4.2, 9.0}) scene.add({20, y}, point(40, y));
  while (scene.time < 90.0) scene.step(0.5);
  return scene.arrived();
}

TEST(Rounding, leads_round_all_parts_of_a_vehicle) { EXPECT_EQ(past_a_row(0.0, true), 5u); }

TEST(Rounding, leads_nobody_between_vehicles_that_leave_no_room) {
  EXPECT_EQ(past_a_row(0.1, false), 5u);
}

TEST(Rounding, leads_nobody_where_there_is_no_room) {
  Zone zone = zone_of(box(0, 0, 80, 2.3), {}, true);
  Scene scene(zone);
  VehicleState van = vehicle_at({40, 1.15}, 0.0, 0.0);
  van.width = 2.1;
  scene.vehicles.push_back(van);
  scene.add({60, 1}, point(20, 1));
  while (scene.time < 60.0) scene.step(0.5);
  EXPECT_EQ(scene.arrived(), 0u);
  EXPECT_GE(scene.least_wall_gap(), -1e-6);
}

}  // namespace
}  // namespace pedzone::test
