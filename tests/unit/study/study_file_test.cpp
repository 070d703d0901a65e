// The study file: what it means, and what every mistake is told as.
#include "study/plan/study_file.hpp"

#include "study/plan/setting.hpp"
#include "study_scene.hpp"
#include "world/model_names.hpp"

namespace pedzone::study {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

using StudyFile = StudyScene;

TEST_F(StudyFile, three_lines_are_a_study) {
  const Study study =
      read("<study seeds=\"1-3\">\n  " + scenario("plaza/plaza-low.sumocfg") + "\n</study>\n");
  EXPECT_EQ(study.id, "test");
  EXPECT_EQ(study.folder, std::filesystem::path(folder_).lexically_normal());
  EXPECT_THAT(study.models, ElementsAre("striping", "heuristic"));
  EXPECT_EQ(study.reference, "striping");
  EXPECT_THAT(study.seeds, ElementsAre(1u, 2u, 3u));
  ASSERT_EQ(study.scenarios.size(), 1u);
  EXPECT_EQ(study.scenarios[0].id, "plaza-low");
  EXPECT_EQ(study.scenarios[0].file, PEDZONE_SCENARIOS "/plaza/plaza-low.sumocfg");
  EXPECT_THAT(study.scenarios[0].sumo_options, IsEmpty());
  EXPECT_THAT(study.factors, IsEmpty());
  EXPECT_THAT(study.combinations, ElementsAre(IsEmpty()));
  EXPECT_EQ(study.end, std::nullopt);
  EXPECT_EQ(study.time_limit, 3600.0);
}

TEST_F(StudyFile, everything_is_read) {
  write("mine.so", "");
  const Study study =
      read(R"(<study id="old-town" title="Who &lt;gives&gt; way?" question="Does it?"
       seeds="61 1-3" models="orca nonInteracting ./mine.so" reference="nonInteracting" end="90.5"
       timeLimit="600">)" +
           scenario("panel/panel.sumocfg",
                    "id=\"p\" zone=\"" PEDZONE_SCENARIOS "/panel/panel.zone.xml\" "
                    "options=\"--step-length 0.2 --collision.check-junctions --scale=1.5\"") +
           R"(
  <factor id="sight" parameter="sight" values="5 10"/>
  <factor id="demand">
    <level name="low"/>
    <level name="high">
      <set panel="number" value="30" scenario="p"/> <set sumo="max-depart-delay" value="60"/>
    </level>
  </factor>
  <factor id="weather" zone="weather" values="fair rain"/>
  <combination levels="5 high rain"/> <combination levels="10  low fair"/>
</study>)");
  EXPECT_EQ(study.id, "old-town");
  EXPECT_EQ(study.title, "Who <gives> way?");
  EXPECT_EQ(study.question, "Does it?");
  EXPECT_THAT(study.models, ElementsAre("orca", "nonInteracting", "./mine.so"));
  EXPECT_EQ(study.reference, "nonInteracting");
  EXPECT_THAT(study.seeds, ElementsAre(1u, 2u, 3u, 61u));
  EXPECT_EQ(study.end, 90.5);
  EXPECT_EQ(study.time_limit, 600.0);
  EXPECT_THAT(
      study.scenarios[0].sumo_options,
      ElementsAre("--step-length", "0.2", "--collision.check-junctions", "true", "--scale", "1.5"));
  ASSERT_EQ(study.factors.size(), 3u);
  const auto& high = study.factors[1].levels[1].settings;
  ASSERT_EQ(high.size(), 2u);
  EXPECT_EQ(high[0].kind, SettingKind::kPanel);
  EXPECT_EQ(high[0].scenario, "p");
  EXPECT_EQ(high[1].key, "max-depart-delay");
  EXPECT_EQ(study.factors[2].levels[1].name, "rain");
  EXPECT_THAT(study.combinations, ElementsAre(ElementsAre(0u, 1u, 1u), ElementsAre(1u, 0u, 0u)));
}

