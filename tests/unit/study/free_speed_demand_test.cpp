// The demand of free-speed runs, as SUMO runs it: a few people, nobody ever beside another one, no
// vehicle.
#include "study/plan/free_speed_demand.hpp"

#include <cstdlib>
#include <map>
#include <set>

#include "core/xml.hpp"
#include "core/xml_stream.hpp"
#include "study_scene.hpp"
#include "sumo/files/people_file.hpp"
#include "sumo/files/sumo_home.hpp"

namespace pedzone::study {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

constexpr const char* kNetwork = PEDZONE_SCENARIOS "/../networks/plaza/plaza.net.xml";

class FreeSpeedTest : public StudyScene {
 protected:
  FreeSpeedTest() {
    find_sumo_data();
    std::filesystem::create_directories(out_);
  }

  /// What SUMO has written about a run.
  struct Outcome {
    std::set<std::string> persons, vehicles, arrived;
    std::size_t most_at_once = 0;  ///< persons
    double end = 0.0;              ///< [s] of the last one's arrival
  };

  /// Has SUMO make the free-speed run of a study's first condition.
  Outcome run(const std::string& text) const {
    const Plan made = plan(text);
    const std::size_t run = made.run_of(RunKind::kFreeSpeed, 0, "striping", 0);
    const RunCommands commands = run_commands(made, made.runs[run], "/opt/pedzone", out_);
    for (const auto& file : commands.files) write("out/" + file.name, file.text);
    EXPECT_THAT(commands.commands, SizeIs(1));
    std::string line;
    for (const std::string& word : commands.commands[0]) line += " '" + word + "'";
    EXPECT_EQ(std::system((line + " > " + out_ + "/log.txt 2>&1").c_str()), 0)
        << text_of(out_ + "/log.txt");
    return outcome();
  }

  Outcome outcome() const {
    Outcome found;
    std::size_t at_once = 0;
    visit_elements(out_ + "/fcd.xml.gz", "fcd-export", [&](const XmlElement& element) {
      if (element.name() == "timestep") at_once = 0;
      if (element.name() == "vehicle") found.vehicles.emplace(element.required("id"));
      if (element.name() != "person") return;
      found.persons.emplace(element.required("id"));
      found.most_at_once = std::max(found.most_at_once, ++at_once);
    });
    std::string last;
    visit_elements(out_ + "/tripinfo.xml", "tripinfos", [&](const XmlElement& element) {
      if (element.name() == "personinfo") last = element.required("id");
      if (element.name() != "walk") return;
      const double arrival = element.number("arrival", {-1, 1e6});
      if (arrival < 0.0) return;
      found.arrived.insert(last);
      found.end = std::max(found.end, arrival);
    });
    return found;
  }

  std::string people() const { return text_of(out_ + "/people.rou.xml"); }

