// What is taken back from vehicles when pedzone leaves.
#include "sumo/plan/told.hpp"

#include <gmock/gmock.h>

namespace pedzone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Told, is_taken_back_from_vehicles_that_go_by_it) {
  Told told;
  told.note(std::vector<SpeedOrder>{{"van", SpeedMode::kPass},
                                    {"van", 0.4},
                                    {"car", LaneChanges::kNone},
                                    {"bus", 0.0},
                                    {"bus", kOwnSpeed}});
  EXPECT_THAT(told.take_back({"van", "tram", "car", "bus"}),
              ElementsAre(SpeedOrder{"car", LaneChanges::kOwn}, SpeedOrder{"van", SpeedMode::kOwn},
                          SpeedOrder{"van", kOwnSpeed}));
}

TEST(Told, is_not_taken_back_twice_or_from_vehicles_that_have_gone) {
  Told told;
  told.note(std::vector<SpeedOrder>{{"van", 0.0}, {"car", LaneChanges::kNone}});
  told.note(std::vector<SpeedOrder>{{"car", LaneChanges::kOwn}});
  EXPECT_THAT(told.take_back({"car"}), IsEmpty());
}

TEST(Told, does_not_hold_for_the_next_vehicle_of_that_id) {
  Told told;
  told.note(std::vector<SpeedOrder>{{"van", 0.0}, {"car", 1.0}});
  told.forget("van");
  EXPECT_FALSE(told.speed("van"));
  EXPECT_EQ(told.speed("car"), 1.0);
}

}  // namespace
}  // namespace pedzone
