#include "study/report/busy_window.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace pedzone::study {
namespace {

/// A series of so many rows of 10 s.
std::string series(const std::string& name, int rows, const std::function<double(int)>& persons) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto path =
      std::filesystem::path(testing::TempDir()) / fmt::format("{}-{}.csv", test->name(), name);
  std::ofstream file(path);
  file << "time,persons,personSpeed,density,vehicles,vehicleSpeed\n";
  for (int row = 0; row < rows; ++row) {
    file << fmt::format("{},{:.4f},1.2,,0.0000,\n", 10 * row, persons(row));
  }
  return path.string();
}

TEST(busiest_window, is_where_most_people_are_in_all_runs_together) {
  // The first is fullest early, the second, which has more, from 400 s to 700 s.
  const auto window = busiest_window(
      {series("a", 100, [](int row) { return row < 30 ? 10.0 : 0.0; }),
       series("b", 100, [](int row) { return row >= 40 && row < 70 ? 20.0 : 1.0; })});
  ASSERT_TRUE(window);
  EXPECT_EQ(window->begin, 400.0);
  EXPECT_EQ(window->end, 700.0);
}

TEST(busiest_window, is_shorter_where_people_are_many) {
  // 1,500 persons: 75 s hold 112,500 person-seconds, 37.5 s 56,250.
  const auto window = busiest_window({series("a", 100, [](int) { return 1500.0; })});
  ASSERT_TRUE(window);
  EXPECT_DOUBLE_EQ(window->end - window->begin, 37.5);
}

TEST(busiest_window, of_a_short_run_begins_with_it) {
  const auto window = busiest_window({series("a", 5, [](int row) { return row; })});
  ASSERT_TRUE(window);
  EXPECT_EQ(window->begin, 0.0);
  EXPECT_EQ(window->end, 50.0) << "and ends with it";
}

TEST(busiest_window, is_none_where_nobody_is_or_a_file_is_missing) {
  EXPECT_FALSE(busiest_window({series("a", 20, [](int) { return 0.0; })}));
  EXPECT_FALSE(busiest_window({series("b", 20, [](int) { return 1.0; }), "missing.csv"}));
}

}  // namespace
}  // namespace pedzone::study
