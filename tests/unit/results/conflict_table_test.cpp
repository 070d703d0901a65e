#include "results/conflict_table.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "results/conflict_writer.hpp"

namespace pedzone {
namespace {

using testing::HasSubstr;

std::string table() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return (std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".csv"))
      .string();
}

std::vector<Conflict> written_and_read(const std::vector<Conflict>& conflicts) {
  ConflictWriter writer({"", "", table(), "--conflict-csv"});
  for (const Conflict& conflict : conflicts) writer.write(conflict);
  writer.finish();
  std::vector<Conflict> result;
  conflict_table().visit(
      table(), [&](const Conflict& conflict, const CsvRow&) { result.push_back(conflict); });
  return result;
}

Conflict everything() {
  Conflict one;
  one.person = "a \"quoted\", broken\nid";
  one.vehicle = "</script>";
  one.begin = 1.5;
  one.end = 9.25;
  one.type = EncounterType::kCrossingLeft;
  one.first = First::kVehicle;
  one.aware = false;
  one.ttc = Extreme{0.25, 3.5, {-1.25, 1e5}, EncounterType::kHeadOn, 1.5, 4.0, 5.5};
  one.drac = Extreme{7.5e14, 3.25, {1, 2}, EncounterType::kParked, 1, 2, 3};
  one.pet = Extreme{0, 4, {3, 4}, EncounterType::kFollowing, 1, 2, 3};
  one.clearance = Extreme{-0.5, 5, {5, 6}, EncounterType::kFromBehind, 1, 2, 3};
  one.contact = Extreme{0.75, 6, {7, 8}, EncounterType::kCrossingRight, 1, 2, 3};
  one.detection = Reaction{2.5, 2};
  one.braking = Reaction{1.5, 2.75};
  return one;
}

void expect_same(const std::optional<Extreme>& a, const std::optional<Extreme>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(
      std::tie(a->value, a->time, a->type, a->person_speed, a->vehicle_speed, a->relative_speed),
      std::tie(b->value, b->time, b->type, b->person_speed, b->vehicle_speed, b->relative_speed));
  EXPECT_EQ(a->position, b->position);
}

TEST(conflict_table, gives_back_what_was_written) {
  const Conflict whole = everything();
  const std::vector<Conflict> read = written_and_read({whole});
  ASSERT_EQ(read.size(), 1U);
  const Conflict& one = read.front();
  EXPECT_EQ(std::tie(one.person, one.vehicle, one.begin, one.end, one.type, one.first, one.aware),
            std::tie(whole.person, whole.vehicle, whole.begin, whole.end, whole.type, whole.first,
                     whole.aware));
  expect_same(one.ttc, whole.ttc);
  expect_same(one.drac, whole.drac);
  expect_same(one.pet, whole.pet);
  expect_same(one.clearance, whole.clearance);
  expect_same(one.contact, whole.contact);
  ASSERT_TRUE(one.detection && one.braking);
  EXPECT_EQ(one.detection->value, 2.5);
  EXPECT_EQ(one.braking->time, 2.75);
}

TEST(conflict_table, gives_nothing_where_there_was_none) {
  Conflict bare;
  bare.person = "p";
  bare.vehicle = "v";
  const std::vector<Conflict> read = written_and_read({bare, everything()});
  ASSERT_EQ(read.size(), 2U);
  EXPECT_FALSE(read[0].ttc || read[0].drac || read[0].pet || read[0].clearance || read[0].contact ||
               read[0].detection || read[0].braking || read[0].aware);
  EXPECT_TRUE(read[1].contact);
}

TEST(conflict_table, names_what_is_wrong_in_it) {
  (void)written_and_read({everything()});
  std::ifstream input(table());
  std::string text{std::istreambuf_iterator<char>(input), {}};
  const std::size_t word = text.find("headOn");
  ASSERT_NE(word, std::string::npos);
  std::ofstream(table()) << text.replace(word, 6, "beside");
  try {
    conflict_table().visit(table(), [](const Conflict&, const CsvRow&) {});
    FAIL() << "was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("minTTC_type"));
    EXPECT_THAT(error.what(), HasSubstr("beside"));
    EXPECT_THAT(error.what(), HasSubstr("headOn, fromBehind"));
  }
}

}  // namespace
}  // namespace pedzone
