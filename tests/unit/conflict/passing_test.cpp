// PET by hand: a vehicle of 4 by 2 m that drives east along y = 0, a person of radius 0.26 m (0.25
// m and what is left of a touch) that walks north along x = 0.
#include "conflict/passing.hpp"

#include <gmock/gmock.h>

namespace pedzone {
namespace {

constexpr double kStep = 0.5;  // [s] between two poses
const Sizes kSizes{2.0, 1.0, 0.25 + kTouch};

struct Pair {
  Trail<PersonPose> person;
  Trail<VehiclePose> vehicle;
};

/// PET of the whole: the least over all steps. The vehicle's centre is at x = v (t - t_vehicle),
/// the person at y = u (t - t_person).
std::optional<Passing> pet(double t_vehicle, double v, double t_person, double u,
                           double person_direction = kPi / 2.0, double last = 20.0) {
  Pair pair;
  std::optional<Passing> best;
  for (double t = 0.0; t <= last; t += kStep) {
    const Vec2 at = u * (t - t_person) * unit(person_direction), centre(v * (t - t_vehicle), 0.0);
    pair.person.push({at, t, static_cast<float>(u * t), static_cast<float>(person_direction)},
                     t - 10.0);
    pair.vehicle.push({t, centre, Vec2::UnitX(), v * t, 0.0F}, t - 10.0);
    const auto found = latest_passing(pair.person, pair.vehicle, kSizes);
    if (found && (!best || found->pet() < best->pet())) best = found;
  }
  return best;
}

TEST(PostEncroachmentTime, vehicle_first) {
  // Its rear leaves the person's strip, x = 0.25, at 5 + 2.25/4 s; the person's rim enters the
  // vehicle's, y = -1 - 0.25, at 10 - 1.25/1 s.
  const auto found = pet(5.0, 4.0, 10.0, 1.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->gap, (10.0 - 1.25) - (5.0 + 2.25 / 4.0), 0.05);  // corners of the octagon
}

TEST(PostEncroachmentTime, person_first) {
  const auto found = pet(10.0, 4.0, 5.0, 1.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->gap, -((10.0 - 2.25 / 4.0) - (5.0 + 1.25)), 0.05);
}

TEST(PostEncroachmentTime, is_zero_in_contact) {
  const auto found = pet(5.0, 4.0, 5.2, 1.0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->gap, 0.0);
}

TEST(PostEncroachmentTime, needs_ways_that_meet) {
  EXPECT_EQ(pet(5.0, 4.0, 15.0, 1.0, kPi / 2.0, 12.0), std::nullopt);  // not there yet
}

TEST(PostEncroachmentTime, does_not_count_who_follows) {
  EXPECT_EQ(pet(5.0, 2.0, 8.0, 2.0, 0.0), std::nullopt);
  EXPECT_NE(pet(5.0, 2.0, 8.0, 2.0, kPi), std::nullopt);  // the same way towards each other
}

TEST(PostEncroachmentTime, of_a_person_who_has_stood_there) {
  Trail<PersonPose> person;
  Trail<VehiclePose> vehicle;
  std::optional<Passing> best;
  for (double t = 0.0; t <= 12.0; t += kStep) {
    // Stands in the way until 4 s, then walks out of it at 1 m/s: out of |y| < 1.25 at 5.25 s. The
    // vehicle's front is there, x = -0.25, at 8 - 2.25/4 s.
    const double walked = std::max(0.0, t - 4.0);
    person.push({{0.0, walked}, t, static_cast<float>(walked), static_cast<float>(kPi / 2.0)},
                t - 10.0);
    vehicle.push({t, {4.0 * (t - 8.0), 0.0}, Vec2::UnitX(), 4.0 * t, 0.0F}, t - 10.0);
    const auto found = latest_passing(person, vehicle, kSizes);
    if (found && (!best || found->pet() < best->pet())) best = found;
  }
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->gap, -((8.0 - 2.25 / 4.0) - 5.25), 0.05);
}

TEST(Trail, keeps_what_is_needed_for_the_way_since) {
  Trail<PersonPose> trail;
  for (int t = 0; t < 100; ++t)
    trail.push({Vec2::Zero(), static_cast<double>(t), 0.0F, 0.0F}, t - 20.5);
  ASSERT_EQ(trail.size(), 22U);
  for (std::size_t k = 0; k < trail.size(); ++k)
    EXPECT_EQ(trail[k].time, 99.0 - static_cast<double>(k));
}

TEST(ClosestInTime, is_zero_where_both_are_there_at_once_between_the_poses) {
  // Both come by the origin at 0.5 s, from places apart to places apart.
  const PersonPose p0{{0.0, -3.0}, 0.0}, p1{{0.0, 3.0}, 1.0};
  VehiclePose v0, v1;
  v0.centre = {-6.0, 0.0};
  v1.centre = {6.0, 0.0};
  v1.time = 1.0;
  const auto found = closest_in_time(p0, p1, v0, v1, kSizes);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->gap, 0.0);
  // The person 5 s later: it enters what the vehicle has left.
  const PersonPose late0{{0.0, -3.0}, 5.0}, late1{{0.0, 3.0}, 6.0};
  const auto later = closest_in_time(late0, late1, v0, v1, kSizes);
  ASSERT_TRUE(later);
  EXPECT_GT(later->gap, 4.0);
}

