// What is done for a run: its command lines, its zone file, and that SUMO takes them.
#include <cstdlib>
#include <regex>

#include "core/xml.hpp"
#include "study/plan/setting.hpp"
#include "study_scene.hpp"
#include "sumo/files/sumo_home.hpp"
#include "zone/vehicle_path.hpp"

namespace pedzone::study {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kPanelZone = "zone='" PEDZONE_SCENARIOS "/panel/panel.zone.xml'";

class RunCommandsTest : public StudyScene {
 protected:
  RunCommandsTest() {
    find_sumo_data();
    std::filesystem::create_directories(out_);
  }

  RunCommands commands(const std::string& text, const std::string& model,
                       std::size_t condition = 0) const {
    const Plan made = plan(text);
    const std::size_t run =
        made.run_of(RunKind::kStudy, condition, model, made.study.seeds.front());
    return run_commands(made, made.runs[run], "/opt/pedzone", out_);
  }

  /// One command as a line; the run's folder is OUT, the scenarios' folder IN.
  std::string line(const std::vector<std::string>& command) const {
    std::string text;
    for (const std::string& word : command) text += (text.empty() ? "" : " ") + word;
    text = std::regex_replace(text, std::regex(out_), "OUT");
    return std::regex_replace(text, std::regex(PEDZONE_SCENARIOS), "IN");
  }

  /// Has a shell run it, in the folder of the study.
  int execute(const std::vector<std::string>& command) const {
    std::string line = "cd '" + folder_ + "' &&";
    for (const std::string& word : command) line += " '" + word + "'";
    return std::system((line + " > '" + out_ + "/log.txt' 2>&1").c_str());
  }

  /// All files of the study's folder.
  std::vector<std::string> left() const {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
      if (!entry.is_regular_file()) continue;
      files.push_back(std::filesystem::relative(entry.path(), folder_).string());
    }
    std::ranges::sort(files);
    return files;
  }

  const std::string out_ = folder_ + "/out put";
};

constexpr const char* kMeasured =
    "--fcd-output OUT/fcd.xml.gz --tripinfo-output OUT/tripinfo.xml "
    "--statistic-output OUT/statistics.xml "
    "--tripinfo-output.write-unfinished true --tripinfo-output.write-undeparted true "
    "--precision 4";

TEST_F(RunCommandsTest, striping_is_plain_sumo) {
  const RunCommands made =
      commands("<study seeds='7'>" + scenario("plaza/plaza-low.sumocfg") + "</study>", "striping");
  EXPECT_THAT(made.files, IsEmpty());
  ASSERT_EQ(made.commands.size(), 1u);
  EXPECT_EQ(line(made.commands[0]), "sumo -c IN/plaza/plaza-low.sumocfg --no-step-log true " +
                                        std::string(kMeasured) +
                                        " --pedestrian.model striping --seed 7");
}

TEST_F(RunCommandsTest, pedzone_walks_by_its_model) {
  const RunCommands made = commands("<study seeds='7' end='90.5' models='orca'>" +
                                        scenario("plaza/plaza-low.sumocfg", "options='--scale 2'") +
                                        "<factor id='a' parameter='sight' values='5'/></study>",
                                    "orca");
  ASSERT_EQ(made.files.size(), 1u);
  EXPECT_EQ(made.files[0].name, "zone.zone.xml");
  EXPECT_THAT(made.files[0].text, HasSubstr("<param key=\"sight\" value=\"5\""));
  ASSERT_EQ(made.commands.size(), 1u);
  EXPECT_EQ(line(made.commands[0]),
            "/opt/pedzone run IN/plaza/plaza-low.sumocfg --zone OUT/zone.zone.xml --model orca "
            "--seed 7 --threads 1 --end 90.5 --summary OUT/summary.json -- --scale 2 " +
                std::string(kMeasured));
}

TEST_F(RunCommandsTest, sumo_walks_the_panel_s_people_too) {
  const RunCommands made = commands(
      "<study seeds='7'>" + scenario("panel/panel.sumocfg", kPanelZone) + "</study>", "striping");
  ASSERT_EQ(made.commands.size(), 2u);
  EXPECT_THAT(
      line(made.commands[0]),
      StartsWith("/opt/pedzone demand IN/panel/panel.sumocfg --zone OUT/zone.zone.xml --seed "
                 "7 --out OUT/people.rou.xml -- "));
  EXPECT_THAT(line(made.commands[1]),
              HasSubstr("--additional-files IN/panel/../../networks/plaza/plaza.poly.xml,"
                        "OUT/people.rou.xml"));
}

