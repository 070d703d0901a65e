// The schema takes and refuses the same study files as the reader, where a schema can know.
#include <cstdlib>

#include "core/xml.hpp"
#include "study_scene.hpp"
#include "world/model_names.hpp"

namespace pedzone::study {
namespace {

class StudySchema : public StudyScene {
 protected:
  bool schema_takes(const std::string& text) const {
    const std::string file = write("schema.xml", text), log = folder_ + "/log.txt";
    const int code = std::system(
        ("xmllint --noout --schema '" PEDZONE_STUDY_XSD "' '" + file + "' > '" + log + "' 2>&1")
            .c_str());
    const std::string said = text_of(log);
    EXPECT_TRUE(said.ends_with(code == 0 ? " validates\n" : " fails to validate\n")) << said;
    return code == 0;
  }

  const std::string plaza_ = scenario("plaza/plaza-low.sumocfg", "id='plaza'");
  const std::string factor_ = "<factor id='a' sumo='scale' values='1 2'/>";
};

TEST_F(StudySchema, takes_what_the_reader_takes) {
  write("mine.so", "");
  for (const std::string& text :
       {"<study>" + plaza_ + "</study>", "<study seeds=' 1-3   7 '>" + plaza_ + "</study>",
        "<study xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' "
        "xsi:noNamespaceSchemaLocation='study.xsd' id='a' title='' question='?' end='1e3' "
        "timeLimit='60' models='striping ./mine.so orca' reference='./mine.so'>" +
            plaza_ + factor_ +
            "<factor id='b'><level name='x'/><level name='y'><set panel='number' value='3' "
            "scenario='plaza'/><set zone='weather' value='ice'/></level></factor>"
            "<combination levels='1 x'/><combination levels='2 y'/></study>",
        "<study models='heuristic'>" +
            scenario("plaza/plaza-low.sumocfg", "client='drive {port} {folder}'") +
            "<factor id='a' client='--range' values='5 10'/></study>"}) {
    EXPECT_EQ(error(text), "no error") << text;
    EXPECT_TRUE(schema_takes(text)) << text;
  }
}

TEST_F(StudySchema, refuses_what_the_reader_refuses) {
  const std::string open = "<study>" + plaza_;
  for (const std::string& text :
       {std::string("<study/>"),
        std::string("<zones/>"),
        "<study seed='1'>" + plaza_ + "</study>",
        "<study seeds=''>" + plaza_ + "</study>",
        "<study seeds='1-'>" + plaza_ + "</study>",
        "<study seeds='a'>" + plaza_ + "</study>",
        "<study models=''>" + plaza_ + "</study>",
        "<study models='strping'>" + plaza_ + "</study>",
        "<study end='0'>" + plaza_ + "</study>",
        "<study timeLimit='no'>" + plaza_ + "</study>",
        open + "<scenario/></study>",
        open + plaza_ + "</study>",
        open + "<factor sumo='scale' values='1'/></study>",
        open + "<factor id='a' sumo='scale' values=' '/></study>",
        open + "<factor id='a' zone='model' values='orca'/></study>",
        "<study models='heuristic'>" + scenario("plaza/plaza-low.sumocfg", "client=''") +
            "</study>",
        open + "<factor id='a'><level/></factor></study>",
        open + "<factor id='a'><level name='x y'/></factor></study>",
        open + "<factor id='a'><level name='x'><set sumo='scale'/></level></factor></study>",
        open + factor_ + factor_ + "</study>",
        open + factor_ + "<combination/></study>",
        open + factor_ + "<combination levels='1'/><combination levels='1'/></study>",
        open + "<other/></study>"}) {
    EXPECT_NE(error(text), "no error") << text;
    EXPECT_FALSE(schema_takes(text)) << text;
  }
}

TEST_F(StudySchema, lists_the_reader_s_models) {
  pugi::xml_document schema;
  ASSERT_TRUE(schema.load_file(PEDZONE_STUDY_XSD));
  std::vector<std::string> models;
  for (const auto& found :
       schema.select_nodes("//xsd:simpleType[@name='pedzoneModelType']//xsd:enumeration/@value")) {
    models.push_back(found.attribute().value());
  }
  EXPECT_THAT(models, ::testing::ElementsAreArray(kModelNames));
}

}  // namespace
}  // namespace pedzone::study
