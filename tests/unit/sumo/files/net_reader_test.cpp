// Networks and polygons read from SUMO's files.
#include "sumo/files/net_reader.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class NetReader : public ::testing::Test {
 protected:
  ~NetReader() override { std::remove(path_.c_str()); }

  Network read(const std::string& text) {
    std::ofstream(path_) << text;
    return read_network(path_);
  }

  Network with_lane(const std::string& attributes) {
    return read("<net>\n<edge id=\"e\" from=\"a\" to=\"b\">\n<lane id=\"e_0\" index=\"0\" " +
                attributes + "/></edge></net>");
  }

  std::string error(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "no error";
  }

  const std::string path_ = ::testing::TempDir() + "net_reader_test_" +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name() +
                            ".xml";
};

constexpr const char* kGoodLane = "speed=\"5\" length=\"10\" shape=\"0,0 10,0\" ";

/// A street over a junction with a waiting place inside and a crossing behind it. `response`: of
/// the street's link.
std::string with_crossing(const std::string& response) {
  const auto edge = [](const std::string& id, const std::string& attributes) {
    return "<edge id=\"" + id + "\" " + attributes + "><lane id=\"" + id + "_0\" index=\"0\" " +
           kGoodLane + "/></edge>";
  };
  return "<net>" + edge("in", "from=\"a\" to=\"j\"") + edge("out", "from=\"j\" to=\"b\"") +
         edge(":j_0", "function=\"internal\"") + edge(":j_1", "function=\"internal\"") +
         edge(":j_c0", "function=\"crossing\" crossingEdges=\"out\"") +
         "<junction id=\"j\" type=\"priority\" intLanes=\":j_1_0 :j_c0_0\" shape=\"0,0 1,0 1,1\">"
         "<request index=\"0\" response=\"" +
         response +
         "\"/>"
         "<request index=\"1\" response=\"00\"/></junction>"
         "<connection from=\"in\" to=\"out\" fromLane=\"0\" toLane=\"0\" via=\":j_0_0\"/>"
         "<connection from=\":j_0\" to=\"out\" fromLane=\"0\" toLane=\"0\" via=\":j_1_0\"/>"
         "<connection from=\":j_1\" to=\"out\" fromLane=\"0\" toLane=\"0\"/></net>";
}

TEST_F(NetReader, reads_which_vehicles_give_way_on_a_crossing) {
  for (const auto& [response, yields] : {std::pair("10", true), std::pair("01", false)}) {
    const Network network = read(with_crossing(response));
    for (const char* lane : {":j_0_0", ":j_1_0"}) {
      const std::vector<int>& at = network.lanes[network.lane_index.at(lane)].yields_at;
      EXPECT_EQ(at.size(), yields ? 1u : 0u) << lane;
      for (const int edge : at) EXPECT_EQ(network.edges[edge].id, ":j_c0");
    }
    EXPECT_THAT(network.lanes[network.lane_index.at("in_0")].yields_at, IsEmpty());
  }
}

TEST_F(NetReader, reads_edges_lanes_junctions_and_connections) {
  const Network town = read_network(data_file("town.net.xml"));
  const Edge& edge = town.edges[town.edge_index.at("main1")];
  EXPECT_EQ(edge.type, "highway.residential");
  EXPECT_EQ(edge.from, "west");
  EXPECT_EQ(edge.to, "crossing");
  EXPECT_EQ(edge.function, EdgeFunction::kNormal);
  ASSERT_EQ(edge.lanes.size(), 2u);
  const Lane& sidewalk = town.lanes[edge.lanes[0]];
  EXPECT_EQ(sidewalk.id, "main1_0");
  EXPECT_EQ(sidewalk.width, 2.0);
  EXPECT_EQ(sidewalk.length, 96.5);
  EXPECT_TRUE(sidewalk.persons);
  EXPECT_FALSE(sidewalk.vehicles);
  EXPECT_FALSE(sidewalk.persons_only_by_default);
  const Lane& road = town.lanes[edge.lanes[1]];
  EXPECT_EQ(road.width, 3.2);
  EXPECT_FALSE(road.persons);
  EXPECT_TRUE(road.vehicles);
  EXPECT_EQ(walking_lane(town, town.edge_index.at("main1")), edge.lanes[0]);
  const Edge& crossing = town.edges[town.edge_index.at(":crossing_c0")];
  EXPECT_EQ(crossing.function, EdgeFunction::kCrossing);
  EXPECT_THAT(crossing.crossed, ElementsAre("main2", "-main2"));
  EXPECT_FALSE(crossing.signalled);
  EXPECT_TRUE(town.edges[town.edge_index.at(":lights_c1")].signalled);
  const Lane& area = town.lanes[town.lane_index.at(":crossing_w0_0")];
  EXPECT_TRUE(area.outline);
  EXPECT_EQ(area.shape.size(), 7u);
  EXPECT_EQ(town.lanes[town.lane_index.at("bridge_0")].z, (std::vector<double>{6.0, 6.0}));
  EXPECT_THAT(sidewalk.z, IsEmpty());
  EXPECT_TRUE(town.junction_index.contains("lights"));
  const bool has_via = std::any_of(
      town.connections.begin(), town.connections.end(), [&](const Connection& connection) {
        return connection.from == town.lane_index.at("main1_1") &&
               connection.to == town.lane_index.at("main2_1") && connection.via >= 0;
      });
  EXPECT_TRUE(has_via);
}