TEST_F(RunCommandsTest, the_configuration_s_own_outputs_go_to_the_run_s_folder) {
  write("own.sumocfg", "<configuration><input><net-file value='" PEDZONE_SCENARIOS
                       "/../networks/plaza/plaza.net.xml'/><route-files value='" PEDZONE_SCENARIOS
                       "/plaza/plaza-low.persons.rou.xml'/></input><output>"
                       "<output-prefix value='mine.'/><summary value='sub/s.xml'/>"
                       "<fcd-output value='f.xml'/><fcd-output.geo value='true'/>"
                       "<human-readable-time value='true'/><error-log value='log.e'/></output>"
                       "<time><end value='20'/></time><processing>"
                       "<pedestrian.model value='nonInteracting'/></processing>"
                       "<report><no-step-log value='true'/></report>"
                       "<random_number><random value='true'/></random_number></configuration>");
  const std::string study =
      "<study models='striping orca' seeds='3'>"
      "<scenario file='own.sumocfg' options='--stop-output stops.xml'/>"
      "</study>";
  const RunCommands made = commands(study, "striping");
  ASSERT_EQ(execute(made.commands[0]), 0) << text_of(out_ + "/log.txt");
  EXPECT_THAT(left(), ElementsAre("out put/fcd.xml.gz", "out put/log.e", "out put/log.txt",
                                  "out put/s.xml", "out put/statistics.xml", "out put/stops.xml",
                                  "out put/tripinfo.xml", "own.sumocfg", "test.study.xml"));
  // Seconds, not 0:00:07, as the seed says.
  const XmlFile trips(out_ + "/tripinfo.xml");
  ASSERT_TRUE(trips.root().child("personinfo"));
  for (const pugi::xml_node& person : trips.root().children("personinfo")) {
    EXPECT_NO_THROW(trips.number(person, "depart", {0, 1000}));
  }
  EXPECT_THAT(line(commands(study, "orca").commands[0]),
              AllOf(HasSubstr("--pedestrian.model striping"), HasSubstr("--random false")));
}

TEST_F(RunCommandsTest, what_additional_files_have_written_goes_there_too) {
  std::filesystem::create_directories(folder_ + "/extra");
  write("extra/signs.xml", "<vss><step time='0' speed='5'/></vss>");
  write("extra/poly.add.xml", "<additional><poi id='tree' x='1' y='1'/></additional>");
  const std::string detectors = write("extra/loops.add.xml", R"(<additional>
  <include href="poly.add.xml"/>
  <variableSpeedSign id="sign" lanes="west_road_in_0" file="signs.xml"/>
  <inductionLoop id="loop &lt;1&gt;" lane="west_road_in_0" pos="5" period="10" file="sub/loop.xml"/>
  <edgeData id="edges" file="edges.xml"/> <laneData id="none" file="NUL"/>
  <person id="extra" depart="0"><walk from="west_path" to="east_path"/></person>
</additional>)");
  write("own.sumocfg", "<configuration><net-file value='" PEDZONE_SCENARIOS
                       "/../networks/plaza/plaza.net.xml'/><end value='30'/>"
                       "<additional-files value='extra/loops.add.xml'/></configuration>");
  const std::string study = "<study models='striping orca'><scenario file='own.sumocfg'/></study>";
  const RunCommands made = commands(study, "striping");
  EXPECT_THAT(made.inputs,
              ::testing::UnorderedElementsAre(
                  ::testing::EndsWith("plaza.net.xml"), detectors, folder_ + "/extra/poly.add.xml",
                  folder_ + "/extra/signs.xml", folder_ + "/own.sumocfg"));
  ASSERT_EQ(made.files.size(), 1u);
  write("out put/" + made.files[0].name, made.files[0].text);
  const std::vector<std::string> before = left();
  ASSERT_EQ(execute(made.commands[0]), 0) << text_of(out_ + "/log.txt");
  std::vector<std::string> written;
  std::ranges::set_difference(left(), before, std::back_inserter(written));
  EXPECT_THAT(written,
              ElementsAre("out put/additional-1.edges.xml", "out put/additional-1.loop.xml",
                          "out put/fcd.xml.gz", "out put/log.txt", "out put/statistics.xml",
                          "out put/tripinfo.xml"));
  EXPECT_TRUE(XmlFile(out_ + "/additional-1.loop.xml").root().child("interval"));
  EXPECT_TRUE(XmlFile(out_ + "/tripinfo.xml").root().child("personinfo"));
  const RunCommands walked = commands(study, "orca");
  EXPECT_EQ(walked.files, made.files);
  EXPECT_THAT(line(walked.commands[0]), HasSubstr("--additional-files OUT/additional-1.xml"));
}

TEST_F(RunCommandsTest, inputs_are_all_files_that_are_read) {
  write("mine.so", "");
  const std::string encounter = PEDZONE_SCENARIOS "/experiments/";
  const Plan made =
      plan("<study seeds='1' models='./mine.so striping'>" +
           scenario("experiments/5.1.sumocfg", "zone='" + encounter + "5.1-full.zone.xml'") +
           "</study>");
  const std::string networks =
      std::filesystem::path(encounter + "../../networks/experiments/").lexically_normal().string();
  const auto inputs = [&](const std::string& model) {
    return run_inputs(made, made.runs[made.run_of(RunKind::kStudy, 0, model, 1)]);
  };
  EXPECT_THAT(inputs("striping"),
              ::testing::UnorderedElementsAre(
                  encounter + "5.1.sumocfg", encounter + "5.1.rou.xml", encounter + "5.1.add.xml",
                  encounter + "5.1-full.zone.xml", encounter + "5.1-full.csv",
                  networks + "experiments.net.xml"));
  EXPECT_THAT(inputs("./mine.so"), Contains(folder_ + "/mine.so"));
  for (const PlannedRun& run : made.runs) {
    EXPECT_EQ(run_commands(made, run, "/opt/pedzone", out_).inputs, run_inputs(made, run));
  }
}

