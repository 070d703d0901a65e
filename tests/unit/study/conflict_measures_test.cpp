#include "study/measure/conflict_measures.hpp"

#include <gmock/gmock.h>

#include "study/measure/vehicle_stops.hpp"

namespace pedzone::study {
namespace {

Conflict conflict(EncounterType type, double ttc, double clearance) {
  Conflict result;
  result.type = type;
  result.ttc = Extreme{.value = ttc, .vehicle_speed = 3.0};
  result.clearance = Extreme{.value = clearance};
  return result;
}

Conflict contact(double vehicle_speed) {
  Conflict touched = conflict(EncounterType::kFollowing, 2.0, -0.2);
  touched.begin = -1.0;
  touched.contact = Extreme{.value = 1.0, .vehicle_speed = vehicle_speed};
  return touched;
}

TEST(ConflictMeasures, are_counts_medians_and_the_least_clearance) {
  ConflictMeasures measures;
  measures.add(conflict(EncounterType::kCrossingLeft, 1.0, 0.5));
  measures.add(conflict(EncounterType::kCrossingRight, 2.0, 0.3));
  Conflict close = conflict(EncounterType::kHeadOn, 3.0, 0.9);
  close.pet = Extreme{.value = 0.8};
  close.drac = Extreme{.value = 2.5};
  measures.add(close);
  std::map<std::string, double> values;
  measures.finish(values);
  EXPECT_EQ(values["conflict.count"], 3.0);
  EXPECT_EQ(values["conflict.serious"], 2.0) << "a TTC of 1 s and a PET of 0.8 s";
  EXPECT_EQ(values["conflict.contacts"], 0.0);
  EXPECT_EQ(values["conflict.crossing"], 2.0);
  EXPECT_EQ(values["conflict.headOn"], 1.0);
  EXPECT_EQ(values["conflict.standing"], 0.0);
  EXPECT_EQ(values["conflict.ttc"], 2.0);
  EXPECT_EQ(values["conflict.pet"], 0.8);
  EXPECT_EQ(values["conflict.drac"], 2.5);
  EXPECT_EQ(values["conflict.clearance"], 0.3);
}

TEST(ConflictMeasures, a_contact_is_serious_and_leaves_no_clearance) {
  ConflictMeasures measures;
  measures.add(contact(0.51));
  std::map<std::string, double> values;
  measures.finish(values);
  EXPECT_EQ(values["conflict.serious"], 1.0);
  EXPECT_EQ(values["conflict.contacts"], 1.0);
  EXPECT_EQ(values["conflict.clearance"], 0.0);
}

TEST(ConflictMeasures, count_standing_vehicles_apart) {
  ConflictMeasures measures;
  measures.add(contact(0.5));
  Conflict close = conflict(EncounterType::kParked, 2.0, 0.1);
  close.ttc->vehicle_speed = 0.0;
  measures.add(close);
  std::map<std::string, double> values;
  measures.finish(values);
  EXPECT_EQ(values["conflict.standing"], 2.0);
  EXPECT_EQ(values["conflict.seriousStanding"], 1.0);
  EXPECT_EQ(values["conflict.contactsStanding"], 1.0);
  for (const char* key : {"count", "serious", "contacts", "following"}) {
    EXPECT_EQ(values[std::string("conflict.") + key], 0.0) << key;
  }
  EXPECT_FALSE(values.contains("conflict.clearance"));
}

TEST(ConflictMeasures, count_insertions_nowhere_else) {
  ConflictMeasures measures;
  Conflict put = contact(3.0);
  put.begin = put.contact->time;
  measures.add(put);
  std::map<std::string, double> values;
  measures.finish(values);
  EXPECT_EQ(values["conflict.insertions"], 1.0);
  EXPECT_EQ(values["conflict.count"], 0.0);
  EXPECT_EQ(values["conflict.standing"], 0.0);
}

TEST(ConflictMeasures, without_conflicts_there_are_counts_only) {
  std::map<std::string, double> values;
  ConflictMeasures().finish(values);
  EXPECT_EQ(values.size(), 11U);
  for (const auto& [key, value] : values) EXPECT_EQ(value, 0.0) << key;
}

TEST(VehicleStops, creeping_is_no_stop_and_neither_is_the_start) {
  VehicleStops stops;
  const auto drive = [&stops](std::initializer_list<double> speeds) {
    for (const double speed : speeds) {
      const VehicleSample vehicle{.id = "v", .velocity = {0.0, speed}};
      stops.step(std::span(&vehicle, 1));
    }
    return stops.count();
  };
  EXPECT_EQ(drive({0.0, 0.5, 1.5, 3.0}), 0U) << "it starts from a stand";
  EXPECT_EQ(drive({1.0, 0.05, 0.0}), 1U);
  EXPECT_EQ(drive({0.3, 0.0, 0.9, 0.0}), 1U) << "it has not been under way since";
  EXPECT_EQ(drive({1.1, 0.09}), 2U);
}

}  // namespace
}  // namespace pedzone::study
