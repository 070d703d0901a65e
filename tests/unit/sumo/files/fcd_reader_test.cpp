#include "sumo/files/fcd_reader.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"

namespace pedzone {
namespace {

class Fcd : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  void write(const std::string& text) { std::ofstream(file_) << text; }

  BodySizes sizes(const std::string& routes) {
    write(routes);
    BodySizes known;
    known.read(file_);
    return known;
  }

  /// What a step of the file was visited with.
  struct Step {
    double time;
    std::vector<PersonSample> persons;
    std::vector<VehicleSample> vehicles;
    std::vector<std::string> rides_in;
  };
  std::vector<Step> read(const BodySizes& known, const std::string& steps) {
    write("<fcd-export>" + steps + "</fcd-export>");
    std::vector<Step> visited;
    FcdReader(known, as_persons_)
        .read(
            file_,
            [&](double time, std::span<const PersonSample> persons,
                std::span<const VehicleSample> vehicles) {
              visited.push_back(
                  {time, {persons.begin(), persons.end()}, {vehicles.begin(), vehicles.end()}, {}});
              for (const auto& p : persons) visited.back().rides_in.emplace_back(p.rides_in);
            },
            {});
    return visited;
  }

  /// Its own for each test: they run side by side.
  std::string file_ = testing::TempDir() + "pedzone_fcd_reader_test." +
                      testing::UnitTest::GetInstance()->current_test_info()->name() + ".xml";
  std::unordered_set<std::string> as_persons_;
};

TEST_F(Fcd, sizes_come_from_types_classes_and_defaults) {
  const BodySizes known = sizes(
      "<routes><vType id='van' length='6' width='2'/><vType id='city' vClass='bus' length='9'/>"
      "<vTypeDistribution id='mix'><vType id='slim' vClass='pedestrian' width='0.4'/>"
      "<vType id='wide' vClass='pedestrian' width='0.8'/></vTypeDistribution>"
      "<person id='a' type='wide'/><personFlow id='f' type='mix'/><person id='b'/></routes>");
  const auto is = [](const std::optional<BodySize>& size, double length, double width) {
    return size && size->length == length && size->width == width;
  };
  EXPECT_TRUE(is(known.of_type("van"), 6.0, 2.0));
  EXPECT_TRUE(is(known.of_type("van@car7"), 6.0, 2.0));
  EXPECT_TRUE(is(known.of_type("city"), 9.0, 2.5));
  EXPECT_TRUE(is(known.of_type("DEFAULT_VEHTYPE"), 5.0, 1.8));
  EXPECT_EQ(known.of_type("tram"), std::nullopt);
  EXPECT_TRUE(is(known.of_person("a"), 0.215, 0.8));
  EXPECT_TRUE(is(known.of_person("f.12"), 0.215, 0.4));
  EXPECT_TRUE(is(known.of_person("b"), 0.215, 0.478));
}

TEST_F(Fcd, reference_points_and_angles_become_ours) {
  const BodySizes known = sizes("<routes><vType id='van' length='6' width='2'/></routes>");
  const auto steps = read(known,
                          "<timestep time='1.5'>"
                          "<vehicle id='v' x='100' y='50' angle='0' speed='4' type='van'/>"
                          "<person id='p' x='90' y='50' angle='90' speed='1'/></timestep>");
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].time, 1.5);
  // Driving north, its centre half a length behind its front.
  EXPECT_LT((steps[0].vehicles[0].centre - Vec2(100, 47)).norm(), 1e-9);
  EXPECT_LT((steps[0].vehicles[0].velocity - Vec2(0, 4)).norm(), 1e-9);
  EXPECT_LT((steps[0].persons[0].position - Vec2(90, 50)).norm(), 1e-9);
  EXPECT_LT((steps[0].persons[0].velocity - Vec2(1, 0)).norm(), 1e-9);
  EXPECT_NEAR(steps[0].persons[0].radius, 0.239, 1e-9);
}

TEST_F(Fcd, directions_are_those_of_the_way_gone) {
  const BodySizes known;
  std::string text;
  for (int i = 0; i < 5; ++i) {  // faces east, walks north-east
    const std::string at = std::to_string(0.1 * i);
    text += "<timestep time='" + at + "'><person id='p' x='" + at + "' y='" + at +
            "' angle='90' speed='1.41'/></timestep>";
  }
  const auto steps = read(known, text);
  EXPECT_NEAR(angle_of(steps.back().persons[0].velocity), kPi / 4.0, 0.01);
  EXPECT_NEAR(steps.back().persons[0].velocity.norm(), 1.41, 1e-9);
  EXPECT_EQ(steps.back().persons[0].heading, 0.0);
}

