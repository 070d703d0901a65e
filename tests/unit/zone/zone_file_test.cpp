// The zone file: what it means, and what every mistake is told as.
#include "zone/zone_file.hpp"

#include <gmock/gmock.h>

#include <cstdio>
#include <fstream>
#include <regex>

#include "core/error.hpp"
#include "core/xml.hpp"
#include "world/model_names.hpp"

namespace pedzone {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;

class ZoneFile : public ::testing::Test {
 protected:
  ~ZoneFile() override { std::remove(path_.c_str()); }

  std::vector<ZoneSpec> read(const std::string& text) {
    std::ofstream(path_) << text;
    return read_zone_file(path_).zones;
  }

  /// The message without the name of the file: "line: ...".
  std::string error(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& problem) {
      const std::string what = problem.what();
      EXPECT_EQ(what.substr(0, path_.size() + 1), path_ + ":");
      return what.substr(path_.size() + 1);
    }
    return "no error";
  }

  const std::string path_ = ::testing::TempDir() + "zone_file_test_" +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name() +
                            ".xml";
};

TEST_F(ZoneFile, reads_every_attribute) {
  const auto zones = read(R"(<?xml version="1.0"?>
<zones xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="zones.xsd">
  <zone id="old-town" edges="e1   e2
     e4" edgeTypes="highway.service" lanes="e3_0" polygons="market" openSpace="7.5" model="heuristic">
    <param key="sight" value="12.5"/>
    <param key="creepAfter" value="0"/>
  </zone>
  <!-- all by default -->
  <zone id="rest"/>
</zones>)");
  ASSERT_EQ(zones.size(), 2u);
  EXPECT_EQ(zones[0].id, "old-town");
  EXPECT_EQ(zones[0].line, 3);
  EXPECT_EQ(zones[0].file, path_);
  EXPECT_THAT(zones[0].edges, ElementsAre("e1", "e2", "e4"));
  EXPECT_THAT(zones[0].edge_types, ElementsAre("highway.service"));
  EXPECT_THAT(zones[0].lanes, ElementsAre("e3_0"));
  EXPECT_THAT(zones[0].polygons, ElementsAre("market"));
  EXPECT_EQ(zones[0].open_space, 7.5);
  EXPECT_FALSE(zones[0].automatic());
  EXPECT_EQ(zones[0].parameters.sight, 12.5);
  EXPECT_EQ(zones[0].parameters.creep_after, 0.0);
  EXPECT_EQ(zones[0].parameters.hearing, Parameters().hearing);
  EXPECT_EQ(zones[1].line, 9);
  EXPECT_TRUE(zones[1].automatic());
  EXPECT_EQ(zones[1].open_space, std::nullopt);
  EXPECT_EQ(zones[1].model, "heuristic");
}

TEST_F(ZoneFile, polygons_alone_leave_the_choice_of_edges_to_the_rule) {
  EXPECT_TRUE(read(R"(<zones><zone id="a" polygons="market"/></zones>)")[0].automatic());
}

TEST_F(ZoneFile, takes_the_limits_of_every_parameter_and_nothing_beyond) {
  for (const ParameterInfo& info : parameter_list()) {
    const auto with = [&](double value) {
      char text[64];
      std::snprintf(text, sizeof text, "%.17g", value);
      return "<zones>\n<zone id=\"a\">\n<param key=\"" + std::string(info.key) + "\" value=\"" +
             text + "\"/></zone></zones>";
    };
    EXPECT_EQ(read(with(info.least))[0].parameters.*info.member, info.least) << info.key;
    EXPECT_EQ(read(with(info.most))[0].parameters.*info.member, info.most) << info.key;
    EXPECT_THAT(error(with(info.most + 1)), HasSubstr("is out of range; allowed: ")) << info.key;
    EXPECT_THAT(error(with(info.least - 1)),
                HasSubstr("3: <param key=\"" + std::string(info.key) + "\"> attribute value: '"))
        << info.key;
  }
}