TEST_F(StudyFile, all_combinations_where_none_is_listed) {
  const Study study = read("<study>" + scenario("plaza/plaza-low.sumocfg") +
                           "<factor id='a' parameter='sight' values='5 10 15'/>"
                           "<factor id='b' zone='openSpace' values='0 3'/></study>");
  EXPECT_THAT(study.combinations,
              ElementsAre(ElementsAre(0u, 0u), ElementsAre(0u, 1u), ElementsAre(1u, 0u),
                          ElementsAre(1u, 1u), ElementsAre(2u, 0u), ElementsAre(2u, 1u)));
}

TEST_F(StudyFile, options_go_by_their_first_name) {
  const Study study = read(
      "<study>" + scenario("plaza/plaza-low.sumocfg", "options='-b 5 --waiting-time-memory 9'") +
      "<factor id='a' sumo='W' values='true false'/></study>");
  EXPECT_THAT(study.scenarios[0].sumo_options,
              ElementsAre("--begin", "5", "--waiting-time-memory", "9"));
  EXPECT_EQ(study.factors[0].levels[0].settings[0].key, "no-warnings");
}

/// A mistake in the attributes of <study>.
struct Mistake {
  const char *attributes, *message;
};
class StudyAttributes : public StudyScene, public ::testing::WithParamInterface<Mistake> {};

TEST_P(StudyAttributes, are_refused) {
  const auto [attributes, message] = GetParam();
  EXPECT_EQ(error("<study " + std::string(attributes) + ">" + scenario("plaza/plaza-low.sumocfg") +
                  "</study>"),
            "1: <study>" + std::string(message));
}

constexpr const char* kSeeds =
    "; allowed: numbers from 0 to 2147483647 and ranges of them, such as \"1-50 61\"";
std::string seeds(const std::string& problem) { return "attribute seeds: " + problem + kSeeds; }

INSTANTIATE_TEST_SUITE_P(
    Mistakes, StudyAttributes,
    ::testing::Values(
        Mistake{"seed='1'",
                ": 'seed' is an unknown attribute; allowed: id, title, question, seeds, models, "
                "reference, end, timeLimit. Did you mean 'seeds'?"},
        Mistake{"seeds='1-1000000'",
                " attribute seeds: '1-1000000' makes too many seeds; allowed: 100000 in all"},
        Mistake{"seeds='1-5 3'", " attribute seeds: '3' is named twice; allowed: each seed once"},
        Mistake{"models=' '", " attribute models: names no model"},
        Mistake{"models=''", " attribute models: is empty"},
        Mistake{"models='orca orca'",
                " attribute models: 'orca' is named twice; allowed: each model once"},
        Mistake{"reference='orca'",
                " attribute reference: 'orca' is none of the study's models; allowed: striping, "
                "heuristic"},
        Mistake{"end='0'", " attribute end: '0' is out of range; allowed: 0.001 to 1000000000"},
        Mistake{"end='soon'",
                " attribute end: 'soon' is not a number; allowed: 0.001 to 1000000000"},
        Mistake{"timeLimit='0.5'",
                " attribute timeLimit: '0.5' is out of range; allowed: 1 to 10000000"},
        Mistake{"id=''", " attribute id: is empty"},
        Mistake{"title='\xFF'", " attribute title: is no text; allowed: UTF-8"},
        Mistake{"id='\xC3'", " attribute id: is no text; allowed: UTF-8"}));

TEST_F(StudyFile, seeds_that_are_none_are_refused) {
  for (const char* word : {"a", "1-", "-1", "1-2-3", "1,2", "1.5", "2147483648", "0x1", "1-b",
                           "99999999999999999999"}) {
    EXPECT_EQ(error("<study seeds='" + std::string(word) + "'/>"),
              "1: <study> " + seeds("'" + std::string(word) + "' is no seed"));
  }
  EXPECT_EQ(error("<study seeds='5-1'/>"), "1: <study> " + seeds("'5-1' runs backwards"));
  for (const char* none : {"", "  "}) {
    EXPECT_EQ(error("<study seeds='" + std::string(none) + "'/>"),
              "1: <study> " + seeds("names no seed"));
  }
}

TEST_F(StudyFile, unknown_models_are_refused) {
  EXPECT_EQ(error("<study models='striping strping'/>"),
            "1: <study> attribute models: 'strping' is no walking model; allowed: striping, "
            "nonInteracting, " +
                allowed_models() + ". Did you mean 'striping'?");
  EXPECT_EQ(error("<study models='./none.so'/>"),
            "1: <study> attribute models: '" + folder_ +
                "/none.so' does not exist; allowed: a shared library with a walking model");
}

