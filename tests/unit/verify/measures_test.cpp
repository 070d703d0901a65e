#include "verify/measures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pedzone::verify {
namespace {

/// Passages every `gap` [s] of people who walk along +x over x = 0.
FlowLine passages(std::size_t people, double gap) {
  FlowLine line({0, 1}, {0, -1});
  for (std::size_t i = 0; i < people; ++i) {
    const double time = gap * static_cast<double>(i + 1);
    line.look(i, {-0.05, 0}, {0.05, 0}, time + kStep / 2.0);
  }
  return line;
}

TEST(FlowLine, counts_passages_by_time) {
  const FlowLine line = passages(51, 0.5);
  EXPECT_EQ(line.count(), 51U);
  EXPECT_NEAR(line.times().front(), 0.5, 1e-12);
  EXPECT_NEAR(line.flow(), 2.0, 1e-9);
  EXPECT_NEAR(line.flow(0.0, 1.0), 2.0, 1e-9);
}

TEST(FlowLine, counts_one_way_once_and_within_its_ends) {
  FlowLine line({0, 1}, {0, -1});
  line.look(0, {0.1, 0}, {-0.1, 0}, 1.0);  // backwards
  EXPECT_EQ(line.count(), 0U);
  line.look(0, {-0.1, 2}, {0.1, 2}, 2.0);  // beside
  EXPECT_EQ(line.count(), 0U);
  line.look(0, {-0.1, 0}, {0.1, 0}, 3.0);
  line.look(0, {-0.1, 0}, {0.1, 0}, 4.0);  // again
  EXPECT_THAT(line.times(), testing::ElementsAre(testing::DoubleNear(2.95, 1e-12)));
}

TEST(FlowLine, of_few_has_no_flow) { EXPECT_EQ(passages(2, 1.0).flow(), 0.0); }

TEST(BandIndex, is_one_in_lanes_and_nothing_where_all_are_mixed) {
  std::vector<LanePlace> lanes, mixed;
  for (int k = 0; k < 40; ++k) {
    const double across = 0.05 + 0.1 * k;
    lanes.push_back({across, across < 2.0 ? 1 : -1});
    mixed.push_back({0.25 + 0.5 * (k / 2 % 8), k % 2 == 0 ? 1 : -1});
  }
  EXPECT_DOUBLE_EQ(band_index(lanes, 0, 4), 1.0);
  EXPECT_DOUBLE_EQ(band_index(mixed, 0, 4), 0.0);
  EXPECT_EQ(lane_count(lanes, 0, 4), 2);
  EXPECT_EQ(lane_count(mixed, 0, 4), 0);
}

TEST(BandIndex, counts_people_and_not_bands) {
  // Three one way in one band, one and one in another: (3·1 + 2·0) / 5.
  const std::vector<LanePlace> people{{0.1, 1}, {0.2, 1}, {0.3, 1}, {0.7, 1}, {0.8, -1}};
  EXPECT_DOUBLE_EQ(band_index(people, 0, 1), 0.6);
}

TEST(LaneCount, empty_bands_part_no_lanes) {
  const std::vector<LanePlace> people{{0.1, 1}, {1.6, 1}, {2.6, -1}, {3.6, 1}};
  EXPECT_EQ(lane_count(people, 0, 4), 3);
}

/// Five people one behind the other in a corridor of 20 m that they walk along for ever, by a model
/// that minds nobody.
struct Procession {
  Trial trial{repair(box(-Period::kBeyond, 0, 20 + Period::kBeyond, 2)),
              {"constant-velocity", 1},
              [](Zone& zone) { zone.parameters.heading_noise = 0.0; }};

  Procession() {
    trial.set_period({0, 20});
    for (int k = 0; k < 5; ++k) {
      trial.add({2.0 + 4.0 * k, 1}, line_at_x(20 + Period::kBeyond, 0, 2), 0, 1.0, 1.0);
    }
  }
};

TEST(Period, carries_people_on_with_their_speed) {
  Procession procession;
  procession.trial.walk(60.0);
  const Participant& participant = procession.trial.people().front();
  EXPECT_NEAR(participant.moved.x(), 60.0, 1e-6);
  EXPECT_NEAR(participant.at.x(), 2.0, 1e-6);
}

TEST(AreaMeasure, of_people_in_a_row_is_one_over_their_cell_and_their_speed) {
  Procession procession;
  AreaMeasure measure(box(0, 0, 20, 2), 1.0);
  procession.trial.walk(30.0, [&] {
    measure.look(procession.trial, [](const Participant&) { return Vec2(1.0, 0.0); });
  });
  // Four metres of a corridor 2 m wide, over the period's end, too.
  EXPECT_NEAR(measure.density(), 1.0 / 8.0, 1e-6);
  EXPECT_NEAR(measure.speed(), 1.0, 1e-6);
}

TEST(DensityMap, sums_up_to_the_people) {
  Procession procession;
  DensityMap map({0, 0}, {20, 2}, 0.5);
  procession.trial.walk(20.0, [&] { map.look(procession.trial); });
  const GridMap grid = map.grid();
  double people = 0.0;
  for (const double density : grid.values) people += density * grid.cell * grid.cell;
  EXPECT_EQ(grid.values.size(), grid.columns * grid.rows);
  EXPECT_NEAR(people, 5.0, 1e-9);
}

TEST(Jolts, are_of_who_is_stopped_short_by_a_body_and_not_of_who_brakes) {
  // One who minds nobody walks into one who stands; nobody else is there, and then only walls.
  for (const bool there : {true, false}) {
    Trial trial(repair(box(0.0, 0.0, 20.0, 1.0)), {"constant-velocity", 1});
    trial.add({1.0, 0.5}, line_at_x(19.0, 0.0, 1.0), 0, 1.34, 1.0);
    trial.add({there ? 8.0 : 18.0, 0.5}, line_at_x(19.5, 0.0, 1.0), 0, 0.01);
    Jolts jolts;
    trial.walk(8.0, [&] { jolts.look(trial); });
    EXPECT_EQ(jolts.share(), there ? 0.5 : 0.0);
  }
  // The default brakes behind somebody as slow.
  Trial trial(repair(box(0.0, 0.0, 20.0, 1.0)), {"heuristic", 1});
  trial.add({1.0, 0.5}, line_at_x(19.0, 0.0, 1.0), 0, 1.34, 1.0);
  trial.add({8.0, 0.5}, line_at_x(19.0, 0.0, 1.0), 0, 0.5, 1.0);
  Jolts jolts;
  trial.walk(8.0, [&] { jolts.look(trial); });
  EXPECT_EQ(jolts.share(), 0.0);
}

}  // namespace
}  // namespace pedzone::verify