TEST_F(ZoneFile, names_line_element_value_and_what_is_allowed) {
  EXPECT_EQ(error("<zones>\n\n<zone id=\"a\" openSpace=\"51\"/></zones>"),
            "3: <zone id=\"a\"> attribute openSpace: '51' is out of range; allowed: 0 to 50");
  EXPECT_EQ(error("<zones>\n<zone id=\"a\" openSpace=\"wide\"/></zones>"),
            "2: <zone id=\"a\"> attribute openSpace: 'wide' is not a number; allowed: 0 to 50");
  EXPECT_THAT(error("<zones>\n<zone id=\"a\" openSpace=\"nan\"/></zones>"),
              HasSubstr("'nan' is not a number"));
  EXPECT_THAT(error("<zones>\n<zone id=\"a\" openspace=\"12\"/></zones>"),
              HasSubstr("2: <zone id=\"a\">: 'openspace' is an unknown attribute; allowed: id, "
                        "edges, edgeTypes, lanes, polygons, openSpace, crossing, weather, model"));
  EXPECT_EQ(error("<zones>\n<zone id=\"a\" model=\"magic\"/></zones>"),
            "2: <zone id=\"a\"> attribute model: 'magic' is no walking model; allowed: " +
                allowed_models());
  EXPECT_THAT(error("<zones><zone id=\"a\">\n<param key=\"site\" value=\"3\"/></zone></zones>"),
              HasSubstr("2: <param> attribute key: 'site' is no parameter; allowed: sight, "));
}

TEST_F(ZoneFile, rejects_what_is_missing_empty_or_twice) {
  EXPECT_EQ(error("<zones>\n<zone/></zones>"), "2: <zone> attribute id: is missing");
  EXPECT_EQ(error("<zones>\n<zone id=\"\"/></zones>"), "2: <zone> attribute id: is empty");
  EXPECT_EQ(error("<zones>\n<zone id=\"a\"/>\n<zone id=\"a\"/></zones>"),
            "3: <zone> attribute id: 'a' is used twice; allowed: a new id");
  EXPECT_EQ(error("<zones>\n</zones>"), "1: <zones>: has no <zone>; allowed: one <zone> or more");
  EXPECT_THAT(error("<zones><zone id=\"a\" edges=\" \"/></zones>"), HasSubstr("edges: is empty"));
  EXPECT_THAT(error("<zones><zone id=\"a\" edges=\"e e\"/></zones>"),
              HasSubstr("edges: 'e' is named twice"));
  EXPECT_THAT(error("<zones><zone id=\"a\"><param key=\"sight\"/></zone></zones>"),
              HasSubstr("<param key=\"sight\"> attribute value: is missing"));
  EXPECT_THAT(error("<zones><zone id=\"a\"><param key=\"sight\" value=\"3\"/>\n"
                    "<param key=\"sight\" value=\"4\"/></zone></zones>"),
              HasSubstr("2: <param> attribute key: 'sight' is given twice"));
}

TEST_F(ZoneFile, rejects_other_elements_and_broken_files) {
  EXPECT_EQ(error("<zones>\n<area id=\"a\"/></zones>"),
            "2: <area id=\"a\">: is not allowed in <zones>; allowed: profile, path, zone, "
            "pedestrians, vehiclePath");
  EXPECT_THAT(error("<zones><zone id=\"a\">\n<parameter/></zone></zones>"),
              HasSubstr("2: <parameter>: is not allowed in <zone>; allowed: param"));
  EXPECT_EQ(error("<net>\n</net>"),
            "1: document element: 'net' is not the document element expected; allowed: zones");
  EXPECT_THAT(error("<zones>\n<zone id=\"a\">\n</zones>"), HasSubstr("3: is not well-formed XML"));
  EXPECT_THAT(error("<zones>all of it</zones>"), HasSubstr("1: <zones>: 'all of it' holds text"));
  EXPECT_THAT(error(""), HasSubstr("is not well-formed XML"));
}

