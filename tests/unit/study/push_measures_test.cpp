// Pushes of a run, from the summary that pedzone writes.
#include "study/measure/push_measures.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"

namespace pedzone::study {
namespace {

class PushMeasures : public testing::Test {
 protected:
  PushMeasures() { std::filesystem::create_directories(folder_); }
  ~PushMeasures() override { std::filesystem::remove_all(folder_); }

  std::map<std::string, double> measure() const {
    std::map<std::string, double> values;
    measure_pushes(folder_, values);
    return values;
  }
  void write(const std::string& text) const { std::ofstream(folder_ + "/summary.json") << text; }

  const std::string folder_ = testing::TempDir() + "pedzone_pushes_" +
                              testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(PushMeasures, are_those_of_the_summary) {
  write(R"({"pushes": {"persons": 7, "longest_m": 1.5, "fastest_mps": 2.5},
            "run_into": [{"time": 1}, {"time": 2}], "jams": []})");
  const std::map<std::string, double> expected{{"conflict.pushed", 7.0},
                                               {"conflict.pushWay", 1.5},
                                               {"conflict.pushSpeed", 2.5},
                                               {"conflict.runInto", 2.0}};
  EXPECT_EQ(measure(), expected);
}

TEST_F(PushMeasures, are_zero_where_sumo_walks_everybody) {
  for (const auto& [key, value] : measure()) EXPECT_EQ(value, 0.0) << key;
  EXPECT_EQ(measure().size(), 4u);
}

TEST_F(PushMeasures, refuse_a_damaged_summary) {
  for (const char* text : {"", "{", "[]", R"({"pushes": {"persons": 7}})", R"({"pushes": 3})",
                           R"({"pushes": {"persons": 1, "longest_m": 1, "fastest_mps": 1}})"}) {
    write(text);
    EXPECT_THROW(measure(), InputError) << text;
  }
}

}  // namespace
}  // namespace pedzone::study
