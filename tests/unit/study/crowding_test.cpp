#include "study/measure/crowding.hpp"

#include <gmock/gmock.h>

#include "results/density_grid.hpp"
#include "study/measure/run_series.hpp"

namespace pedzone::study {
namespace {

/// Persons who walk, all in a zone, at some places.
struct Scene {
  explicit Scene(const std::vector<Vec2>& places, double speed = 1.0) {
    trips.persons.resize(places.size());
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      pedestrians.push_back({i, &walk, places[i], speed});
    }
  }
  WalkStage walk;
  Trips trips;
  std::vector<Pedestrian> pedestrians;
};

std::map<std::string, double> measure(const Scene& scene, int steps, double dt = 1.0) {
  ClosenessMeter meter(scene.trips);
  Crowding crowding;
  for (int i = 0; i < steps; ++i) {
    const RunStep step{static_cast<std::uint64_t>(i), i * dt, i == 0 ? 0.0 : dt};
    const std::span<const Closeness> closeness = meter.of(step.dt, scene.pedestrians);
    for (std::size_t k = 0; k < closeness.size(); ++k) {
      crowding.add({step, scene.pedestrians[k], 0, closeness[k]});
    }
  }
  std::map<std::string, double> values;
  crowding.finish(values);
  return values;
}

TEST(Crowding, who_is_alone_is_at_level_a) {
  auto values = measure(Scene({{0, 0}}), 3);
  EXPECT_DOUBLE_EQ(values["space.density"], 1.0 / (kPi * 4.0));
  EXPECT_EQ(values["space.levelA"], 1.0);
}

TEST(Crowding, others_within_two_metres_count) {
  // The middle one has both near, the outer ones only it: 3, 2, 2 persons in their circles.
  const auto values = measure(Scene({{0, 0}, {1.9, 0}, {-1.9, 0}}), 3);
  EXPECT_DOUBLE_EQ(values.at("space.density"), (3.0 + 2.0 + 2.0) / 3.0 / (kPi * 4.0));
  // Diagonally over two metres.
  EXPECT_DOUBLE_EQ(measure(Scene({{0, 0}, {1.9, 1.9}}), 3).at("space.density"), 1.0 / (kPi * 4.0));
}

TEST(Crowding, levels_are_fruins) {
  const std::pair<double, int> levels[] = {{3.3, 0},  {3.2, 1},  {2.3, 2},  {1.4, 2}, {1.38, 3},
                                           {0.94, 3}, {0.92, 4}, {0.47, 4}, {0.45, 5}};
  for (const auto& [space, level] : levels) {
    EXPECT_EQ(level_of_service(1.0 / space), level) << space << " m² each";
  }
  // 12.57 m² of the circle over so many.
  for (const auto& [persons, level] : {std::pair{3, 0},
                                       {4, 1},
                                       {5, 1},
                                       {6, 2},
                                       {9, 2},
                                       {10, 3},
                                       {13, 3},
                                       {14, 4},
                                       {27, 4},
                                       {28, 5}}) {
    EXPECT_EQ(level_of_service(circle_density(persons)), level) << persons;
  }
}

TEST(Crowding, a_crowd_on_a_grid_has_its_density) {
  // 0.5 m apart: 4 /m². In the circle of a person far from the rims lie 49 places of the grid.
  std::vector<Vec2> places;
  for (int x = 0; x < 21; ++x) {
    for (int y = 0; y < 21; ++y) places.emplace_back(0.5 * x, 0.5 * y);
  }
  Scene scene(places);
  ClosenessMeter meter(scene.trips);
  EXPECT_DOUBLE_EQ(meter.of(1.0, scene.pedestrians)[10 * 21 + 10].density, 49.0 / (kPi * 4.0));
}

TEST(Crowding, three_who_stand_together_for_five_seconds_are_a_jam) {
  const std::vector<Vec2> three = {{0, 0}, {1, 0}, {0, 1}}, two = {{0, 0}, {1, 0}};
  // Standing counts from the first step, time from the second: 5 of 9 s are after 5 s of standing
  // (the fifth second ends it).
  EXPECT_DOUBLE_EQ(measure(Scene(three, 0.0), 10).at("space.jammed"), 5.0 / 9.0);
  EXPECT_EQ(measure(Scene(two, 0.0), 10).at("space.jammed"), 0.0);
  EXPECT_EQ(measure(Scene(three, 0.2), 10).at("space.jammed"), 0.0);
  // In a row of three only the middle one has two others near.
  EXPECT_DOUBLE_EQ(measure(Scene({{0, 0}, {1.5, 0}, {3, 0}}, 0.0), 10).at("space.jammed"),
                   5.0 / 27.0);
  Scene waiting_for_a_bus(three, 0.0);
  for (Pedestrian& pedestrian : waiting_for_a_bus.pedestrians) pedestrian.walk = nullptr;
  EXPECT_TRUE(measure(waiting_for_a_bus, 10).empty()) << "nobody walks";
}

TEST(DensityGrid, counts_time_in_cells) {
  DensityGrid grid;
  for (int k = 0; k < 2; ++k) {
    for (const Vec2& at : {Vec2(0.5, 0.5), Vec2(1.9, 0.1), Vec2(-0.1, 0.0)}) grid.add(at, 0.5);
  }
  EXPECT_EQ(grid.csv(), "x,y,personSeconds\n-2,0,1.000\n0,0,2.000\n");
}

TEST(RunSeries, holds_means_over_ten_seconds) {
  std::vector<Zone> zones(1);
  zones[0].walls = WallIndex(repair({{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
  RunSeries series(zones);
  const Scene two({{1, 1}, {2, 2}}, 1.5);
  const VehicleSample vehicle{.id = "v", .centre = {5, 5}, .velocity = {3, 4}};
  const VehicleSample outside{.id = "w", .centre = {50, 5}, .velocity = {3, 4}};
  std::vector<RunStep> steps;
  for (int time = 0; time <= 12; ++time) {
    const VehicleSample vehicles[] = {time < 5 ? vehicle : outside};
    steps.push_back({steps.size(), static_cast<double>(time), time == 0 ? 0.0 : 1.0});
    series.step(steps.back(), vehicles);
  }
  // Where a junction led is known late: what happened there counts in its own window.
  for (int time = 0; time < 10; ++time) {
    series.add({steps[time], two.pedestrians[0], 0, {0.25, false}});
    series.add({steps[time], two.pedestrians[1], 0, {0.75, false}});
  }
  // In [0, 10) 9 s are known, for 4 of which the vehicle was there.
  EXPECT_EQ(series.csv(),
            "time,persons,personSpeed,density,vehicles,vehicleSpeed\n"
            "0,2.0000,1.5000,0.5000,0.4444,5.0000\n"
            "10,0.0000,,,0.0000,\n");
}

}  // namespace
}  // namespace pedzone::study
