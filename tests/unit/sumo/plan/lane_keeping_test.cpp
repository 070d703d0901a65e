// Vehicles that would change lanes onto people.
#include "sumo/plan/lane_keeping.hpp"

#include <gmock/gmock.h>

#include "four_edges.hpp"

namespace pedzone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// e0 leads into `wide`, with lanes at y = 0 and y = 4 [m] from x = 50 to 100 [m].
class LaneKeepingTest : public testing::Test, protected test::FourEdges {
 protected:
  LaneKeepingTest() {
    wide_ = add_edge("wide", "B", "C", 50, 100, 2);
    right_ = network.edges[wide_].lanes[0];
    left_ = network.edges[wide_].lanes[1];
    connect(lane_of(e0), right_);
    fleet_.emplace(network, zones_);
  }

  VehicleSeen car(int lane, const Vec2& front, double speed) const {
    VehicleSeen seen = test::seen_vehicle("car", front, speed);
    seen.traits.decel = 5.0;
    seen.traits.accel = 2.0;
    seen.lane = lane;
    seen.route = lane == left_ || lane == right_ ? std::span(route_).subspan(1) : std::span(route_);
    return seen;
  }

  std::vector<SpeedOrder> step(std::vector<VehicleSeen> seen, std::vector<PersonAhead> people,
                               double dt = 1.0) {
    fleet_->update(std::move(seen), dt);
    return keeping_.plan(*fleet_, PeopleNear(people), dt);
  }
  static PersonAhead at(double x, double y) { return {{x, y}, {0.0, 0.0}, 0.24}; }

  const std::vector<Zone> zones_{zone};
  int wide_ = 0, right_ = 0, left_ = 0;
  std::vector<int> route_{e0, 4};
  std::optional<Fleet> fleet_;
  LaneKeeping keeping_{zones_};
  const SpeedOrder keeps_{"car", LaneChanges::kNone}, free_{"car", LaneChanges::kOwn};
};

TEST_F(LaneKeepingTest, keeps_its_lane_as_long_as_somebody_is_ahead_on_the_one_beside) {
  EXPECT_THAT(step({car(left_, {60, 4}, 5.0)}, {at(66, 0)}), ElementsAre(keeps_));
  EXPECT_THAT(step({car(left_, {61, 4}, 5.0)}, {at(67, 0)}), IsEmpty()) << "it has been told";
  EXPECT_THAT(step({car(left_, {62, 4}, 5.0)}, {}), ElementsAre(free_));
  EXPECT_THAT(step({car(left_, {63, 4}, 5.0)}, {}), IsEmpty());
  EXPECT_THAT(step({car(right_, {60, 0}, 5.0)}, {at(66, 4)}), ElementsAre(keeps_))
      << "to the left, too";
}

TEST_F(LaneKeepingTest, does_not_for_people_whom_it_would_not_be_put_onto) {
  const VehicleSeen seen = car(left_, {60, 4}, 5.0);
  EXPECT_THAT(step({seen}, {at(66, 4)}), IsEmpty()) << "on its own lane: it stops for them";
  EXPECT_THAT(step({seen}, {at(66, -2)}), IsEmpty()) << "beside the road";
  // 7 m in the step, and 2.5 m to stop.
  EXPECT_THAT(step({seen}, {at(70.5, 0)}), IsEmpty()) << "it could stop for them";
  EXPECT_THAT(step({seen}, {at(69.5, 0)}), ElementsAre(keeps_));
}

TEST_F(LaneKeepingTest, keeps_its_lane_beside_people_who_cross_and_wait_between_the_lanes) {
  const VehicleSeen seen = car(left_, {60, 4}, 5.0);
  PersonAhead waits = at(62, 2.0);  // 0.86 m from where its body would be
  EXPECT_THAT(step({seen}, {waits}), IsEmpty());
  waits.crosses = true;
  EXPECT_THAT(step({seen}, {waits}, 0.1), IsEmpty()) << "it steps out no farther in 0.1 s";
  EXPECT_THAT(step({seen}, {waits}), ElementsAre(keeps_));
}

