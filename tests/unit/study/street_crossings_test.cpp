// Who crosses a street of 7 m, and the conflicts on its two halves. It runs along x, 200 m; cars
// drive to the east south of y = 0 and to the west north of it.
#include "study/measure/street_crossings.hpp"

#include <gmock/gmock.h>

#include "scene.hpp"
#include "sumo/files/net_reader.hpp"

namespace pedzone::study {
namespace {

using ::testing::SizeIs;

constexpr double kStep = 0.1;                 // [s]
constexpr double kX = 100.0;                  // [m] where people cross
constexpr double kWalk = 1.0, kDrive = 10.0;  // [m/s]
constexpr double kLength = 5.0;               // [m] of a car

/// A car whose front is at kX at a time [s].
struct Car {
  const char* id;
  bool east;
  double time;  ///< [s]
};

class StreetConflicts : public ::testing::Test {
 protected:
  /// Somebody walks from y = -5 to y = 5, or back, beginning at 0 s.
  SeenCrossing cross(bool north, const std::vector<Car>& cars) {
    ConflictTracker tracker{ConflictLimits{}};
    StreetCrossings crossings(zones_);
    std::vector<Conflict> conflicts;
    for (int k = 0; k <= 200; ++k) {
      const double time = kStep * k;
      const double y = std::min(-5.0 + kWalk * time, 5.0);
      const double speed = y < 5.0 ? kWalk : 0.0;
      const PersonSample person{
          .id = "p", .position = {kX, north ? y : -y}, .velocity = {0.0, north ? speed : -speed}};
      const std::vector<VehicleSample> vehicles = at(time, cars);
      tracker.step(time, std::span(&person, 1), vehicles, {}, conflicts);
      crossings.step(time, k > 0 ? kStep : 0.0, std::span(&person, 1), vehicles);
    }
    tracker.finish(conflicts);
    EXPECT_THAT(conflicts, SizeIs(cars.size()));
    crossings.count_conflicts(conflicts);
    crossings.finish(values_);
    const std::vector<SeenCrossing> all = crossings.all();
    EXPECT_THAT(all, SizeIs(1));
    return all.empty() ? SeenCrossing{} : all.front();
  }

  static std::vector<VehicleSample> at(double time, const std::vector<Car>& cars) {
    std::vector<VehicleSample> vehicles;
    for (const Car& car : cars) {
      const double way = car.east ? 1.0 : -1.0;
      const double front = kX + way * kDrive * (time - car.time);
      vehicles.push_back({.id = car.id,
                          .centre = {front - way * 0.5 * kLength, -way * 1.75},
                          .heading = car.east ? 0.0 : kPi,
                          .velocity = {way * kDrive, 0.0},
                          .length = kLength});
    }
    return vehicles;
  }

  static Zone zone() {
    ZoneSpec spec;
    spec.edges = {"eastward", "westward"};
    spec.crossing = CrossingRule::kAnywhere;
    const Network town =
        read_network(test::network_file("shopping-street/shopping-street.net.xml"));
    return build_zones(town, {spec}).front();
  }

  const std::vector<Zone> zones_{zone()};
  std::map<std::string, double> values_;
};

// At 1 m/s a body of 0.24 m leaves the swept way of a car on the first lane 4.4 s after it began,
// that of one on the second lane after 7.9 s, and is across at 8.2 s.
constexpr double kLeft1 = 4.4, kLeft2 = 7.9;

TEST_F(StreetConflicts, are_near_on_the_lane_beside_the_kerb_that_one_comes_from) {
  const SeenCrossing north = cross(true, {{"c", true, kLeft1 + 1.0}});
  EXPECT_TRUE(north.between);
  EXPECT_EQ(north.near_conflicts, 1.0);
  EXPECT_EQ(north.far_conflicts, 0.0);
  const SeenCrossing south = cross(false, {{"c", false, kLeft1 + 1.0}});
  EXPECT_EQ(south.near_conflicts, 1.0);
  EXPECT_EQ(south.far_conflicts, 0.0);
}

TEST_F(StreetConflicts, are_far_on_the_other_also_where_the_car_comes_when_one_is_across) {
  const SeenCrossing north = cross(true, {{"c", false, kLeft2 + 1.0}});
  EXPECT_LT(north.end, kLeft2 + 1.0);
  EXPECT_EQ(north.near_conflicts, 0.0);
  EXPECT_EQ(north.far_conflicts, 1.0);
  const SeenCrossing south = cross(false, {{"c", true, kLeft2 + 1.0}});
  EXPECT_EQ(south.near_conflicts, 0.0);
  EXPECT_EQ(south.far_conflicts, 1.0);
}

TEST_F(StreetConflicts, are_measures_of_a_run) {
  cross(true, {{"a", true, kLeft1 + 0.5}, {"b", true, kLeft1 + 1.4}, {"c", false, kLeft2 + 1.0}});
  EXPECT_EQ(values_.at("crossing.count"), 1.0);
  EXPECT_EQ(values_.at("crossing.near"), 2.0);
  EXPECT_EQ(values_.at("crossing.far"), 1.0);
}

/// A conflict at a place, told by its least TTC.
Conflict conflict_at(const Vec2& position, double time, double vehicle_speed = 8.0) {
  Conflict conflict;
  conflict.person = "p";
  conflict.begin = time - 1.0;
  conflict.ttc =
      Extreme{.value = 1.0, .time = time, .position = position, .vehicle_speed = vehicle_speed};
  return conflict;
}

TEST_F(StreetConflicts, leave_out_standing_vehicles_insertions_other_people_times_and_places) {
  StreetCrossings crossings(zones_);
  for (int k = 0; k <= 110; ++k) {
    const PersonSample person{.id = "p", .position = {kX, -5.5 + kStep * k}};
    crossings.step(kStep * k, kStep, std::span(&person, 1), {});
  }
  const Vec2 near(kX, -1.75);
  Conflict insertion = conflict_at(near, 4.0), other = conflict_at(near, 4.0);
  insertion.contact = insertion.ttc;
  insertion.begin = 4.0;
  other.person = "q";
  const std::vector<Conflict> conflicts{conflict_at(near, 4.0, 0.3),
                                        insertion,
                                        other,
                                        conflict_at(near, 20.0),
                                        conflict_at({-10.0, -1.75}, 4.0),
                                        conflict_at({kX, -6.0}, 4.0)};
  crossings.count_conflicts(conflicts);
  ASSERT_THAT(crossings.all(), SizeIs(1));
  EXPECT_EQ(crossings.all().front().near_conflicts, 0.0);
  EXPECT_EQ(crossings.all().front().far_conflicts, 0.0);
  crossings.count_conflicts(std::vector{conflict_at(near, 4.0)});
  EXPECT_EQ(crossings.all().front().near_conflicts, 1.0);
}

TEST_F(StreetConflicts, have_no_measures_without_a_street) {
  const std::vector<Zone> none(1);
  StreetCrossings crossings(none);
  crossings.finish(values_);
  EXPECT_FALSE(crossings.watch_any());
  EXPECT_TRUE(values_.empty());
}

}  // namespace
}  // namespace pedzone::study