TEST_F(NetReader, reads_gzipped_files_as_plain_ones) {
  std::ifstream plain(data_file("town.net.xml"));
  std::stringstream text;
  text << plain.rdbuf();
  const gzFile out = gzopen(path_.c_str(), "wb");
  ASSERT_GT(gzwrite(out, text.str().data(), static_cast<unsigned>(text.str().size())), 0);
  gzclose(out);
  EXPECT_EQ(read_network(path_).lanes.size(), read_network(data_file("town.net.xml")).lanes.size());
}

TEST_F(NetReader, a_gzipped_file_that_breaks_off_is_an_error) {
  const gzFile out = gzopen(path_.c_str(), "wb");
  std::string noise = "<net>";
  for (unsigned i = 0, state = 1; i < 20000; ++i) {
    noise += static_cast<char>('a' + ((state = state * 1103515245u + 12345u) >> 16) % 26);
  }
  gzwrite(out, noise.data(), static_cast<unsigned>(noise.size()));
  gzclose(out);
  std::ifstream in(path_, std::ios::binary);
  std::stringstream bytes;
  bytes << in.rdbuf();
  std::ofstream(path_, std::ios::binary) << bytes.str().substr(0, bytes.str().size() / 2);
  EXPECT_THROW(read_network(path_), InputError);
}

TEST_F(NetReader, permissions_as_sumo_means_them) {
  struct Case {
    const char* attributes;
    bool persons, vehicles, by_default;
  };
  for (const Case& c :
       {Case{"", true, true, true}, Case{"disallow=\"tram rail\"", true, true, true},
        Case{"disallow=\"pedestrian tram\"", false, true, false},
        Case{"disallow=\"all\"", false, false, false}, Case{"allow=\"all\"", true, true, false},
        Case{"allow=\"pedestrian\"", true, false, false},
        Case{"allow=\"pedestrian bicycle\"", true, true, false},
        Case{"allow=\"pedestrian tram\"", true, false, false},
        Case{"allow=\"rail_urban tram ship\"", false, false, false},
        Case{"allow=\"delivery bus\"", false, true, false}}) {
    const Lane lane = with_lane(std::string(kGoodLane) + c.attributes).lanes[0];
    EXPECT_EQ(lane.persons, c.persons) << c.attributes;
    EXPECT_EQ(lane.vehicles, c.vehicles) << c.attributes;
    EXPECT_EQ(lane.persons_only_by_default, c.by_default) << c.attributes;
  }
}

TEST_F(NetReader, which_vehicles_a_lane_lets_in) {
  const auto lets = [&](const char* attributes, const char* name) {
    const Lane lane = with_lane(std::string(kGoodLane) + attributes).lanes[0];
    return lane.lets_in(road_class(name));
  };
  EXPECT_TRUE(lets("", "bicycle"));
  EXPECT_TRUE(lets("allow=\"bus bicycle\"", "bus"));
  EXPECT_FALSE(lets("allow=\"bus bicycle\"", "passenger"));
  EXPECT_FALSE(lets("disallow=\"bus\"", "bus"));
  EXPECT_TRUE(lets("disallow=\"bus\"", "passenger"));
  EXPECT_FALSE(lets("disallow=\"all\"", "passenger"));
  EXPECT_TRUE(lets("allow=\"bus\"", "nobody knows it"));
}

TEST_F(NetReader, the_lane_for_the_other_direction) {
  const auto edge = [](const std::string& id, const std::string& neighbour) {
    return "<edge id=\"" + id + "\" from=\"a\" to=\"b\"><lane id=\"" + id +
           "_0\" index=\"0\" speed=\"9\" length=\"9\" shape=\"0,0 9,0\"><neigh lane=\"" +
           neighbour + "\"/></lane></edge>";
  };
  const Network net =
      read("<net>" + edge("there", "back_0") + edge("back", "nowhere_0") + "</net>");
  EXPECT_EQ(net.lanes[0].opposite, 1);
  EXPECT_EQ(net.lanes[1].opposite, -1);
}