TEST_F(LaneKeepingTest, who_changes_lanes_bit_by_bit_does_not_sweep_over_people_between_them) {
  const auto orders = [&](bool VehicleTraits::*how, const PersonAhead& person) {
    VehicleSeen seen = car(left_, {60, 4}, 5.0);
    if (how != nullptr) seen.traits.*how = true;
    fleet_->update({seen}, 1.0);
    return LaneKeeping(zones_).plan(*fleet_, PeopleNear(std::vector{person}), 1.0);
  };
  for (const PersonAhead& person : {at(66, 2.0), at(80, 0.0)}) {
    EXPECT_THAT(orders(nullptr, person), IsEmpty()) << "from one step to the next";
    EXPECT_THAT(orders(&VehicleTraits::drifts, person), ElementsAre(keeps_));
    EXPECT_THAT(orders(&VehicleTraits::sublanes, person), ElementsAre(keeps_));
  }
  EXPECT_THAT(orders(&VehicleTraits::drifts, at(66, -2.0)), IsEmpty()) << "beside the road";
  EXPECT_THAT(orders(&VehicleTraits::drifts, at(66, 5.5)), IsEmpty()) << "on its other side";
}

TEST_F(LaneKeepingTest, keeps_its_lane_beside_people_at_its_side_even_while_it_stands) {
  const VehicleSeen seen = car(left_, {60, 4}, 0.0);
  EXPECT_THAT(step({seen}, {at(56.5, 0)}), ElementsAre(keeps_)) << "where its rear would be";
  EXPECT_THAT(step({seen}, {at(54.4, 0)}), ElementsAre(free_));
  PersonAhead comes = at(54.4, 0);
  comes.velocity = {1.5, 0.0};
  EXPECT_THAT(step({seen}, {comes}), ElementsAre(keeps_)) << "will be there after the step";
}

TEST_F(LaneKeepingTest, looks_at_the_lanes_that_it_comes_to_within_the_step) {
  const VehicleSeen seen = car(lane_of(e0), {45, 0}, 5.0);
  EXPECT_THAT(step({seen}, {at(53, 4)}, 1.0), ElementsAre(keeps_));
  EXPECT_THAT(step({seen}, {at(53, 4)}, 0.1), ElementsAre(free_)) << "0.5 m in the step";
}

TEST_F(LaneKeepingTest, looks_at_lanes_inside_junctions_too) {
  network.edges[wide_].function = EdgeFunction::kInternal;
  EXPECT_THAT(step({car(left_, {60, 4}, 5.0)}, {at(66, 0)}), ElementsAre(keeps_));
}

TEST_F(LaneKeepingTest, does_not_count_lanes_that_no_vehicle_may_use) {
  network.lanes[right_].vehicles = false;
  EXPECT_THAT(step({car(left_, {60, 4}, 5.0)}, {at(66, 0)}), IsEmpty());
}

TEST_F(LaneKeepingTest, does_not_overtake_on_the_lane_for_the_other_direction_where_somebody_is) {
  const int back = add_edge("back", "C", "B", 100, 50);
  network.lanes[lane_of(back)].shape = {{100.0, 8.0}, {50.0, 8.0}};
  EXPECT_THAT(step({car(left_, {60, 4}, 5.0)}, {at(66, 8)}), IsEmpty()) << "nobody overtakes there";
  network.lanes[left_].opposite = lane_of(back);
  EXPECT_THAT(step({car(left_, {60, 4}, 5.0)}, {at(66, 8)}), ElementsAre(keeps_));
  EXPECT_THAT(step({car(left_, {60, 4}, 5.0)}, {at(50, 8)}), ElementsAre(free_)) << "behind it";
  VehicleSeen overtaking = car(left_, {60, 8}, 5.0);
  overtaking.overtakes = true;
  overtaking.lateral = 4.0;
  EXPECT_THAT(step({overtaking}, {at(66, 4)}), IsEmpty()) << "it has to come back";
}

TEST_F(LaneKeepingTest, tells_those_only_that_give_way_and_drive_by_themselves) {
  for (const int kind : {0, 1, 2}) {
    VehicleSeen seen = car(left_, {60, 4}, 5.0);
    if (kind == 0) seen.traits.yields = false;
    if (kind == 1) seen.traits.external = true;
    if (kind == 2) seen.stopped = true;
    EXPECT_THAT(step({seen}, {at(66, 0)}), IsEmpty()) << kind;
  }
}

TEST_F(LaneKeepingTest, one_that_has_left_the_fleet_may_change_lanes_again) {
  step({car(left_, {60, 4}, 5.0)}, {at(66, 0)});
  EXPECT_THAT(step({}, {at(66, 0)}), ElementsAre(free_));
  EXPECT_THAT(step({}, {}), IsEmpty());
}

}  // namespace
}  // namespace pedzone
