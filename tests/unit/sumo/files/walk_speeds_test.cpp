#include "sumo/files/walk_speeds.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace pedzone {
namespace {

WalkSpeeds speeds_of(const std::string& routes) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();  // run side by side
  const std::string file = testing::TempDir() + "walk_speeds_" + test->name() + ".rou.xml";
  std::ofstream(file) << "<routes>" << routes << "</routes>";
  WalkSpeeds speeds;
  speeds.read(file);
  std::remove(file.c_str());
  return speeds;
}

TEST(WalkSpeedsTest, are_those_of_the_stage_by_what_is_left) {
  const WalkSpeeds speeds = speeds_of(R"(
    <person id="p" depart="0"><param key="walk" value="walk"/><walk edges="a" speed="0.7"/>
      <stop lane="a_0" duration="10"/><walk edges="b"/><walk edges="c" duration="50"/></person>
    <vehicle id="v" depart="0"><route edges="a"/><stop lane="a_0" duration="5"/></vehicle>)");
  EXPECT_EQ(speeds.of("p", 4, 100.0), 0.7);
  EXPECT_EQ(speeds.of("p", 3, 100.0), std::nullopt) << "a stop";
  EXPECT_EQ(speeds.of("p", 2, 100.0), std::nullopt) << "says nothing";
  EXPECT_EQ(speeds.of("p", 1, 100.0), 2.0);
  EXPECT_EQ(speeds.of("p", 5, 100.0), std::nullopt) << "SUMO has added a stage";
  EXPECT_EQ(speeds.of("p", 0, 100.0), std::nullopt);
  EXPECT_EQ(speeds.of("q", 1, 100.0), std::nullopt);
}

TEST(WalkSpeedsTest, are_those_of_a_flow_for_all_its_persons) {
  const WalkSpeeds speeds = speeds_of(R"(
    <personFlow id="f.0" begin="0" number="9"><walk edges="a" duration="00:01:40"/></personFlow>)");
  EXPECT_EQ(speeds.of("f.0.8", 1, 50.0), 0.5);
  EXPECT_EQ(speeds.of("f.1", 1, 50.0), std::nullopt);
}

TEST(WalkSpeedsTest, are_nobody_elses_whose_id_begins_alike) {
  const WalkSpeeds speeds = speeds_of(R"(
    <person id="ann" depart="0"><walk edges="a" speed="0.3"/></person>
    <personFlow id="f" begin="0" number="9"><walk edges="a" speed="0.4"/></personFlow>)");
  EXPECT_EQ(speeds.of("ann", 1, 50.0), 0.3);
  EXPECT_EQ(speeds.of("ann.1", 1, 50.0), std::nullopt);
  EXPECT_EQ(speeds.of("f.1", 1, 50.0), 0.4);
  for (const std::string id : {"f", "f.", "f.friend", "f.1b"}) {
    EXPECT_EQ(speeds.of(id, 1, 50.0), std::nullopt) << id;
  }
}

TEST(WalkSpeedsTest, are_left_out_where_SUMO_plans) {
  const WalkSpeeds speeds = speeds_of(R"(
    <person id="p" depart="0"><walk edges="a" speed="0.7"/><personTrip to="b"/></person>)");
  EXPECT_EQ(speeds.of("p", 2, 100.0), std::nullopt);
}

}  // namespace
}  // namespace pedzone
