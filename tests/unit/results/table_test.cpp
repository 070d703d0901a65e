// Tables: what was written is read back, and the README says what is in them.
#include "results/table.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "results/crossing_table.hpp"
#include "results/run_tables.hpp"
#include "results/trajectories.hpp"

namespace pedzone {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string file_with(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto path =
      std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".csv");
  std::ofstream(path) << text;
  return path.string();
}

TEST(Table, gives_trajectories_back_as_they_were_written) {
  const std::string path =
      (std::filesystem::path(testing::TempDir()) / "trajectories-written.csv").string();
  const std::string id = "a \"quoted\",\nbroken <id>";
  PersonView person{};
  person.position = {1.25, -2.5};
  person.velocity = {0.5, -0.75};
  person.heading = -1.5;
  person.motion = Motion::kWaiting;
  person.activity = Activity::kTexting;
  TrajectoryWriter writer(path, "--trajectories");
  writer.row(12.25, id, person);
  writer.finish();
  int rows = 0;
  trajectory_table().visit(path, [&](const TrajectoryRow& row, const CsvRow&) {
    ++rows;
    EXPECT_EQ(row.time, 12.25);
    EXPECT_EQ(row.id, id);
    EXPECT_EQ(Vec2(row.x, row.y), person.position);
    EXPECT_EQ(Vec2(row.vx, row.vy), person.velocity);
    EXPECT_EQ(row.heading, person.heading);
    EXPECT_EQ(row.motion, person.motion);
    EXPECT_EQ(row.activity, person.activity);
  });
  EXPECT_EQ(rows, 1);
}

TEST(Table, leaves_fields_empty_where_there_is_no_number_and_reads_none_there) {
  std::string text = series_table().header();
  series_table().append(text, {20.0, 1.5, std::nullopt, std::nullopt, 0.0, 3.25});
  EXPECT_THAT(text, HasSubstr("\n20,1.5000,,,0.0000,3.2500\n"));
  series_table().visit(file_with(text), [&](const SeriesRow& row, const CsvRow&) {
    EXPECT_EQ(row.time, 20.0);
    EXPECT_EQ(row.persons, 1.5);
    EXPECT_EQ(row.person_speed, std::nullopt);
    EXPECT_EQ(row.density, std::nullopt);
    EXPECT_EQ(row.vehicles, 0.0);
    EXPECT_EQ(row.vehicle_speed, 3.25);
  });
}

TEST(Table, gives_crossings_back_as_they_were_written) {
  const SeenCrossing one{.person = "a,\"b\"",
                         .between = true,
                         .begin = 3.5,
                         .end = 12.25,
                         .waited = 2.0,
                         .let_pass = {1.5, 3.0},
                         .near_conflicts = 2.0,
                         .far_conflicts = 1.0};
  std::string text = seen_crossing_table().header();
  seen_crossing_table().append(text, one);
  int rows = 0;
  seen_crossing_table().visit(file_with(text), [&](const SeenCrossing& row, const CsvRow&) {
    ++rows;
    EXPECT_EQ(row.person, one.person);
    EXPECT_TRUE(row.between);
    EXPECT_EQ(row.begin, one.begin);
    EXPECT_EQ(row.end, one.end);
    EXPECT_EQ(row.waited, one.waited);
    EXPECT_EQ(row.gap, std::nullopt);
    EXPECT_EQ(row.let_pass, one.let_pass);
    EXPECT_EQ(row.near_conflicts, one.near_conflicts);
    EXPECT_EQ(row.far_conflicts, one.far_conflicts);
  });
  EXPECT_EQ(rows, 1);
}

TEST(Table, names_file_line_and_column_of_what_a_column_does_not_hold) {
  const std::string path = file_with(density_table().header() + "0,2,1\n0,2,-1\n");
  try {
    density_table().visit(path, [](const DensityRow&, const CsvRow&) {});
    FAIL() << "was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(path + ":3"));
    EXPECT_THAT(error.what(), HasSubstr("column personSeconds"));
  }
}

TEST(Table, has_the_columns_that_others_read) {
  EXPECT_THAT(density_table().names(), ElementsAre("x", "y", "personSeconds"));
  EXPECT_EQ(trajectory_table().header(), "time,id,x,y,vx,vy,heading,motion,activity\n");
  EXPECT_EQ(series_table().header(), "time,persons,personSpeed,density,vehicles,vehicleSpeed\n");
}

TEST(Table, is_described_in_the_readme) {
  std::stringstream readme;
  readme << std::ifstream(PEDZONE_RESULTS_README).rdbuf();
  EXPECT_THAT(readme.str(), HasSubstr("\n\n" + described(trajectory_table().infos()) + "\n"));
  EXPECT_THAT(readme.str(), HasSubstr("\n\n" + described(series_table().infos()) + "\n"));
  EXPECT_THAT(readme.str(), HasSubstr("\n\n" + described(density_table().infos()) + "\n"));
  EXPECT_THAT(readme.str(), HasSubstr("\n\n" + described(seen_crossing_table().infos()) + "\n"));
}

}  // namespace
}  // namespace pedzone
