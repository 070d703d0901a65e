// What Crowd::aware_of tells: sight 10 m in a half field of 90°, hearing 8 m; a van of 5 by 1.8 m.
#include <gtest/gtest.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

bool aware(const Vec2& vehicle, double speed) {
  const Zone zone = zone_of(box(0, 0, 100, 40), {}, true);
  Crowd crowd(zone, 1);
  NewPerson person;
  person.position = {50, 20};
  person.heading = 0.0;  // faces east
  person.destination = {{90, 20}, {90, 20}};
  const Crowd::Handle handle = crowd.add(person);
  return crowd.aware_of(handle, vehicle_at(vehicle, 0.0, speed));
}

TEST(Aware, of_what_is_in_sight_ahead) {
  EXPECT_TRUE(aware({77, 20}, 2.0));   // its rear 24.5 m ahead
  EXPECT_FALSE(aware({78, 20}, 2.0));  // 25.5 m
}

TEST(Aware, of_what_is_heard_behind) {
  EXPECT_TRUE(aware({40, 20}, 2.0));   // its front 7.5 m behind
  EXPECT_FALSE(aware({39, 20}, 2.0));  // 8.5 m
}

TEST(Aware, of_a_parked_one_behind_as_of_a_wall) {
  EXPECT_TRUE(aware({39, 20}, 0.0));
  EXPECT_FALSE(aware({37, 20}, 0.0));  // 10.5 m
}

}  // namespace
}  // namespace pedzone::test
