// Recordings as they are read: what somebody present sees of a vehicle.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "validation/clip.hpp"

namespace pedzone {
namespace {

/// A folder with one clip: somebody who stands, and a car that gains 1.5 m/s in each second.
std::filesystem::path folder_with_a_clip() {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "clip_reader_test";
  std::filesystem::create_directories(folder);
  std::ofstream file(folder / "front_01.csv");
  file << "t,kind,id,x,y,heading,front,rear,half_width\n";
  for (int k = 0; k <= 60; ++k) {
    const double t = k * kFrame;
    file << t << ",ped,p,0,9,,,,\n";
    file << t << ",veh,v," << 1.0 * t + 0.75 * t * t << ",0,0,2.5,2.5,0.9\n";
  }
  return folder;
}

TEST(ClipReader, tells_the_speed_of_the_last_0_3_s_and_what_it_will_gain) {
  const Clip clip = read_clips(folder_with_a_clip().string()).at(0);
  const VehicleState& last = clip.vehicles.at(0).states.back();
  EXPECT_NEAR(last.velocity.x(), 1.0 + 1.5 * (6.0 - 0.15), 1e-3);
  EXPECT_NEAR(last.gain, 0.5 * 1.5, 0.01);
  EXPECT_EQ(clip.vehicles[0].states.front().gain, 0.0);
}

}  // namespace
}  // namespace pedzone