TEST_F(StudyFile, scenarios_are_looked_at) {
  const std::string plaza = scenario("plaza/plaza-low.sumocfg");
  EXPECT_EQ(error("<study/>"),
            "1: <study>: has no <scenario>; allowed: one <scenario file=\"...\"/> or more");
  EXPECT_EQ(error("<study>\n<scenario/></study>"), "2: <scenario> attribute file: is missing");
  EXPECT_EQ(error("<study>\n<scenario file='no.sumocfg'/></study>"),
            "2: <scenario> attribute file: '" + folder_ +
                "/no.sumocfg' does not exist; allowed: a file, relative to " + folder_);
  EXPECT_EQ(error("<study>" + plaza + "\n" + plaza + "</study>"),
            "2: <scenario> attribute id: 'plaza-low' is used twice; allowed: a new id");
  EXPECT_EQ(
      error("<study>" + scenario("plaza/plaza-low.sumocfg", "zone='no.zone.xml'") + "</study>"),
      "1: <scenario> attribute zone: '" + folder_ +
          "/no.zone.xml' does not exist; allowed: a file, relative to " + folder_);
  write("bad.zone.xml", "<zones><zone id='a' openSpace='-1'/></zones>");
  EXPECT_THAT(
      error("<study>" + scenario("plaza/plaza-low.sumocfg", "zone='bad.zone.xml'") + "</study>"),
      HasSubstr("bad.zone.xml:1: <zone id=\"a\"> attribute openSpace: '-1' is out of range"));
  write("bad.sumocfg",
        "<configuration><end value='5'/><net-file value='no.net.xml'/>"
        "</configuration>");
  EXPECT_THAT(error("<study><scenario file='bad.sumocfg'/></study>"),
              AllOf(HasSubstr("bad.sumocfg:1: <net-file> attribute value: '"),
                    HasSubstr("no.net.xml' does not exist")));
}

TEST_F(StudyFile, a_run_must_end) {
  write("people.rou.xml", "<routes><person id='p' depart='0'/></routes>");
  write("endless.sumocfg",
        "<configuration><route-files value='people.rou.xml'/>"
        "<net-file value='" PEDZONE_SCENARIOS
        "/../networks/plaza/plaza.net.xml'/></configuration>");
  EXPECT_EQ(
      error("<study><scenario file='endless.sumocfg'/></study>"),
      "1: <scenario> attribute file: 'endless.sumocfg' does not end; allowed: a scenario with "
      "<end value=\"...\"/>, or attribute end of <study>");
  EXPECT_EQ(error("<study end='10'><scenario file='endless.sumocfg'/></study>"), "no error");
}

TEST_F(StudyFile, there_must_be_somebody_to_walk) {
  write("empty.sumocfg", "<configuration><end value='5'/><net-file value='" PEDZONE_SCENARIOS
                         "/../networks/plaza/plaza.net.xml'/></configuration>");
  const std::string empty = "<study><scenario file='empty.sumocfg'/>";
  EXPECT_EQ(error(empty + "</study>"),
            folder_ +
                "/empty.sumocfg: <route-files>: names no person; allowed: route or additional "
                "files with <person> or <personFlow>");
  EXPECT_EQ(error(empty + "<factor id='a' panel='number' values='5 10'/></study>"), "no error");
}

TEST_F(StudyFile, a_kept_copy_keeps_id_and_folder) {
  const std::string text = "<study><scenario file='plaza/plaza-low.sumocfg'/></study>";
  const Study study = read_study(write("study.xml", text), PEDZONE_SCENARIOS, "town");
  EXPECT_EQ(study.id, "town");
  EXPECT_EQ(study.resolve("a/../b.xml"), PEDZONE_SCENARIOS "/b.xml");
  EXPECT_EQ(study.resolve("/a/b.xml"), "/a/b.xml");
}

