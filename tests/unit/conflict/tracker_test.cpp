// Whole encounters: a vehicle of 4 by 2 m, a person of radius 0.25 m, steps of 0.1 s.
#include "conflict/tracker.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace pedzone {
namespace {

constexpr double kStep = 0.1;

struct Motion {
  Vec2 at, velocity;
};

/// Lets both move as given, functions of time, until `end`; returns what was over by then.
template <typename PersonAt, typename VehicleAt>
std::vector<Conflict> encounter(const PersonAt& person_at, const VehicleAt& vehicle_at, double end,
                                const AwareOf& aware = {}, const ConflictLimits& limits = {}) {
  ConflictTracker tracker(limits);
  std::vector<Conflict> over;
  for (int i = 0; i * kStep <= end; ++i) {
    const double t = i * kStep;
    const Motion person = person_at(t), vehicle = vehicle_at(t);
    const PersonSample p{"p", person.at, person.velocity, angle_of(person.velocity), 0.25, {}};
    const VehicleSample v{"v", vehicle.at, 0.0, vehicle.velocity, 4.0, 2.0};
    tracker.step(t, {&p, 1}, {&v, 1}, aware, over);
  }
  tracker.finish(over);
  return over;
}

auto evenly(const Vec2& start, const Vec2& velocity) {
  return [=](double t) { return Motion{start + t * velocity, velocity}; };
}

TEST(Tracker, crossing_behind_the_vehicle) {
  // In the vehicle's way at t = (8 - 1.25)/1.5 s = 4.5 s; its rear has left x = 0.25 at
  // (20 + 2.25)/8 = 2.78 s.
  const auto over = encounter(evenly({0, -8}, {0, 1.5}), evenly({-20, 0}, {8, 0}), 15.0);
  ASSERT_EQ(over.size(), 1U);
  const Conflict& conflict = over.front();
  EXPECT_EQ(conflict.person, "p");
  EXPECT_EQ(conflict.vehicle, "v");
  EXPECT_EQ(conflict.type, EncounterType::kCrossingRight);
  EXPECT_EQ(conflict.first, First::kVehicle);
  EXPECT_FALSE(conflict.ttc || conflict.contact || conflict.drac || conflict.aware);
  ASSERT_TRUE(conflict.pet);
  EXPECT_NEAR(conflict.pet->value, 4.5 - 2.78, 0.05);
  EXPECT_NEAR(conflict.pet->position.y(), -1.25, 0.2);
}

TEST(Tracker, crossing_into_contact) {
  const auto over = encounter(evenly({0, 8}, {0, -2}), evenly({-20, 0}, {5, 0}), 6.0);
  ASSERT_EQ(over.size(), 1U);
  const Conflict& conflict = over.front();
  EXPECT_EQ(conflict.type, EncounterType::kCrossingLeft);
  ASSERT_TRUE(conflict.contact && conflict.ttc && conflict.pet);
  // The front reaches x = -0.25 at (20 - 2.25)/5 = 3.55 s, with the person at y = 0.9.
  EXPECT_NEAR(conflict.contact->time, 3.55, 0.02);
  EXPECT_NEAR(conflict.contact->value, std::hypot(2.0, 5.0), 1e-9);
  EXPECT_NEAR(conflict.contact->position.x(), -0.25, 0.25);
  EXPECT_EQ(conflict.ttc->value, 0.0);
  EXPECT_EQ(conflict.pet->value, 0.0);
  EXPECT_EQ(conflict.first, First::kUnknown);
  EXPECT_LT(conflict.clearance->value, 0.0);
  ASSERT_TRUE(conflict.detection);
  EXPECT_NEAR(conflict.detection->value, 3.55, 0.01);
  EXPECT_EQ(conflict.detection->time, 0.0);
  EXPECT_FALSE(conflict.braking);
}

TEST(Tracker, of_a_vehicle_that_bends_the_part_that_comes_first_counts) {
  // 10 m/s towards somebody who stands, from 2 s on braking; as one body and as two, 9 m each.
  const auto braking_of = [](int parts) {
    ConflictTracker tracker{ConflictLimits{}};
    std::vector<Conflict> over;
    for (int i = 0; i <= 60; ++i) {
      const double t = i * kStep, late = std::clamp(t - 2.0, 0.0, 5.0);
      const Vec2 front{-47.0 + 10.0 * t - 1.0 * late * late, 0.0}, velocity{10.0 - 2.0 * late, 0.0};
      const PersonSample p{"p", {0.0, 0.0}, {0.0, 0.0}, 0.0, 0.25, {}};
      std::vector<VehicleSample> vehicle;
      for (int k = 0; k < parts; ++k) {
        const double length = 18.0 / parts;
        const Vec2 centre = front - Vec2((k + 0.5) * length, 0.0);
        vehicle.push_back({"v", centre, 0.0, velocity, length, 2.0, k});
      }
      tracker.step(t, {&p, 1}, vehicle, {}, over);
    }
    tracker.finish(over);
    return over.at(0);
  };
  const Conflict whole = braking_of(1), bends = braking_of(2);
  ASSERT_TRUE(whole.braking && bends.braking && bends.detection);
  EXPECT_NEAR(bends.braking->value, whole.braking->value, 1e-9);
  EXPECT_NEAR(bends.detection->value, whole.detection->value, 1e-9);
}

TEST(Tracker, braking_from_behind) {
  // 10 m/s towards a walker of 1 m/s ahead, from 2 s on braking with 4 m/s² down to its speed.
  const auto vehicle = [](double t) {
    const double braked = std::clamp(t - 2.0, 0.0, 2.25);
    return Motion{
        {10.0 * std::min(t, 2.0) + 10.0 * braked - 2.0 * braked * braked + std::max(0.0, t - 4.25),
         0.0},
        {10.0 - 4.0 * braked, 0.0}};
  };
  const auto over = encounter(evenly({35, 0}, {1, 0}), vehicle, 8.0);
  ASSERT_EQ(over.size(), 1U);
  const Conflict& conflict = over.front();
  EXPECT_EQ(conflict.type, EncounterType::kFromBehind);
  ASSERT_TRUE(conflict.braking && conflict.detection && conflict.ttc && conflict.drac);
  const double gap = 35.0 - 2.25;  // at first; closing at 9 m/s
  EXPECT_NEAR(conflict.detection->value, gap / 9.0, 1e-9);
  EXPECT_NEAR(conflict.braking->time, 2.0, 1e-9);
  EXPECT_NEAR(conflict.braking->value, (gap - 18.0) / 9.0, 1e-9);
  EXPECT_LT(conflict.ttc->value, conflict.braking->value);
  EXPECT_NEAR(conflict.drac->value, 0.5 * 81.0 / (gap - 18.0), 0.2);
  EXPECT_FALSE(conflict.contact);
  EXPECT_NEAR(conflict.clearance->value, gap - 18.0 - 2.0 * 2.25 * 2.25, 0.05);
}

TEST(Tracker, head_on_and_stepping_aside) {
  const auto person = [](double t) {
    return t < 3.0 ? Motion{{30 - 1.5 * t, 0}, {-1.5, 0}}
                   : Motion{{25.5, 1.5 * (t - 3.0)}, {0, 1.5}};
  };
  const auto over = encounter(person, evenly({0, 0}, {5, 0}), 12.0);
  ASSERT_EQ(over.size(), 1U);
  EXPECT_EQ(over.front().first, First::kPerson);
  ASSERT_TRUE(over.front().ttc && over.front().pet);
  // Just before it turns, at 2.9 s: a gap of 25.65 - 2.25 - 14.5 m, closing at 6.5 m/s.
  EXPECT_EQ(over.front().type, EncounterType::kHeadOn);
  EXPECT_NEAR(over.front().ttc->time, 2.9, 1e-9);
  EXPECT_NEAR(over.front().ttc->value, 8.9 / 6.5, 1e-9);
  // Out of the way, |y| = 1.25, after 3 + 1.25/1.5 s; the front is there, x = 25.25, at 4.65 s.
  EXPECT_NEAR(over.front().pet->value, 4.65 - 3.0 - 1.25 / 1.5, 0.05);
}

TEST(Tracker, parked_vehicle) {
  const auto over = encounter(evenly({-6, 0.5}, {1, 0}), evenly({0, 0}, {0, 0}), 3.0);
  ASSERT_EQ(over.size(), 1U);
  EXPECT_EQ(over.front().type, EncounterType::kParked);
  EXPECT_NEAR(over.front().ttc->value, 0.75, 1e-9);  // a gap of 3.75 m, 3 of them walked
  EXPECT_FALSE(over.front().drac || over.front().pet);
}

TEST(Tracker, person_behind_the_vehicle_follows_it) {
  const auto over = encounter(evenly({-10, 0}, {2, 0}), evenly({0, 0}, {0.5, 0}), 4.0);
  ASSERT_EQ(over.size(), 1U);
  EXPECT_EQ(over.front().type, EncounterType::kFollowing);
  EXPECT_FALSE(over.front().drac);
}

TEST(Tracker, what_stays_within_the_limits_is_no_conflict) {
  // The least TTC is 1.75 s: at the end, 35.5 m apart less 5 s·6.5 m/s less 2.25 m.
  const auto run = [](double ttc, double drac) {
    ConflictLimits limits;
    limits.ttc = ttc;
    limits.drac = drac;
    return encounter(evenly({46.125, 0}, {-1.5, 0}), evenly({0, 0}, {5, 0}), 5.0, {}, limits)
        .size();
  };
  EXPECT_EQ(run(1.7, 10.0), 0U);
  EXPECT_EQ(run(1.8, 10.0), 1U);
  // DRAC then: v (v + 2u)/(2 gap) = 5·8/(2·11.375).
  EXPECT_EQ(run(1.7, 1.8), 0U);
  EXPECT_EQ(run(1.7, 1.7), 1U);
}

TEST(Tracker, awareness_counts_at_the_critical_moment) {
  double now = 0.0;
  const auto person = [&](double t) {
    now = t;
    return Motion{{30, 0}, {0, 0}};
  };
  const auto noticed_at = [&](double when) {
    const AwareOf aware = [&](std::size_t, std::size_t) { return std::optional(now >= when); };
    return encounter(person, evenly({0, 0}, {5, 0}), 5.0, aware).front().aware;
  };
  EXPECT_THAT(noticed_at(2.0), ::testing::Optional(true));
  EXPECT_THAT(noticed_at(6.0), ::testing::Optional(false));
}

TEST(Tracker, a_jump_is_no_way) {
  const auto person = [](double t) {
    return t < 2.0 ? Motion{{0, -20}, {0, 1}} : Motion{{0, 20}, {0, 1}};
  };
  EXPECT_TRUE(encounter(person, evenly({-1, 0}, {0, 0}), 4.0).empty());
}

TEST(Tracker, riding_in_a_vehicle_is_no_conflict_with_it) {
  ConflictTracker tracker({});
  std::vector<Conflict> over;
  for (int i = 0; i < 100; ++i) {
    const double t = i * kStep;
    const Vec2 at(0.0, -3.0 + std::min(t, 3.0));
    const PersonSample p{"p", at, {0, 1}, kPi / 2.0, 0.25, t >= 3.0 && t < 6.0 ? "bus" : ""};
    const VehicleSample v{"bus", {0, 0}, 0.0, {0, 0}, 12.0, 2.5};
    tracker.step(t, {&p, 1}, {&v, 1}, {}, over);
  }
  tracker.finish(over);
  EXPECT_TRUE(over.empty());
}

TEST(Tracker, order_of_the_samples_does_not_matter) {
  const auto run = [](bool backwards) {
    ConflictTracker tracker({});
    std::vector<Conflict> over;
    for (int i = 0; i < 80; ++i) {
      const double t = i * kStep;
      std::vector<std::string> ids;
      for (int k = 0; k < 20; ++k) ids.push_back("p" + std::to_string(k));
      std::vector<PersonSample> persons;
      for (int k = 0; k < 20; ++k) {
        persons.push_back({ids[k], Vec2(k, -6.0 + t), Vec2(0, 1), 0.0, 0.25, {}});
      }
      if (backwards) std::reverse(persons.begin(), persons.end());
      const VehicleSample v{"v", {-10 + 4 * t, 0}, 0.0, {4, 0}, 4.0, 2.0};
      tracker.step(t, persons, {&v, 1}, {}, over);
    }
    tracker.finish(over);
    std::string told;
    for (const Conflict& c : over)
      told += c.person + " " + std::to_string(c.clearance->value) + ";";
    return told;
  };
  EXPECT_FALSE(run(false).empty());
  EXPECT_EQ(run(false), run(true));
}

/// A person crosses behind a vehicle of so many parts of 4 m; at first it may ride.
std::vector<Conflict> behind_parts(std::size_t parts, std::string_view rides_in = {}) {
  ConflictTracker tracker({});
  std::vector<Conflict> over;
  for (int i = 0; i * kStep <= 15.0; ++i) {
    const double t = i * kStep;
    const Vec2 at(0, -8 + 1.5 * t), front(-20 + 8 * t, 0);
    const PersonSample p{"p", at, {0, 1.5}, 0.5 * kPi, 0.25, i < 5 ? rides_in : ""};
    const VehicleSample v[] = {{"v", front, 0.0, {8, 0}, 4.0, 2.0, 0},
                               {"v", front - Vec2(4, 0), 0.0, {8, 0}, 4.0, 2.0, 1}};
    tracker.step(t, {&p, 1}, {v, parts}, {}, over);
  }
  tracker.finish(over);
  return over;
}

/// A vehicle on a circle of 8 m about the origin at 5 m/s, counter-clockwise from (8, 0).
VehicleSample on_circle(double t) {
  const double angle = 5.0 / 8.0 * t;
  return {"v", 8.0 * unit(angle), angle + kPi / 2.0, 5.0 * left_of(unit(angle)), 4.0, 2.0};
}

/// The one conflict of somebody who walks from `at` with `velocity` and that vehicle.
Conflict with_turning_vehicle(const Vec2& at, const Vec2& velocity, double step) {
  ConflictTracker tracker({.ttc = 30.0, .pet = 5.0, .drac = 0.1});
  std::vector<Conflict> over;
  for (int i = 0; i * step <= 6.0; ++i) {
    const double t = i * step;
    const PersonSample p{"p", at + t * velocity, velocity, angle_of(velocity), 0.25, {}};
    const VehicleSample v = on_circle(t);
    tracker.step(t, {&p, 1}, {&v, 1}, {}, over);
  }
  tracker.finish(over);
  EXPECT_EQ(over.size(), 1U);
  return over.empty() ? Conflict{} : over.front();
}

TEST(Tracker, a_place_that_a_turning_vehicle_has_left_is_one_of_its_arc) {
  // Walks in from outside to where the vehicle has been two seconds before.
  const Vec2 at = 12.0 * unit(1.5), velocity = -unit(1.5);
  const Conflict fine = with_turning_vehicle(at, velocity, 0.05);
  const Conflict coarse = with_turning_vehicle(at, velocity, 1.0);
  ASSERT_TRUE(fine.pet && coarse.pet);
  EXPECT_NEAR(coarse.pet->value, fine.pet->value, 0.1);
}

TEST(Tracker, how_near_they_come_is_told_of_the_whole_encounter) {
  // Crosses 30 m ahead, is followed since it could be run into, and is passed at 3.5 m.
  ConflictTracker tracker({.ttc = 10.0});
  std::vector<Conflict> over;
  for (int i = 0; i <= 120; ++i) {
    const double t = i * kStep, y = t < 3.0 ? -4.0 + t : -1.0 - 1.5 * (t - 3.0);
    const PersonSample p{"p", {30.0, std::max(y, -4.75)}, {0.0, t < 3.0 ? 1.0 : 0.0}, 0.0, 0.25,
                         {}};
    const VehicleSample v{"v", {-30.0 + 8.0 * t, 0.0}, 0.0, {8.0, 0.0}, 4.0, 2.0};
    tracker.step(t, {&p, 1}, {&v, 1}, {}, over);
  }
  tracker.finish(over);
  ASSERT_EQ(over.size(), 1U);
  ASSERT_TRUE(over[0].clearance);
  EXPECT_NEAR(over[0].clearance->value, 4.75 - 1.0 - 0.25, 0.02);
}

TEST(Tracker, a_time_to_contact_that_is_to_be_told_is_looked_for) {
  const auto person = evenly({0, 0}, {0, 0}), vehicle = evenly({-50, 0}, {2.5, 0});
  EXPECT_EQ(encounter(person, vehicle, 2.0).size(), 0U);
  const auto over = encounter(person, vehicle, 2.0, {}, {.ttc = 30.0});
  ASSERT_EQ(over.size(), 1U);
  EXPECT_NEAR(over[0].ttc->value, (50.0 - 2.25) / 2.5 - 2.0, 0.1);
}

TEST(Tracker, a_vehicle_of_parts_is_one) {
  const auto whole = behind_parts(2), first = behind_parts(1);
  ASSERT_EQ(whole.size(), 1U);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(whole[0].vehicle, "v");
  ASSERT_TRUE(whole[0].pet && first[0].pet);
  EXPECT_NEAR(whole[0].pet->value, first[0].pet->value - 4.0 / 8.0, 0.05) << "its end is nearer";
  EXPECT_EQ(whole[0].first, First::kVehicle);
  EXPECT_TRUE(behind_parts(2, "v").empty()) << "it has got out of that";
}

}  // namespace
}  // namespace pedzone
