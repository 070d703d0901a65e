// A scripted vehicle's path: where it is, how it turns.
#include "zone/vehicle_path.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <pugixml.hpp>

#include "core/error.hpp"
#include "core/xml.hpp"

namespace pedzone {
namespace {

constexpr double kLength = 4.0;  // [m]

/// East for 10 m in 5 s, 2 s of rest, north for 10 m in 10 s.
VehiclePath corner() { return {"av", {{1, {0, 0}}, {6, {10, 0}}, {8, {10, 0}}, {18, {10, 10}}}}; }

void expect_near(const Vec2& place, const Vec2& expected) {
  EXPECT_NEAR(place.x(), expected.x(), 1e-9);
  EXPECT_NEAR(place.y(), expected.y(), 1e-9);
}

TEST(VehiclePath, is_at_its_rows_at_their_times) {
  for (const auto& [time, front] :
       {std::pair{1.0, Vec2(0, 0)}, {6.0, Vec2(10, 0)}, {8.0, Vec2(10, 0)}, {18.0, Vec2(10, 10)}}) {
    expect_near(corner().front(time), front);
  }
}

TEST(VehiclePath, goes_straight_at_constant_speed_between_rows) {
  expect_near(corner().front(3.5), {5, 0});
  expect_near(corner().front(7.3), {10, 0});
  expect_near(corner().front(10.5), {10, 2.5});
}

TEST(VehiclePath, stays_at_its_ends_outside_its_times) {
  expect_near(corner().front(-5), {0, 0});
  expect_near(corner().front(99), {10, 10});
}

TEST(VehiclePath, heads_where_it_goes) {
  EXPECT_NEAR(corner().heading(1.0, kLength), 0.0, 1e-12);  // its rear is before the first row
  EXPECT_NEAR(corner().heading(7.0, kLength), 0.0, 1e-12);  // it rests
  EXPECT_NEAR(corner().heading(18.0, kLength), kPi / 2.0, 1e-12);
}

TEST(VehiclePath, rear_follows_the_same_path_at_a_corner) {
  // 1 m beyond the corner the rear bumper is 3 m before it.
  EXPECT_NEAR(corner().heading(9.0, kLength), std::atan2(1.0, 3.0), 1e-12);
}

TEST(VehiclePath, turns_smoothly_at_a_corner) {
  constexpr double kStep = 0.1;  // [s]
  const VehiclePath path = corner();
  double before = path.heading(6.0, kLength);
  for (double time = 6.0; time <= 18.0; time += kStep) {
    const double now = path.heading(time, kLength);
    EXPECT_GE(now, before - 1e-12);
    // 1 m/s sideways at half a length or more from the rear bumper.
    EXPECT_LE(now - before, kStep * 1.0 / (kLength / 2.0));
    before = now;
  }
}

TEST(VehiclePath, mirrored_turns_the_other_way) {
  const VehiclePath mirrored{"av", {{1, {0, 0}}, {6, {10, 0}}, {8, {10, 0}}, {18, {10, -10}}}};
  for (double time = 0.0; time < 20.0; time += 0.7) {
    EXPECT_DOUBLE_EQ(mirrored.heading(time, kLength), -corner().heading(time, kLength));
  }
}

TEST(VehiclePath, may_rest_at_both_ends) {
  const VehiclePath path{"av", {{0, {0, 0}}, {5, {0, 0}}, {6, {0, 3}}, {9, {0, 3}}}};
  expect_near(path.front(2), {0, 0});
  EXPECT_NEAR(path.heading(2, kLength), kPi / 2.0, 1e-12);
  expect_near(path.front(8), {0, 3});
  EXPECT_NEAR(path.heading(8, kLength), kPi / 2.0, 1e-12);
}

TEST(VehiclePath, way_leads_from_the_rear_to_what_is_ahead) {
  const Polyline way = corner().way(5.0, kLength, 5.0);  // its front is at (8, 0)
  ASSERT_EQ(way.size(), 5U);                             // the corner is two rows
  expect_near(way[0], {4, 0});
  expect_near(way[1], {8, 0});
  expect_near(way[2], {10, 0});
  expect_near(way[3], {10, 0});
  expect_near(way[4], {10, 3});
}

TEST(VehiclePath, way_ends_with_the_path) {
  expect_near(corner().way(17.0, kLength, 30.0).back(), {10, 10});
  EXPECT_EQ(corner().way(18.0, kLength, 30.0).size(), 2U);
}

TEST(VehiclePath, is_named_by_the_zone_file_without_reading_its_places) {
  const std::string file = ::testing::TempDir() + "vehicle_path_specs_test.zone.xml";
  std::ofstream(file) << "<zones>\n<vehiclePath vehicle=\"av\" file=\"paths/none.csv\"/></zones>";
  const std::vector<VehiclePathSpec> specs = read_vehicle_path_specs(XmlFile(file, {"zones"}));
  ASSERT_EQ(specs.size(), 1U);
  EXPECT_EQ(specs[0].vehicle, "av");
  EXPECT_EQ(specs[0].file, ::testing::TempDir() + "paths/none.csv") << "beside the zone file";
  EXPECT_EQ(specs[0].line, 2);
  EXPECT_THROW(read_vehicle_paths(specs), InputError);
  std::remove(file.c_str());
}

TEST(VehiclePath, the_schema_says_the_same) {
  const std::string file = ::testing::TempDir() + "vehicle_path_test.zone.xml";
  std::ofstream(file) << "<zones><vehiclePath speed=\"3\"/></zones>";
  std::string message;
  try {
    read_vehicle_path_specs(XmlFile(file, {"zones"}));
  } catch (const InputError& error) {
    message = error.what();
  }
  std::remove(file.c_str());
  pugi::xml_document schema;
  ASSERT_TRUE(schema.load_file(PEDZONE_ZONES_XSD));
  std::string names;
  const auto type = schema.document_element().find_child_by_attribute("xsd:complexType", "name",
                                                                      "vehiclePathType");
  for (const auto& attribute : type.children("xsd:attribute")) {
    names += (names.empty() ? "" : ", ") + std::string(attribute.attribute("name").value());
  }
  EXPECT_EQ(message.substr(message.find("allowed: ") + 9), names);
}

}  // namespace
}  // namespace pedzone