TEST_F(StudyFile, options_that_a_scenario_cannot_have_are_refused) {
  const auto message = [&](const std::string& options) {
    return error("<study>" + scenario("plaza/plaza-low.sumocfg", "options='" + options + "'") +
                 "</study>");
  };
  const std::string place = "1: <scenario> attribute options: ";
  EXPECT_EQ(message("--no-such 1"),
            place + "'no-such' is no option of SUMO; allowed: those of `sumo --help`");
  EXPECT_EQ(message("fast"), place + "'fast' is no option; allowed: --name value ...");
  EXPECT_EQ(message("--scale"), place + "'--scale' has no value; allowed: --name value ...");
  EXPECT_EQ(message("--scale two"),
            place + "'two' is no value of SUMO's option scale; allowed: a number");
  EXPECT_EQ(message("--scale 2 --scale 3"),
            place + "'--scale' is given twice; allowed: each option once");
  for (const char* taken : {"--seed 5", "-e 100", "--pedestrian.model striping", "--random"}) {
    EXPECT_THAT(
        message(taken),
        HasSubstr("' cannot be set by a study; allowed: attributes seeds, models and end of "
                  "<study>"));
  }
  for (const char* taken : {"--fcd-output f.xml", "--fcd-output.geo", "--device.fcd.period 5",
                            "--tripinfo f.xml", "--precision 2", "--output-prefix a"}) {
    EXPECT_THAT(message(taken),
                HasSubstr("' cannot be set by a study; allowed: other options: this one is for"));
  }
  EXPECT_THAT(message("-c other.sumocfg"), HasSubstr("allowed: attribute file of <scenario>"));
}

TEST_F(StudyFile, factors_that_are_none_are_refused) {
  const auto message = [&](const std::string& text) {
    return error("<study>" + scenario("plaza/plaza-low.sumocfg") + "\n" + text + "</study>");
  };
  const std::string factor = "2: <factor id=\"a\">";
  EXPECT_EQ(message("<factor/>"), "2: <factor> attribute id: is missing");
  EXPECT_EQ(message("<factor id='a'/>"),
            factor + ": has no level; allowed: attribute values, or <level>s");
  EXPECT_EQ(message("<factor id='a' parameter='sight' values=''/>"),
            factor + " attribute values: is empty");
  EXPECT_EQ(message("<factor id='a' parameter='sight' values=' '/>"),
            factor + ": has no level; allowed: attribute values, or <level>s");
  EXPECT_EQ(message("<factor id='a' values='1'/>"),
            factor +
                ": does not say what it sets; allowed: one of the attributes sumo, panel, "
                "parameter, zone, client");
  EXPECT_EQ(message("<factor id='a' sumo='scale' panel='number' values='1'/>"),
            factor +
                ": sets several things; allowed: one of the attributes sumo, panel, "
                "parameter, zone, client");
  EXPECT_EQ(message("<factor id='a' sumo='scale'><level name='x'/></factor>"),
            factor +
                " attribute sumo: 'scale' needs attribute values; allowed: values=\"...\" with "
                "it, or <level>s without it");
  EXPECT_EQ(message("<factor id='a' sumo='scale' values='1'><level name='x'/></factor>"),
            factor + " attribute values: '1' has levels, too; allowed: values or <level>s");
  EXPECT_EQ(message("<factor id='a' sumo='scale' values='1 2 1'/>"),
            factor + " attribute values: '1' names a level twice; allowed: each level once");
  EXPECT_EQ(message("<factor id='a'><level name='x'/><level name='x'/></factor>"),
            factor + ": 'x' names a level twice; allowed: each level once");
  EXPECT_EQ(message("<factor id='a'><level name='x y'/></factor>"),
            "2: <level> attribute name: 'x y' is no name; allowed: a name without spaces");
  EXPECT_EQ(message("<factor id='a'><level name='x'/></factor><factor id='a'>"
                    "<level name='x'/></factor>"),
            "2: <factor> attribute id: 'a' is used twice; allowed: a new id");
  EXPECT_EQ(
      message("<factor id='a' sumo='scale' values='1'/>\n<factor id='b'><level name='x'>"
              "<set sumo='scale' value='3'/></level></factor>"),
      "3: <factor id=\"b\"> attribute sumo: 'scale' is set by factor a, too; allowed: each by "
      "one factor");
  EXPECT_EQ(message("<factor id='a'><level name='x'><set sumo='scale' value='3'/>\n"
                    "<set sumo='scale' value='2' scenario='plaza-low'/></level></factor>"),
            "3: <set> attribute sumo: 'scale' is set twice; allowed: each at most once in a level");
  EXPECT_EQ(message("<factor id='a'><level name='x'><set sumo='scale' value='3' scenario='p'/>"
                    "</level></factor>"),
            "2: <set> attribute scenario: 'p' is no scenario; allowed: plaza-low");
}