TEST_F(RunCommandsTest, the_zone_file_says_what_the_condition_does) {
  write("many.zone.xml", R"(<zones>
  <profile id="courier" base="adult"/>
  <zone id="a" edges="west_in"><param key="sight" value="20"/></zone>
  <zone id="b" weather="rain" model="sub/mine.so"/>
  <pedestrians id="first" number="5"/>
  <vehiclePath vehicle="av" file="sub/av.csv"/>
</zones>)");
  const Plan made =
      plan("<study seeds='1'>" + scenario("plaza/plaza-low.sumocfg", "zone='many.zone.xml'") + R"(
  <factor id="x"><level name="y">
    <set parameter="sight" value="7"/><set parameter="hearing" value="3"/>
    <set zone="openSpace" value="2.5"/><set zone="weather" value="ice"/>
    <set panel="number" value="12"/><set panel="profiles" value="courier=0.5"/>
  </level></factor></study>)");
  const ZoneFile file = read_zone_file(write("made.zone.xml", zone_text(made, 0)));
  ASSERT_EQ(file.zones.size(), 2u);
  for (const ZoneSpec& zone : file.zones) {
    EXPECT_EQ(zone.parameters.sight, 7.0);
    EXPECT_EQ(zone.parameters.hearing, 3.0);
    EXPECT_EQ(zone.open_space, 2.5);
    EXPECT_EQ(zone.weather->id, "ice");
  }
  EXPECT_THAT(file.zones[0].edges, ElementsAre("west_in"));
  ASSERT_EQ(file.panels.size(), 2u);
  EXPECT_EQ(file.panels[1].id, "pedestrians2");
  EXPECT_EQ(file.panels[1].number, 12);
  EXPECT_EQ(file.panels[1].profiles.size(), 1u);
  EXPECT_THAT(zone_text(made, 0), HasSubstr("file=\"" + folder_ + "/sub/av.csv\""));
  EXPECT_THAT(zone_text(made, 0), Not(HasSubstr("mine.so"))) << "each run has its own model";
  EXPECT_THAT(run_inputs(made, made.runs.front()), Not(Contains(folder_ + "/sub/mine.so")));
  // What the reader makes of the text is what is known without it.
  const ZoneFile known = zone_file_of(made.study, made.study.scenarios[0],
                                      settings_of(made.study, made.conditions[0]));
  ASSERT_EQ(known.zones.size(), file.zones.size());
  for (std::size_t i = 0; i < known.zones.size(); ++i) {
    EXPECT_EQ(known.zones[i].edges, file.zones[i].edges);
    EXPECT_EQ(known.zones[i].open_space, file.zones[i].open_space);
    EXPECT_EQ(known.zones[i].weather, file.zones[i].weather);
    for (const ParameterInfo& info : parameter_list()) {
      EXPECT_EQ(known.zones[i].parameters.*info.member, file.zones[i].parameters.*info.member);
    }
  }
  const auto text = [&](RunKind kind, const std::string& model) {
    return zone_text(made, made.runs[made.run_of(kind, 0, model, 1)]);
  };
  EXPECT_EQ(text(RunKind::kStudy, "heuristic"), zone_text(made, 0));
  EXPECT_THAT(
      text(RunKind::kStudy, "striping"),
      AllOf(HasSubstr("openSpace=\"2.5\""), HasSubstr("number=\"12\""),
            HasSubstr("\"sight\" value=\"20\""), Not(HasSubstr("ice")), Not(HasSubstr("hearing"))));
  EXPECT_THAT(text(RunKind::kFreeSpeed, "heuristic"),
              AllOf(HasSubstr("ice"), Not(HasSubstr("<pedestrians")), Not(HasSubstr("<vehicle"))));
}

TEST_F(RunCommandsTest, a_zone_is_made_where_the_scenario_has_none) {
  const auto text = [&](const std::string& factor) {
    return zone_text(plan("<study>" + scenario("plaza/plaza-low.sumocfg") + factor + "</study>"),
                     0);
  };
  EXPECT_EQ(text(""), "");
  EXPECT_EQ(text("<factor id='a' sumo='scale' values='2'/>"), "");
  const ZoneFile made =
      read_zone_file(write("made.zone.xml", text("<factor id='a' zone='openSpace' values='3'/>")));
  ASSERT_EQ(made.zones.size(), 1u);
  EXPECT_EQ(made.zones[0].id, ZoneSpec().id);
  EXPECT_TRUE(made.zones[0].automatic());
  const ZoneFile people =
      read_zone_file(write("people.zone.xml", text("<factor id='a' panel='number' values='3'/>")));
  EXPECT_THAT(people.zones, IsEmpty());
  EXPECT_EQ(people.panels.size(), 1u);
}

}  // namespace
}  // namespace pedzone::study