TEST_F(NetReader, heights_that_are_left_out_are_zero) {
  const Lane lane = with_lane("speed=\"5\" length=\"10\" shape=\"0,0 5,0,1.5 10,0,3\"").lanes[0];
  EXPECT_EQ(lane.z, (std::vector<double>{0.0, 1.5, 3.0}));
}

TEST_F(NetReader, malformed_networks_name_file_line_element_and_value) {
  const auto lane = [this](const std::string& attributes) {
    return error("<net>\n<edge id=\"e\">\n<lane id=\"e_0\" " + attributes + "/></edge></net>");
  };
  EXPECT_EQ(lane("speed=\"5\" length=\"10\" shape=\"0,0 1O,0\""),
            path_ +
                ":3: <lane id=\"e_0\"> attribute shape: '1O,0' is not a point; allowed: points "
                "\"x,y\" or \"x,y,z\" in metres, at most 1e8, separated by spaces");
  EXPECT_THAT(lane("speed=\"5\" length=\"10\" shape=\"0,0 1e9,0\""),
              HasSubstr("'1e9,0' is not a point"));
  EXPECT_THAT(lane("speed=\"fast\" length=\"10\" shape=\"0,0 10,0\""),
              HasSubstr(":3: <lane id=\"e_0\"> attribute speed: 'fast' is not a number"));
  EXPECT_THAT(lane("speed=\"5\" length=\"-1\" shape=\"0,0 10,0\""),
              HasSubstr("'-1' is out of range"));
  EXPECT_THAT(lane("speed=\"5\" length=\"10\" shape=\"0,0\""), HasSubstr("'0,0' is no line"));
  EXPECT_THAT(lane("speed=\"5\" length=\"10\""), HasSubstr("attribute shape: is missing"));
  EXPECT_THAT(error("<net>\n<edge id=\"e\"/></net>"),
              HasSubstr(":2: <edge id=\"e\">: has no <lane>"));
  EXPECT_THAT(error("<routes/>"), HasSubstr("'routes' is not the document element expected"));
  EXPECT_THAT(error("<net>\n<edge"), HasSubstr(":2: is not well-formed XML"));
  const std::string good =
      "<net>\n<edge id=\"e\"><lane id=\"e_0\" " + std::string(kGoodLane) + "/></edge>\n";
  EXPECT_THAT(error(good + "<connection from=\"e\" to=\"f\" fromLane=\"0\" toLane=\"0\"/></net>"),
              HasSubstr(":3: <connection> attribute to: 'f' is no edge of the network"));
  EXPECT_THAT(error(good + "<connection from=\"e\" to=\"e\" fromLane=\"1\" toLane=\"0\"/></net>"),
              HasSubstr("attribute fromLane: '1' is no lane of edge 'e'"));
  EXPECT_THAT(error(good + "<edge id=\"e\"><lane id=\"x\" " + kGoodLane + "/></edge></net>"),
              HasSubstr(":3: <edge> attribute id: 'e' is used twice"));
}

TEST_F(NetReader, a_missing_network_is_named) {
  EXPECT_THROW(
      {
        try {
          read_network("/nowhere/town.net.xml");
        } catch (const InputError& problem) {
          EXPECT_STREQ(problem.what(), "/nowhere/town.net.xml: cannot be opened");
          throw;
        }
      },
      InputError);
}

TEST_F(NetReader, tells_where_a_street_ends) {
  const auto edge = [](const std::string& id, const std::string& from, const std::string& to,
                       const std::string& lanes) {
    return "<edge id=\"" + id + "\" from=\"" + from + "\" to=\"" + to + "\">" + lanes + "</edge>";
  };
  const auto lane = [](const std::string& id, const std::string& who) {
    return "<lane id=\"" + id + "\" index=\"0\" " + who + " " + kGoodLane + "/>";
  };
  const auto junction = [](const std::string& id) {
    return "<junction id=\"" + id + "\" type=\"priority\" x=\"0\" y=\"0\" shape=\"0,0 1,0 1,1\"/>";
  };
  const std::string road = "disallow=\"pedestrian\"", foot = "allow=\"pedestrian\"";
  const Network network =
      read("<net>" + edge("out", "a", "b", lane("out_0", road)) +
           edge("back", "b", "a", lane("back_0", road)) + edge("on", "b", "c", lane("on_0", road)) +
           edge("path", "b", "d", lane("path_0", foot)) + junction("a") + junction("b") +
           junction("c") + junction("d") + "</net>");
  EXPECT_TRUE(is_street_end(network, "a")) << "in both directions it is one street";
  EXPECT_FALSE(is_street_end(network, "b")) << "others go on";
  EXPECT_TRUE(is_street_end(network, "c"));
  EXPECT_FALSE(is_street_end(network, "d")) << "no vehicles";
  EXPECT_FALSE(is_street_end(network, "e")) << "no junction";
}

