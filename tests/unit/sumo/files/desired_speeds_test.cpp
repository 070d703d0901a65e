#include "sumo/files/desired_speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace pedzone {
namespace {

/// What SUMO 1.15 told in process for these types, over the speed factor of a person that had it.
TEST(DesiredSpeedsTest, are_what_sumo_takes) {
  const std::string file = testing::TempDir() + "desired_speeds.rou.xml";
  std::ofstream(file) << R"(<routes>
    <vType id="plain" vClass="pedestrian"/>
    <vType id="slow" vClass="pedestrian" maxSpeed="1.0"/>
    <vType id="wished" vClass="pedestrian" desiredMaxSpeed="1.2" maxSpeed="3"/>
    <vType id="bicycle" vClass="bicycle" maxSpeed="3"/>
    <vType id="car"/>
    <vTypeDistribution id="mixed"><vType id="old" vClass="pedestrian" maxSpeed="0.8"/>
    </vTypeDistribution></routes>)";
  DesiredSpeeds speeds;
  speeds.read(file);
  std::remove(file.c_str());
  EXPECT_DOUBLE_EQ(speeds.of_type("plain"), 5.0 / 3.6);
  EXPECT_DOUBLE_EQ(speeds.of_type("slow"), 1.0);
  EXPECT_DOUBLE_EQ(speeds.of_type("slow@person7"), 1.0);
  EXPECT_DOUBLE_EQ(speeds.of_type("wished"), 1.2);
  EXPECT_DOUBLE_EQ(speeds.of_type("bicycle"), 20.0 / 3.6);
  EXPECT_DOUBLE_EQ(speeds.of_type("old"), 0.8);
  EXPECT_TRUE(std::isinf(speeds.of_type("car")));
  EXPECT_DOUBLE_EQ(speeds.of_type("DEFAULT_PEDTYPE"), 5.0 / 3.6);
  EXPECT_DOUBLE_EQ(speeds.of_type("DEFAULT_PEDTYPE@person7"), 5.0 / 3.6);
}

}  // namespace
}  // namespace pedzone
