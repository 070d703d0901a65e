#include "sumo/files/frames.hpp"

#include <gmock/gmock.h>

namespace pedzone {
namespace {

TEST(Frames, north_and_east) {
  EXPECT_NEAR(radians_from_sumo(0.0), 0.5 * kPi, 1e-12);
  EXPECT_NEAR(radians_from_sumo(90.0), 0.0, 1e-12);
  for (double degrees = 0.0; degrees < 360.0; degrees += 7.0) {
    EXPECT_NEAR(sumo_from_radians(radians_from_sumo(degrees)), degrees, 1e-9);
  }
}

}  // namespace
}  // namespace pedzone