TEST_F(StudyFile, settings_that_mean_nothing_are_refused) {
  const auto message = [&](const std::string& key, const std::string& value) {
    return error("<study>" + scenario("plaza/plaza-low.sumocfg") + "\n<factor id='a' " + key +
                 " values='" + value + "'/></study>");
  };
  const std::string factor = "2: <factor id=\"a\"> attribute ";
  EXPECT_THAT(
      message("parameter='sigt'", "5"),
      StartsWith(factor + "parameter: 'sigt' is no parameter; allowed: sight, fieldOfView"));
  EXPECT_EQ(message("parameter='sight'", "5 500"),
            factor + "values: '500' is out of range; allowed: 1 to 50");
  EXPECT_EQ(message("parameter='sight'", "far"),
            factor + "values: 'far' is not a number; allowed: 1 to 50");
  EXPECT_THAT(
      message("panel='nmber'", "5"),
      StartsWith(factor + "panel: 'nmber' is no attribute of <pedestrians>; allowed: id, "));
  EXPECT_EQ(message("panel='number'", "-5"),
            "2: <pedestrians> attribute number: '-5' is out of range; allowed: 1 to 1000000");
  EXPECT_EQ(message("panel='speedMin'", "1"),
            "2: <pedestrians> attribute number: is missing; allowed: number or perHour");
  EXPECT_EQ(message("zone='model'", "orca"),
            factor +
                "zone: 'model' is no attribute of <zone> that may vary; allowed: edges, "
                "edgeTypes, lanes, polygons, openSpace, weather");
  EXPECT_EQ(message("zone='openSpace'", "51"),
            factor + "values: '51' is out of range; allowed: 0 to 50");
  EXPECT_EQ(message("zone='weather'", "snow"),
            factor + "values: 'snow' is no weather; allowed: fair, rain, heat, ice");
  EXPECT_EQ(message("sumo='step-lenth'", "0.1"),
            factor + "sumo: 'step-lenth' is no option of SUMO; allowed: those of `sumo --help`");
  EXPECT_EQ(message("sumo='step-length'", "fast"),
            factor +
                "values: 'fast' is no value of SUMO's option step-length; allowed: seconds or "
                "h:m:s");
  EXPECT_EQ(message("sumo='seed'", "5"),
            factor +
                "sumo: 'seed' cannot be set by a study; allowed: attributes seeds, models and "
                "end of <study>");
}

TEST_F(StudyFile, combinations_that_are_none_are_refused) {
  const auto message = [&](const std::string& combinations) {
    return error("<study>" + scenario("plaza/plaza-low.sumocfg") +
                 "<factor id='a' sumo='scale' values='1 2'/><factor id='b'><level name='x'/>"
                 "</factor>\n" +
                 combinations + "</study>");
  };
  const std::string place = "2: <combination> attribute levels: ";
  EXPECT_EQ(message("<combination levels='1'/>"),
            place + "'1' does not name one level of each factor; allowed: a level of each of a, b");
  EXPECT_EQ(message("<combination levels='1 y'/>"),
            place + "'y' is no level of factor b; allowed: x");
  EXPECT_EQ(message("<combination levels='1 x'/><combination levels=' 1  x'/>"),
            place + "' 1  x' is given twice; allowed: each combination once");
  EXPECT_EQ(message("<combination/>"), place + "is missing");
}

TEST_F(StudyFile, too_many_runs_are_refused) {
  EXPECT_EQ(error("<study seeds='1-100000'>" + scenario("plaza/plaza-low.sumocfg") +
                  "<factor id='a' parameter='sight' values='1 2 3 4 5 6 7 8 9'/></study>"),
            "1: <study>: asks for too many runs; allowed: 1000000 in all: fewer seeds, models or "
            "levels");
}

}  // namespace
}  // namespace pedzone::study
