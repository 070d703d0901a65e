// When and where vehicles begin, as route files say.
#include "sumo/files/departures.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace pedzone {
namespace {

class DeparturesTest : public testing::Test {
 protected:
  DeparturesTest() {
    for (const std::string id : {"a", "b"}) {
      Edge edge;
      edge.id = id;
      for (int i = 0; i < 2; ++i) {  // a footway and a lane
        Lane lane;
        lane.id = id + "_" + std::to_string(i);
        lane.edge = static_cast<int>(network_.edges.size());
        lane.vehicles = i == 1;
        edge.lanes.push_back(static_cast<int>(network_.lanes.size()));
        network_.lane_index[lane.id] = edge.lanes.back();
        network_.lanes.push_back(lane);
      }
      network_.edge_index[id] = static_cast<int>(network_.edges.size());
      network_.edges.push_back(edge);
    }
  }
  ~DeparturesTest() override { std::filesystem::remove(file_); }

  std::vector<Departure> read(const std::string& routes) {
    std::ofstream(file_) << "<routes>" << routes << "</routes>";
    Scenario scenario;
    scenario.route_files = {file_};
    return read_departures(scenario, network_, {0}, 5.0, 65.0);
  }

  Network network_;
  std::string file_ = testing::TempDir() + "departures_test." +
                      testing::UnitTest::GetInstance()->current_test_info()->name() + ".rou.xml";
};

TEST_F(DeparturesTest, are_those_of_vehicles_and_trips_that_begin_on_the_edges) {
  const auto found = read(R"(<vType id="van" length="7" width="2"/><route id="r" edges=" a b"/>
    <vehicle id="own" depart="3"><route edges="a b"/></vehicle>
    <vehicle id="named" type="van" depart="00:01:02.5" route="r" departPos="20" departLane="1"/>
    <trip id="trip" depart="7" from="a" to="b"/>
    <trip id="other" depart="8" from="b" to="a"/>
    <vehicle id="elsewhere" depart="9"><route edges="b a"/></vehicle>)");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].vehicle, "own");
  EXPECT_EQ(found[0].time, 3.0);
  EXPECT_EQ(found[0].lane, 1) << "the first for vehicles";
  EXPECT_NEAR(found[0].position, 5.1, 1e-9);
  EXPECT_EQ(found[1].vehicle, "trip");
  EXPECT_EQ(found[2].time, 62.5);
  EXPECT_EQ(found[2].position, 20.0);
  EXPECT_EQ(std::tuple(found[2].length, found[2].width, found[2].lane), std::tuple(7.0, 2.0, 1));
}

TEST_F(DeparturesTest, are_as_long_and_wide_as_their_class_where_a_type_leaves_it_open) {
  const auto found = read(R"(<vType id="DEFAULT_VEHTYPE" length="4"/>
    <vType id="truck" vClass="truck"/><vType id="bus" vClass="bus" length="18"/>
    <vTypeDistribution id="any"><vType id="van" vClass="delivery"/></vTypeDistribution>
    <trip id="usual" depart="1" from="a" to="b"/>
    <trip id="truck" type="truck" depart="2" from="a" to="b"/>
    <trip id="bus" type="bus" depart="3" from="a" to="b"/>
    <trip id="any" type="any" depart="4" from="a" to="b"/>)");
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(std::pair(found[0].length, found[0].width), std::pair(4.0, 1.8));
  EXPECT_EQ(std::pair(found[1].length, found[1].width), std::pair(7.1, 2.4));
  EXPECT_NEAR(found[1].position, 7.2, 1e-9);
  EXPECT_EQ(std::pair(found[2].length, found[2].width), std::pair(18.0, 2.5));
  EXPECT_EQ(std::pair(found[3].length, found[3].width), std::pair(6.5, 2.16));
}

TEST_F(DeparturesTest, are_as_large_as_the_largest_of_a_distribution) {
  const auto found =
      read(R"(<vType id="small" vClass="motorcycle"/><vType id="large" vClass="truck"/>
    <vTypeDistribution id="mix" vTypes="small large"/>
    <trip id="one" type="mix" depart="7" from="a" to="b"/>)");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].length, 7.1);
  EXPECT_DOUBLE_EQ(found[0].width, 2.4);
  EXPECT_NEAR(found[0].position, 7.2, 1e-9);
  EXPECT_EQ(found[0].its_class, RoadClasses{0}) << "of whatever class";
  EXPECT_EQ(found[0].lane, -1) << "on whatever lane";
}

TEST_F(DeparturesTest, are_those_of_a_flow_one_by_one) {
  for (const std::string rate : {R"(period="20")", R"(vehsPerHour="180")", R"(number="3")"}) {
    const auto found = read(R"(<flow id="f" begin="10" end="70" from="a" to="b" )" + rate + "/>");
    ASSERT_EQ(found.size(), 3U) << rate;
    EXPECT_EQ(found[2].vehicle, "f.2");
    EXPECT_NEAR(found[2].time, 50.0, 1e-9);
  }
}

TEST_F(DeparturesTest, are_those_of_a_flow_that_leaves_its_begin_or_end_to_the_simulation) {
  const auto hourly = read(R"(<flow id="f" end="70" perHour="180" from="a" to="b"/>)");
  ASSERT_EQ(hourly.size(), 4U);
  EXPECT_NEAR(hourly[0].time, 5.0, 1e-9);
  EXPECT_NEAR(hourly[3].time, 65.0, 1e-9);
  const auto spread = read(R"(<flow id="f" begin="25" number="4" from="a" to="b"/>)");
  ASSERT_EQ(spread.size(), 4U);
  EXPECT_NEAR(spread[1].time, 35.0, 1e-9);
}

TEST_F(DeparturesTest, are_on_the_edge_of_their_route_that_they_say) {
  const auto found = read(R"(
    <vehicle id="second" depart="9" departEdge="1"><route edges="b a"/></vehicle>
    <vehicle id="not here" depart="9" departEdge="1"><route edges="a b"/></vehicle>
    <vehicle id="sumo's" depart="9" departEdge="random"><route edges="a a"/></vehicle>)");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].vehicle, "second");
  EXPECT_EQ(found[0].edge, 0);
}

TEST_F(DeparturesTest, are_once_on_each_edge_where_a_route_of_their_distribution_begins) {
  const auto found = read(R"(<route id="r" edges="a b"/><route id="s" edges="b"/>
    <routeDistribution id="named" routes="r s" probabilities="1 2"/>
    <routeDistribution id="own"><route id="t" edges="a"/><route edges="a b"/></routeDistribution>
    <vehicle id="1" depart="7" route="named"/><vehicle id="2" depart="8" route="own"/>
    <vehicle id="3" depart="9" route="t"/><vehicle id="4" depart="9" route="s"/>)");
  ASSERT_EQ(found.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(found[k].vehicle, std::to_string(k + 1));
    EXPECT_EQ(found[k].edge, 0);
  }
}

TEST_F(DeparturesTest, are_as_far_from_the_end_and_beside_the_middle_as_they_say) {
  for (const int lane : network_.edges[0].lanes) network_.lanes[lane].length = 100.0;
  const auto found = read(R"(<trip id="0" depart="6" from="a" to="b" departPos="-30"/>
    <trip id="1" depart="7" from="a" to="b" departPos="-300" departPosLat="0.4"/>
    <trip id="2" depart="8" from="a" to="b" departPosLat="right"/>
    <trip id="3" depart="9" from="a" to="b" departPosLat="free"/>)");
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0].position, 70.0);
  EXPECT_EQ(found[0].lateral, 0.0);
  EXPECT_EQ(found[1].position, 0.0);
  EXPECT_EQ(found[1].lateral, 0.4);
  EXPECT_LT(found[2].lateral, -10.0);
  EXPECT_EQ(found[3].lateral, std::nullopt) << "SUMO chooses";
}

TEST_F(DeparturesTest, leave_out_what_only_sumo_knows) {
  EXPECT_TRUE(read(R"(<flow id="f" begin="0" end="9" probability="0.5" from="a" to="b"/>
    <trip id="r" depart="1" from="a" to="b" departPos="random"/>
    <vehicle id="t" depart="triggered"><route edges="a"/></vehicle>)")
                  .empty());
}

TEST_F(DeparturesTest, are_on_the_first_lane_that_lets_their_class_in) {
  Lane& footway = network_.lanes[0];
  footway.vehicles = true;
  footway.road_classes = road_class("bicycle");
  const auto found = read(R"(<trip id="car" depart="1" from="a" to="b"/>
    <vType id="bike" vClass="bicycle"/><trip id="bike" type="bike" depart="2" from="a" to="b"/>)");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].lane, 1);
  EXPECT_EQ(found[1].lane, 0);
}

TEST_F(DeparturesTest, leave_the_lane_open_where_sumo_chooses_it) {
  const auto found = read(R"(<trip id="r" depart="1" from="a" to="b" departLane="best"/>)");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].lane, -1);
}

}  // namespace
}  // namespace pedzone