/// On a circle of 8 m about the origin at 5 m/s, counter-clockwise from (8, 0).
VehiclePose on_circle(double t) {
  const double angle = 5.0 / 8.0 * t;
  return {t, 8.0 * unit(angle), left_of(unit(angle)), 5.0 * t, 0.0F};
}

TEST(ClosestInTime, of_a_vehicle_that_turns_is_that_of_short_steps) {
  // Somebody walks by what the vehicle's corners sweep, so much before or after it.
  for (const double way : {1.9, 2.7, 1.1}) {
    for (const double later : {-1.5, -0.8, 0.8, 1.5}) {
      const auto person = [&](double t) {
        return PersonPose{8.0 * unit(1.9) + 1.4 * (t - 3.0 - later) * unit(way), t};
      };
      const auto pet = [&](double step) {
        double least = 100.0;
        for (double tp = 0.0; tp < 6.0 - 1e-9; tp += step) {
          for (double tv = 0.0; tv < 6.0 - 1e-9; tv += step) {
            const auto found = closest_in_time(person(tp), person(tp + step), on_circle(tv),
                                               on_circle(tv + step), kSizes);
            if (found) least = std::min(least, found->pet());
          }
        }
        return least;
      };
      const double fine = pet(0.02);
      for (const double step : {0.5, 1.0}) {
        EXPECT_NEAR(pet(step), fine, 0.03) << way << ' ' << later << ' ' << step;
      }
    }
  }
}

TEST(ClosestOnWays, of_a_vehicle_that_turns_are_on_its_arc) {
  // It comes by 0.5 m away from its inner side, or from its outer corners, √(9² + 2²) m out: never
  // nearer, whatever the steps.
  for (const double out : {8.0 - 1.0 - 0.26 - 0.5, std::hypot(9.0, 2.0) + 0.26 + 0.5}) {
    for (const double step : {2.0, 1.0, 0.5, 0.1}) {
      Closest all{100.0, std::nullopt};
      for (double t = 0.0; t < 6.0 - 1e-9; t += step) {
        const PersonPose p0{out * unit(1.9), t}, p1{p0.at, t + step};
        const Closest here = closest_on_ways(p0, p1, on_circle(t), on_circle(t + step), kSizes);
        all.clearance = std::min(all.clearance, here.clearance);
        if (here.touch) all.touch = here.touch;
      }
      EXPECT_EQ(all.touch, std::nullopt) << step << " s, " << out << " m";
      EXPECT_NEAR(all.clearance, 0.5, 0.01) << step << " s, " << out << " m";
    }
  }
}

TEST(ClosestOnWays, tell_when_a_turning_vehicle_touches) {
  // Its front reaches the line from the origin to the person, 7.5 m out, when it has 2 m to go
  // along its axis: at the angle 1.9 - asin of that.
  const double out = 7.5, angle = 1.9 - std::asin((2.0 + 0.25) / out), at = angle * 8.0 / 5.0;
  const PersonPose p0{out * unit(1.9), 1.0}, p1{p0.at, 4.0};
  const Closest found = closest_on_ways(p0, p1, on_circle(1.0), on_circle(4.0), kSizes);
  ASSERT_TRUE(found.touch);
  EXPECT_NEAR(1.0 + 3.0 * *found.touch, at, 0.02);
}

}  // namespace
}  // namespace pedzone