TEST_F(NetReader, reads_polygons_and_says_which_it_cannot_use) {
  Network network;
  std::ofstream(path_) << "<additional>\n"
                          "<poly id=\"a\" type=\"building\" shape=\"0,0 4,0 4,4 0,0\"/>\n"
                          "<poly id=\"b\" geo=\"true\" shape=\"9.7,50.8 9.8,50.8 9.8,50.9\"/>\n"
                          "<busStop id=\"s\" lane=\"e_0\"/>\n"
                          "<poly id=\"a\" shape=\"0,0 1,0 1,1\"/>\n"
                          "<poly id=\"c\" shape=\"\"/>\n"
                          "</additional>";
  read_shapes(path_, network);
  ASSERT_EQ(network.polygons.size(), 2u);
  EXPECT_EQ(network.polygons[0].id, "a");
  EXPECT_EQ(network.polygons[0].type, "building");
  EXPECT_EQ(network.polygons[0].shape.size(), 3u);  // closed without repeating the first point
  EXPECT_THAT(network.polygons[1].shape, IsEmpty());
  EXPECT_THAT(network.warnings,
              ElementsAre(HasSubstr(":3: polygon 'b' has longitudes and latitudes"),
                          HasSubstr(":5: polygon 'a' has the id of another polygon: left out")));
}

// Where pyproj has them: Transformer.from_crs("EPSG:4326", "EPSG:32632", always_xy=True).
TEST_F(NetReader, leads_longitudes_and_latitudes_through_the_projection) {
  const std::string net = path_ + ".net.xml";
  std::ofstream(net) << R"(<net><location netOffset="-552000,-5632000" projParameter="+proj=utm )"
                        R"(+zone=32 +ellps=WGS84 +datum=WGS84 +units=m +no_defs"/></net>)";
  Network network = read_network(net);
  std::ofstream(path_) << R"(<additional>
<poly id="a" geo="true" shape="9.75,50.85 9.76,50.85 9.76,50.86"/>
<poly id="b" geo="true" shape="9.75,50.85 9.76,91 9.76,50.86"/>
<poi id="c" type="pedzone.waypoint" lon="9.75" lat="50.85"/>
</additional>)";
  read_shapes(path_, network);
  std::remove(net.c_str());
  ASSERT_EQ(network.polygons.size(), 1u);
  ASSERT_EQ(network.polygons[0].shape.size(), 3u);
  EXPECT_LT((network.polygons[0].shape[0] - Vec2(796.4009, 1412.5178)).norm(), 1e-3);
  EXPECT_LT((network.polygons[0].shape[2] - Vec2(1488.9046, 2531.7019)).norm(), 1e-3);
  EXPECT_THAT(network.warnings, ElementsAre(HasSubstr(":3: polygon 'b' has longitudes")));
  ASSERT_EQ(network.waypoints.size(), 1u);
  EXPECT_EQ(network.waypoints[0].at, network.polygons[0].shape[0]);
}

// Places on lanes as SUMO 1.15 has them (its own poi.getPosition for the same file).
TEST_F(NetReader, reads_waypoints_where_sumo_has_them) {
  Network network = read_network(network_file("plaza/plaza.net.xml"));
  std::ofstream(path_) << R"(<additional>
<poi id="a" type="pedzone.waypoint" x="3" y="-4.5"><param key="pedzone.radius" value="20"/>
  <param key="colour" value="nobody's"/></poi>
<poi id="b" type="pedzone.waypoint" lane="north_0" pos="-30" posLat="2"/>
<poi id="c" type="pedzone.waypoint" lane="east_path_0" pos="10"/>
<poi id="d" type="bench" x="0" y="0"/>
</additional>)";
  read_shapes(path_, network);
  ASSERT_EQ(network.waypoints.size(), 3u);
  EXPECT_EQ(network.waypoints[0].id, "a");
  EXPECT_EQ(network.waypoints[0].at, Vec2(3, -4.5));
  EXPECT_EQ(network.waypoints[0].radius, 20.0);
  EXPECT_NEAR((network.waypoints[1].at - Vec2(2, 34.5)).norm(), 0.0, 1e-9);
  EXPECT_EQ(network.waypoints[1].radius, std::nullopt);
  EXPECT_NEAR((network.waypoints[2].at - Vec2(130, -7)).norm(), 0.0, 0.01);
}

TEST_F(NetReader, malformed_polygons_are_an_error) {
  Network network;
  std::ofstream(path_) << "<additional>\n<poly id=\"a\" shape=\"0,0 4;0\"/></additional>";
  try {
    read_shapes(path_, network);
    FAIL();
  } catch (const InputError& problem) {
    EXPECT_THAT(problem.what(), HasSubstr(":2: <poly id=\"a\"> attribute shape: '4;0' is not"));
  }
}

}  // namespace
}  // namespace pedzone::test