TEST_F(ZoneFile, reads_profiles_and_weather) {
  std::ofstream(path_) << R"(<zones>
  <profile id="courier" speed="1.8" patience="3"/>
  <profile id="old courier" base="senior" speed="1.5"/>
  <zone id="a" weather="ice"/></zones>)";
  const pedzone::ZoneFile file = read_zone_file(path_);
  EXPECT_EQ(file.zones.at(0).weather->id, "ice");
  const Profile* courier = file.profiles.find("courier");
  const Profile* old = file.profiles.find("old courier");
  ASSERT_TRUE(courier != nullptr && old != nullptr);
  EXPECT_EQ(courier->speed, 1.8);
  EXPECT_EQ(courier->patience, 3.0);
  EXPECT_EQ(courier->share, 0.0);
  EXPECT_EQ(courier->hearing, file.profiles.find("adult")->hearing);
  EXPECT_EQ(old->hearing, file.profiles.find("senior")->hearing);
}

TEST_F(ZoneFile, rejects_bad_profiles_and_weather) {
  EXPECT_THAT(error("<zones><zone id=\"a\" weather=\"hail\"/></zones>"),
              HasSubstr("allowed: fair, rain, heat, ice"));
  EXPECT_THAT(error("<zones><profile id=\"adult\"/></zones>"), HasSubstr("is used twice"));
  EXPECT_THAT(error("<zones><profile id=\"a\" base=\"b\"/></zones>"),
              HasSubstr("is no profile; allowed: infant, child"));
  EXPECT_THAT(error("<zones><profile id=\"a\" speed=\"9\"/></zones>"), HasSubstr("0.1 to 5"));
}

TEST_F(ZoneFile, reads_people_to_be_made) {
  std::ofstream(path_) << R"(<zones>
  <profile id="courier" speed="1.8"/>
  <pedestrians number="200"/>
  <pedestrians number="20" profiles="courier=0.5" groupSize="3"
               activities="texting=0.25" atEnd="stay"/></zones>)";
  const std::vector<PanelSpec> panels = read_zone_file(path_).panels;
  ASSERT_EQ(panels.size(), 2u);
  EXPECT_EQ(panels[0].id, "pedestrians");
  EXPECT_EQ(panels[0].number, 200);
  EXPECT_FALSE(panels[0].stay);
  EXPECT_EQ(panels[1].id, "pedestrians2");
  EXPECT_THAT(panels[1].profiles, ElementsAre(std::pair<std::string, double>("courier", 0.5)));
  EXPECT_EQ(panels[1].group_least, 3);
  EXPECT_EQ(panels[1].group_most, 3);
  EXPECT_TRUE(panels[1].stay);
}

TEST_F(ZoneFile, rejects_bad_people) {
  EXPECT_EQ(error("<zones>\n<pedestrians id=\"a\" number=\"0\"/></zones>"),
            "2: <pedestrians id=\"a\"> attribute number: '0' is out of range; allowed: 1 to "
            "1000000");
  EXPECT_THAT(error("<zones><pedestrians number=\"1\"/>\n<pedestrians id=\"pedestrians\" "
                    "number=\"1\"/></zones>"),
              HasSubstr("2: <pedestrians id=\"pedestrians\"> attribute id: 'pedestrians' is used "
                        "twice"));
  EXPECT_THAT(error("<zones><pedestrians number=\"1\"><walk/></pedestrians></zones>"),
              HasSubstr("holds something"));
}

TEST_F(ZoneFile, reads_paths) {
  std::ofstream(path_) << R"(<zones>
  <path id="tour" waypoints="kiosk  well
     kiosk"/>
  <path id="errand" waypoints="well"/>
  <zone id="a"/></zones>)";
  const pedzone::ZoneFile file = read_zone_file(path_);
  ASSERT_EQ(file.paths.size(), 2u);
  EXPECT_EQ(file.paths[0].id, "tour");
  EXPECT_EQ(file.paths[0].file, path_);
  EXPECT_EQ(file.paths[0].line, 2);
  EXPECT_THAT(file.paths[0].waypoints, ElementsAre("kiosk", "well", "kiosk"));
  EXPECT_THAT(file.paths[1].waypoints, ElementsAre("well"));
}