TEST_F(Fcd, places_in_degrees_are_refused) {
  const auto walked = [&](double step) {
    std::string steps;
    for (int t = 0; t < 120; ++t) {
      steps += "<timestep time='" + std::to_string(t) + "'><person id='a' x='" +
               std::to_string(9.7 + step * t) + "' y='50.8' angle='90' speed='1'/></timestep>";
    }
    return read(BodySizes(), steps);
  };
  EXPECT_EQ(walked(1.0).size(), 120u);
  EXPECT_THAT([&] { walked(1.4e-5); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("has places in degrees")));
}

TEST_F(Fcd, a_person_where_a_vehicle_is_rides_in_it) {
  const auto steps = read({},
                          "<timestep time='0'>"
                          "<person id='in' x='10' y='5' angle='90' speed='3'/>"
                          "<person id='by' x='10' y='5.5' angle='90' speed='3'/>"
                          "<vehicle id='v' x='10' y='5' angle='90' speed='3' "
                          "type='DEFAULT_VEHTYPE'/></timestep>");
  EXPECT_THAT(steps[0].rides_in, ::testing::ElementsAre("v", ""));
}

TEST_F(Fcd, vehicles_of_named_types_count_as_persons) {
  as_persons_ = {"DEFAULT_BIKETYPE"};
  const auto steps = read({},
                          "<timestep time='0'><vehicle id='v' x='10' y='5' angle='90' speed='3' "
                          "type='DEFAULT_BIKETYPE'/></timestep>");
  EXPECT_TRUE(steps[0].vehicles.empty());
  ASSERT_EQ(steps[0].persons.size(), 1U);
  EXPECT_LT((steps[0].persons[0].position - Vec2(9.2, 5)).norm(), 1e-9);  // 1.6 m long
}

TEST_F(Fcd, a_vehicle_that_bends_is_there_part_by_part) {
  const BodySizes known = sizes(
      "<routes><vType id='tram' vClass='tram' length='30'><param key='carriageLength' value='10'/>"
      "</vType><vType id='usual' vClass='tram'/><vType id='stiff' vClass='tram' length='30'>"
      "<param key='carriageLength' value='30'/></vType>"
      "<vType id='long' vClass='bus' guiShape='bus/flexible' length='16.5'/></routes>");
  EXPECT_EQ(known.parts_of_type("tram", 30.0).count(), 3);
  EXPECT_EQ(known.parts_of_type("usual", 22.0).count(), 3);
  EXPECT_EQ(known.parts_of_type("stiff", 30.0).count(), 1);
  EXPECT_EQ(known.parts_of_type("long", 16.5).count(), 2);
  EXPECT_EQ(known.parts_of_type("DEFAULT_VEHTYPE", 5.0).count(), 1);
  const auto vehicle = [](double t, double x, double y, double angle) {
    return "<timestep time='" + std::to_string(t) + "'><vehicle id='v' x='" + std::to_string(x) +
           "' y='" + std::to_string(y) + "' angle='" + std::to_string(angle) +
           "' speed='10' type='tram'/></timestep>";
  };
  // East, then north.
  const auto steps =
      read(known, vehicle(0, 0, 0, 90) + vehicle(1, 10, 0, 90) + vehicle(2, 10, 10, 72) +
                      vehicle(3, 10, 20, 45) + vehicle(4, 10, 300, 0));
  ASSERT_EQ(steps[3].vehicles.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(steps[3].vehicles[k].id, "v");
    EXPECT_EQ(steps[3].vehicles[k].part, k);
    EXPECT_NEAR(steps[3].vehicles[k].length, 10.0, 1e-9);
    EXPECT_NEAR(steps[3].vehicles[k].velocity.norm(), 10.0, 1e-9);
  }
  EXPECT_LT((steps[3].vehicles[0].centre - Vec2(10, 15)).norm(), 1.0);
  EXPECT_LT((steps[3].vehicles[2].centre - Vec2(5, 0)).norm(), 1.0);
  EXPECT_NEAR(steps[3].vehicles[2].heading, 0.0, 0.3);
  EXPECT_LT((steps[4].vehicles[2].centre - Vec2(10, 275)).norm(), 1e-6) << "put there: straight";
}

}  // namespace
}  // namespace pedzone
