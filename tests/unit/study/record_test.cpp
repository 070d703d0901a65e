#include "study/run/record.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "core/error.hpp"

namespace pedzone::study {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::string file_with(const std::string& text) {
  const std::string file = testing::TempDir() + "/" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".json";
  std::ofstream(file) << text;
  return file;
}

RunRecord some_record() {
  RunRecord record;
  record.id = "plaza.striping.1";
  record.status = RunStatus::kFailed;
  record.failure = "sumo ended with exit code 1\nError: \"</script>\" {} %s";
  record.definition = {{"model", "striping"}, {"seed", 1}};
  record.inputs = {{"/a b/c'd.xml", "00ff"}};
  record.versions = {{"pedzone", "0.1.0"}};
  record.commands = {{"sumo", "-c", "/a b/c'd.sumocfg"}};
  record.measures = {{"person.delay", 0.1}, {"person.speed", 1.0 / 3.0}};
  record.demand = {{"persons", "abc"}};
  record.attempts = 2;
  record.wall_s = 1.25;
  return record;
}

TEST(Record, is_read_as_it_was_written) {
  const RunRecord record = some_record();
  const RunRecord read = read_record(file_with(record_text(record)));
  EXPECT_EQ(read.id, record.id);
  EXPECT_EQ(read.status, record.status);
  EXPECT_EQ(read.failure, record.failure);
  EXPECT_EQ(read.definition, record.definition);
  EXPECT_EQ(read.inputs, record.inputs);
  EXPECT_EQ(read.versions, record.versions);
  EXPECT_EQ(read.commands, record.commands);
  EXPECT_EQ(read.measures, record.measures);  // to the bit
  EXPECT_EQ(read.demand, record.demand);
  EXPECT_EQ(read.attempts, record.attempts);
  EXPECT_EQ(read.wall_s, record.wall_s);
}

TEST(Record, leaves_out_numbers_that_json_does_not_have) {
  RunRecord record = some_record();
  record.measures = {{"a", std::nan("")}, {"b", INFINITY}, {"c", 1.0}};
  const RunRecord read = read_record(file_with(record_text(record)));
  EXPECT_THAT(read.measures, testing::ElementsAre(testing::Pair("c", 1.0)));
}

TEST(Record, takes_logs_that_are_no_text) {
  RunRecord record = some_record();
  record.failure = "died\n\xff\xfe\x80";
  EXPECT_THAT(read_record(file_with(record_text(record))).failure, HasSubstr("died"));
}

TEST(Record, of_another_format_is_refused) {
  auto json = nlohmann::json::parse(record_text(some_record()));
  json["format"] = kStudyFormat + 1;
  EXPECT_THAT([&] { read_record(file_with(json.dump())); },
              ThrowsMessage<InputError>(HasSubstr("of another format")));
}

TEST(Record, that_is_none_is_refused) {
  EXPECT_THROW(read_record(testing::TempDir() + "/nowhere.json"), InputError);
  const std::string text = record_text(some_record());
  for (const std::string& broken :
       {std::string(), std::string("{}"), text.substr(0, text.size() / 2), std::string("[1]")}) {
    EXPECT_THROW(read_record(file_with(broken)), InputError) << broken;
  }
  auto json = nlohmann::json::parse(text);
  json["status"] = "tired";
  EXPECT_THROW(read_record(file_with(json.dump())), InputError);
}

}  // namespace
}  // namespace pedzone::study