TEST_F(ZoneFile, rejects_bad_paths) {
  EXPECT_EQ(error("<zones>\n<path id=\"a\"/></zones>"),
            "2: <path id=\"a\"> attribute waypoints: is missing");
  EXPECT_THAT(error("<zones>\n<path id=\"a\" waypoints=\" \"/></zones>"),
              HasSubstr("2: <path id=\"a\"> attribute waypoints: is empty"));
  EXPECT_THAT(error("<zones><path waypoints=\"p\"/></zones>"), HasSubstr("id: is missing"));
  EXPECT_THAT(error("<zones><path id=\"a\" waypoints=\"p q q\"/></zones>"),
              HasSubstr("waypoints: 'q' is named twice in a row"));
  EXPECT_THAT(
      error("<zones><path id=\"a\" waypoints=\"p\"/>\n<path id=\"a\" waypoints=\"p\"/></zones>"),
      HasSubstr("2: <path> attribute id: 'a' is used twice"));
  EXPECT_THAT(error("<zones><path id=\"a\" waypoints=\"p\" radius=\"1\"/></zones>"),
              HasSubstr("'radius' is an unknown attribute; allowed: id, waypoints"));
}

TEST_F(ZoneFile, the_schema_says_the_same) {
  pugi::xml_document schema;
  ASSERT_TRUE(schema.load_file(PEDZONE_ZONES_XSD));
  const auto type = [&](const char* name) {
    return schema.document_element().find_child_by_attribute("xsd:complexType", "name", name);
  };
  const auto names = [](const pugi::xml_node& node) {
    std::vector<std::string> list;
    for (const auto& attribute : node.children("xsd:attribute")) {
      list.push_back(attribute.attribute("name").value());
    }
    return list;
  };
  // What the reader takes is what its message lists for an unknown attribute.
  const auto allowed = [&](const std::string& text) {
    const std::string message = error(text);
    return split_words(message.substr(message.find("allowed: ") + 9), ',');
  };
  EXPECT_EQ(names(type("zoneType")), allowed("<zones><zone id=\"a\" x=\"\"/></zones>"));
  EXPECT_EQ(names(type("paramType")),
            allowed("<zones><zone id=\"a\"><param x=\"\"/></zone></zones>"));
  EXPECT_EQ(names(type("pathType")), allowed("<zones><path id=\"a\" x=\"\"/></zones>"));
  EXPECT_EQ(names(type("profileType")), allowed("<zones><profile id=\"a\" x=\"\"/></zones>"));
  EXPECT_EQ(names(type("pedestriansType")), allowed("<zones><pedestrians x=\"\"/></zones>"));
  const auto attribute = [&](const char* name) {
    return type("zoneType").find_child_by_attribute("xsd:attribute", "name", name);
  };
  const auto limit = [&](const char* name) {
    return attribute("openSpace")
        .select_node((".//xsd:" + std::string(name)).c_str())
        .node()
        .attribute("value")
        .as_double();
  };
  EXPECT_EQ(limit("minInclusive"), kOpenSpaceLeast);
  EXPECT_EQ(limit("maxInclusive"), kOpenSpaceMost);
  std::vector<std::string> models;
  const auto simple = [&](const char* name) {
    return schema.document_element().find_child_by_attribute("xsd:simpleType", "name", name);
  };
  for (const auto& model : simple("modelType").select_nodes(".//xsd:enumeration")) {
    models.push_back(model.node().attribute("value").value());
  }
  EXPECT_THAT(models, ElementsAreArray(kModelNames));
  EXPECT_STREQ(
      attribute("model").select_node(".//xsd:union").node().attribute("memberTypes").value(),
      "modelType pluginType");
  const std::regex plugin(
      simple("pluginType").select_node(".//xsd:pattern").node().attribute("value").value());
  for (const char* path : {"./libmine.so", "/opt/models/libmine.so", "libmine.sox", "mine"}) {
    EXPECT_EQ(std::regex_match(path, plugin), may_be_model(path)) << path;
  }
}

TEST_F(ZoneFile, a_missing_file_is_named) {
  try {
    read_zone_file("/nowhere/zones.xml");
    FAIL();
  } catch (const InputError& problem) {
    EXPECT_STREQ(problem.what(), "/nowhere/zones.xml: cannot be opened");
  }
}

}  // namespace
}  // namespace pedzone
