#include "study/report/encounter_choice.hpp"

#include <gmock/gmock.h>

namespace pedzone::study {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kApart = 10.0;  // [m]

Extreme extreme(double value, const Vec2& at, EncounterType type = EncounterType::kCrossingLeft) {
  Extreme result;
  result.value = value;
  result.position = at;
  result.type = type;
  result.vehicle_speed = type == EncounterType::kParked ? 0.0 : 3.0;
  result.closing_speed = 2.0;
  return result;
}

Conflict between(const std::string& person, const std::string& vehicle) {
  Conflict conflict;
  conflict.person = person;
  conflict.vehicle = vehicle;
  conflict.begin = -1.0;  // [s] before any extreme
  return conflict;
}

/// Pairs of their own, far apart.
class EncounterChoices : public testing::Test {
 protected:
  Conflict next() {
    ++number_;
    return between("p" + std::to_string(number_), "v" + std::to_string(number_));
  }
  Vec2 place() const { return {100.0 * number_, 0.0}; }

  void add(const Conflict& conflict, std::size_t scenario = 0, std::size_t run = 0) {
    choice_.add(scenario, {run, rows_++}, conflict);
  }
  void add_contact(double speed, EncounterType type = EncounterType::kCrossingLeft) {
    Conflict conflict = next();
    conflict.contact = extreme(9.0, place(), type);
    conflict.contact->closing_speed = speed;
    conflict.ttc = extreme(0.0, place(), type);
    conflict.clearance = extreme(-0.1, place(), type);
    add(conflict);
  }
  void add_ttc(double seconds, EncounterType type = EncounterType::kCrossingLeft) {
    Conflict conflict = next();
    conflict.ttc = extreme(seconds, place(), type);
    conflict.pet = extreme(0.0, place(), type);
    add(conflict);
  }
  void add_pet(double seconds) {
    Conflict conflict = next();
    conflict.pet = extreme(seconds, place());
    add(conflict);
  }
  std::vector<std::size_t> rows(std::size_t most) const {
    std::vector<std::size_t> result;
    for (const auto& place : choice_.most_dangerous(most, kApart)) result.push_back(place.row);
    return result;
  }

  EncounterChoice choice_;
  int number_ = 0;
  std::size_t rows_ = 0;
};

TEST_F(EncounterChoices, are_empty_where_nobody_met) { EXPECT_THAT(rows(3), IsEmpty()); }

TEST_F(EncounterChoices, take_last_who_was_put_onto_another) {
  Conflict put = next();
  put.contact = extreme(9.0, place());
  put.begin = put.contact->time;
  add(put);                               // 0
  add_ttc(0.01, EncounterType::kParked);  // 1
  add_contact(0.5);                       // 2
  EXPECT_THAT(rows(10), ElementsAre(2, 1, 0));
}

TEST_F(EncounterChoices, take_contacts_first_then_ttc_then_pet) {
  add_pet(0.1);                              // 0
  add_ttc(1.0);                              // 1
  add_contact(0.5);                          // 2
  add_ttc(0.5);                              // 3
  add_contact(2.0);                          // 4: the harder one
  add_contact(3.0, EncounterType::kParked);  // 5: a vehicle that stands endangers less
  add_ttc(0.01, EncounterType::kParked);     // 6
  EXPECT_THAT(rows(10), ElementsAre(4, 2, 3, 1, 0, 5, 6));
  EXPECT_THAT(rows(2), ElementsAre(4, 2));
  EXPECT_EQ(choice_.count(), 7U);
}

TEST_F(EncounterChoices, take_a_brush_and_a_slow_approach_after_what_was_just_avoided) {
  Conflict brush = next();
  brush.contact = extreme(9.0, place());
  brush.contact->closing_speed = 0.9;
  brush.clearance = extreme(-0.01, place());
  brush.ttc = extreme(0.0, place());
  brush.ttc->closing_speed = 0.9;
  add(brush);  // 0
  Conflict slow = next();
  slow.ttc = extreme(0.2, place());
  slow.ttc->closing_speed = 1.0;
  add(slow);         // 1
  add_ttc(1.4);      // 2
  add_contact(0.5);  // 3: deep
  Conflict fast = next();
  fast.contact = extreme(9.0, place());
  fast.contact->closing_speed = 1.1;
  fast.clearance = extreme(-0.02, place());
  add(fast);  // 4
  EXPECT_THAT(rows(10), ElementsAre(4, 3, 2, 0, 1));
}

TEST_F(EncounterChoices, are_of_other_people_other_vehicles_and_other_places) {
  const auto contact = [](const char* person, const char* vehicle, double speed, double x) {
    Conflict conflict = between(person, vehicle);
    conflict.contact = extreme(speed, {x, 0.0});
    conflict.contact->closing_speed = speed;
    return conflict;
  };
  add(contact("a", "v", 9.0, 0.0));          // 0
  add(contact("a", "v", 8.0, 500.0), 0, 1);  // 1: the pair again, with another seed
  add(contact("a", "w", 7.0, 100.0));        // 2: the person again
  add(contact("b", "v", 6.0, 100.0));        // 3: the vehicle again
  add(contact("c", "w", 5.0, 9.9));          // 4: the place again
  add(contact("c", "w", 4.0, 10.1));         // 5
  add(contact("a", "v", 3.0, 0.0), 1);       // 6: in another scenario
  EXPECT_THAT(rows(3), ElementsAre(0, 5, 6));
}

TEST_F(EncounterChoices, keep_the_order_of_equal_ones) {
  for (int i = 0; i < 5; ++i) add_contact(1.0);
  EXPECT_THAT(rows(3), ElementsAre(0, 1, 2));
}

TEST_F(EncounterChoices, know_the_run) {
  Conflict conflict = next();
  conflict.pet = extreme(0.5, place());
  add(conflict, 0, 41);
  ASSERT_THAT(choice_.most_dangerous(3, kApart), SizeIs(1));
  EXPECT_EQ(choice_.most_dangerous(3, kApart).front().run, 41U);
}

}  // namespace
}  // namespace pedzone::study