  const std::string out_ = folder_ + "/out";
};

TEST_F(FreeSpeedTest, people_of_flows_walk_alone) {
  const Outcome seen = run("<study>" + scenario("plaza/plaza-low.sumocfg") + "</study>");
  EXPECT_THAT(seen.persons, SizeIs(kFreeSpeedPersons));
  EXPECT_EQ(seen.arrived, seen.persons);
  EXPECT_EQ(seen.most_at_once, 1u);
  EXPECT_THAT(seen.vehicles, SizeIs(0));
  EXPECT_TRUE(seen.persons.contains("west_to_east.0"));  // as SUMO names them in the scenario
}

TEST_F(FreeSpeedTest, groups_are_dissolved) {
  const std::string scenario_file = "groups/plaza.sumocfg";
  ASSERT_THAT(text_of(PEDZONE_SCENARIOS "/groups/plaza.persons.rou.xml"),
              HasSubstr("pedzone.group"));
  const Outcome seen = run("<study>" + scenario(scenario_file) + "</study>");
  EXPECT_THAT(seen.persons, SizeIs(kFreeSpeedPersons));
  EXPECT_EQ(seen.arrived, seen.persons);
  EXPECT_EQ(seen.most_at_once, 1u);
  EXPECT_THAT(people(), Not(HasSubstr("pedzone.group")));
}

TEST_F(FreeSpeedTest, the_panel_s_people_are_the_same_as_in_the_study) {
  const Outcome seen =
      run("<study seeds='4'>" +
          scenario("panel/panel.sumocfg", "zone='" PEDZONE_SCENARIOS "/panel/panel.zone.xml'") +
          "</study>");
  EXPECT_THAT(seen.persons, SizeIs(kFreeSpeedPersons));
  EXPECT_EQ(seen.arrived, seen.persons);
  EXPECT_EQ(seen.most_at_once, 1u);
  // Whom the study's own runs have: `pedzone demand` writes the same.
  const ZoneFile file = read_zone_file(PEDZONE_SCENARIOS "/panel/panel.zone.xml");
  const Scenario read = read_scenario(PEDZONE_SCENARIOS "/panel/panel.sumocfg", {});
  const Network network = read_scenario_network(read);
  const std::vector<Zone> zones = build_zones(network, file.zones);
  pugi::xml_document all, few;
  ASSERT_TRUE(
      all.load_string(people_file({read, network, zones, file.profiles, file.panels, 4}).c_str()));
  ASSERT_TRUE(few.load_string(people().c_str()));
  for (const std::string& id : seen.persons) {
    const auto speed = [&](const pugi::xml_document& document) {
      return std::string(document.document_element()
                             .find_child_by_attribute("vType", "id", id.c_str())
                             .attribute("maxSpeed")
                             .value());
    };
    EXPECT_NE(speed(all), "") << id;
    EXPECT_EQ(speed(few), speed(all)) << id;
  }
}

TEST_F(FreeSpeedTest, demand_in_additional_files_goes_the_rest_stays) {
  write("mixed.add.xml", R"(<additional>
  <poly id="house" type="building" shape="0,0 1,0 1,1"/>
  <poi id="bench" type="pedzone.seat" x="1" y="1"/>
  <vType id="slow" vClass="pedestrian" maxSpeed="0.7"><param key="pedzone.group" value="all"/></vType>
  <vType id="van" vClass="delivery"/>
  <person id="walker" type="slow" depart="5"><walk from="west_path" to="east_path"/></person>
  <person id="stayer" depart="6"><stop lane="west_path_0" duration="9"/></person>
  <person id="rider" depart="7"><ride from="west_road_in" to="west_in" lines="ANY"/></person>
  <person id="rester" depart="8"><walk from="west_path" to="north"/>
    <stop lane="north_0" duration="50"/><walk to="south"/></person>
  <trip id="car" type="van" depart="0" from="west_road_in" to="east_road_out"/>
</additional>)");
  write("plain.add.xml", "<additional><poi id='tree' x='2' y='2'/></additional>");
  write("own.rou.xml", R"(<routes>
  <route id="r" edges="west_road_in west_in east_out east_road_out"/>
  <vehicle id="car2" depart="1" route="r"/> <flow id="cars" begin="0" end="50" period="5" route="r"/>
</routes>)");
  write("mixed.sumocfg", "<configuration><net-file value='" + std::string(kNetwork) +
                             "'/><route-files value='own.rou.xml'/>"
                             "<additional-files value='plain.add.xml,mixed.add.xml'/>"
                             "<scale value='3'/><end value='100'/></configuration>");
  const Outcome seen = run("<study><scenario file='mixed.sumocfg' options='--begin 50'/></study>");
  EXPECT_THAT(seen.persons, ElementsAre("rester", "walker"));
  EXPECT_EQ(seen.arrived, seen.persons);
  EXPECT_EQ(seen.most_at_once, 1u);
  EXPECT_THAT(seen.vehicles, SizeIs(0));
  const std::string kept = text_of(out_ + "/additional-2.xml");
  for (const char* there : {"house", "bench", "id=\"slow\"", "id=\"van\""}) {
    EXPECT_THAT(kept, HasSubstr(there));
  }
  for (const char* gone : {"walker", "rider", "car", "pedzone.group"}) {
    EXPECT_THAT(kept, Not(HasSubstr(gone)));
  }
  EXPECT_FALSE(std::filesystem::exists(out_ + "/additional-1.xml"));
}

TEST_F(FreeSpeedTest, people_who_only_pass_outside_are_left_out) {
  write("own.rou.xml", R"(<routes>
  <person id="outside" depart="0"><walk edges="north"/></person>
  <person id="inside" depart="1"><walk from="north" to="south"/></person>
</routes>)");
  write("own.zone.xml", "<zones><zone id=\'a\' edges=\'south\'/></zones>");
  write("own.sumocfg",
        "<configuration><net-file value='" + std::string(kNetwork) +
            "'/><route-files value='own.rou.xml'/><end value='100'/></configuration>");
  const Outcome seen = run("<study><scenario file='own.sumocfg' zone='own.zone.xml'/></study>");
  EXPECT_THAT(seen.persons, ElementsAre("inside"));
}

TEST_F(FreeSpeedTest, nobody_to_measure_is_an_error) {
  write("own.rou.xml",
        "<routes><person id='p' depart='0'><stop lane='north_0' duration='9'/>"
        "</person></routes>");
  const std::string config = write(
      "own.sumocfg", "<configuration><net-file value='" + std::string(kNetwork) +
                         "'/><route-files value='own.rou.xml'/><end value='9'/></configuration>");
  const Plan made = plan("<study><scenario file='own.sumocfg'/></study>");
  try {
    run_commands(made, made.runs[0], "/opt/pedzone", out_);
    FAIL();
  } catch (const InputError& problem) {
    EXPECT_EQ(problem.what(),
              config +
                  ": route files: has nobody whose free speed can be measured; allowed: a "
                  "<person> or <personFlow> that only walks, and through a zone");
  }
}

}  // namespace
}  // namespace pedzone::study
