// Who turns its shoulders, how near it gets to others then, and by which equation it chooses.
#include <gtest/gtest.h>

#include <algorithm>

#include "model/perceiving_model.hpp"
#include "oracle.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kGraze = 0.005;  // [m] of the oracle's steps of 1 ms, and of the lattice

PersonSpec standing_at(const Vec2& at, double heading = 0.0) {
  PersonSpec person;
  person.at = at;
  person.heading = heading;
  return person;
}

/// A person at the origin and others who stand round it, `distance` away, with no room between any
/// two of them.
Scene in_a_ring_of_people(double distance) {
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.parameters.field_of_view = 180.0;
  for (int k = 0; k < 72; ++k) {
    scene.people.push_back(standing_at(distance * unit(k * 5.0 * kDegree)));
  }
  return scene;
}

TEST(Shoulders, turn_where_people_leave_the_best_way_free_for_less_than_the_time_to_turn) {
  for (const char* model : {"heuristic", "plain", "heuristic-original"}) {
    for (const double time : {0.0, 0.5, 1.0, 2.0}) {
      for (const double more : {-0.1, 0.1}) {
        // In the directions of others the way is shortest; the ring is nearly a circle.
        Scene scene = in_a_ring_of_people(1.34 * time + 2 * 0.24 + more);
        scene.model_name = model;
        scene.parameters.turn_time = time;
        if (time == 0.0 && more < 0.0) continue;  // touches
        EXPECT_EQ(scene.first().turns, more < 0.0) << model << " " << time << " " << more;
      }
    }
  }
}

TEST(Shoulders, do_not_turn_for_a_wall_alone) {
  for (const char* model : {"heuristic", "plain", "social-force", "orca", "optimal-steps"}) {
    Scene scene;
    scene.model_name = model;
    scene.people = {walking_to({0, 0}, 0.0), standing_at({-1.0, 0.0})};  // who is behind
    scene.walls = {{{0.5, -20.0}, {0.5, 20.0}}};
    EXPECT_FALSE(scene.first().turns) << model;
    scene.walls.push_back({{0.5, 0.5}, {-20.0, 0.5}});
    scene.walls.push_back({{-20.0, -0.5}, {0.5, -0.5}});
    EXPECT_FALSE(scene.first().turns) << model;
  }
}

/// People who stand across the way in a row, 0.7 m apart and facing `heading`; the way to the goal
/// is between two of them.
Scene before_a_row(double heading, double turned_width = 0.5) {
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.0)};
  for (int k = -20; k < 20; ++k) {
    scene.people.push_back(standing_at({0.7, 0.35 + 0.7 * k}, heading));
  }
  for (PersonSpec& p : scene.people) p.turned_width = turned_width;
  return scene;
}

/// [m] straight on from the origin until a disc with its centre at (x, y) is touched.
double way_to_disc(double x, double y, double contact) {
  return x - std::sqrt(contact * contact - y * y);
}

TEST(Shoulders, turned_lead_between_people_who_leave_no_room_for_straight_ones) {
  for (const char* model : {"heuristic", "plain"}) {
    Scene scene = before_a_row(kPi);  // they face who comes
    scene.model_name = model;
    const Decision d = scene.first();
    EXPECT_TRUE(d.turns);
    EXPECT_NEAR(d.direction, 0.0, 1e-9);
    EXPECT_NEAR(d.free_distance, scene.parameters.sight, kGraze);
    EXPECT_NEAR(d.speed, 1.34, 1e-9);
    // Nobody can turn: half of 0.7 m is less than two radii.
    EXPECT_LT(before_a_row(kPi, 1.0).first().free_distance, 1.0);
  }
}

// [m] which two of SUMO's persons keep, one behind the other; broader ones keep no more.
constexpr double kFeet = 0.478;

TEST(Shoulders, turned_keep_nearly_the_full_distance_to_who_faces_the_same_way) {
  for (const double turned_width : {0.5, 0.7}) {
    const Scene scene = before_a_row(0.0, turned_width);
    const Decision d = scene.first();
    EXPECT_TRUE(d.turns);
    if (turned_width * 0.48 < 0.35) {  // there is room between them
      EXPECT_NEAR(d.direction, 0.0, 1e-9);
    }
    const double turned = turned_width * 0.48, q = 0.98 * 0.98;
    EXPECT_NEAR(d.free_distance, way_to_disc(0.7, 0.35, turned + q * (kFeet - turned)), kGraze);
    EXPECT_NEAR(d.speed, d.free_distance / scene.parameters.collision_time, 1e-9);
  }
}

TEST(Shoulders, of_who_walks_behind_somebody_keep_its_distance_whatever_their_width) {
  // In a passage with no room beside the one ahead; each as wide as it is.
  for (const double heading : {0.0, 0.5 * kPi, kPi, -2.0}) {
    for (const double walks : {0.0, 0.6}) {
      for (const double wide : {0.5, 0.8}) {
        Scene scene;
        scene.people = {walking_to({0, 0}, 0.0), standing_at({1.1, 0.0}, heading)};
        scene.people[0].radius = 0.3;
        scene.people[0].turned_width = wide;
        scene.people[1].velocity = {walks, 0.0};
        scene.people[1].turned_width = 0.6;
        scene.walls = {{{20.0, 0.32}, {-20.0, 0.32}}, {{-20.0, -0.32}, {20.0, -0.32}}};
        const Decision d = scene.first();
        const double turned = wide * 0.3 + 0.6 * 0.24;
        const double root = 0.6 + 0.38 * std::cos(heading), q = root * root;
        const double contact = turned + q * std::max(kFeet - turned, 0.0);
        const Obstacle ahead = disc({1.1, 0.0}, {walks, 0.0}, contact);
        const Vec2 velocity = 1.34 * unit(d.direction);
        const double way = 1.34 * time_to_contact(ahead, Vec2::Zero(), velocity, 10.0 / 1.34);
        ASSERT_LT(std::abs(d.direction), 20.0 * kDegree);
        EXPECT_TRUE(d.turns);
        // The walls stop nobody sooner who keeps to the middle, narrow as it has turned.
        EXPECT_LE(d.free_distance, way + kGraze) << heading << " " << walks << " " << wide;
        const double beside = (0.32 - wide * 0.3) / std::sin(std::max(std::abs(d.direction), 1e-9));
        EXPECT_GE(d.free_distance, std::min(way, beside) - kGraze) << heading << " " << walks;
      }
    }
  }
}

TEST(Shoulders, turned_find_a_way_along_a_wall_where_straight_ones_touch_it) {
  // Beside the one who stands in the middle there are 0.33 m from its turned body to the wall. A
  // vehicle that stands behind it is not forgotten when the walls are seen anew.
  constexpr double kSide = 0.45, kAt = -0.22, kTurnedRadius = 0.12;  // [m]
  for (const char* model : {"heuristic", "plain", "heuristic-original"}) {
    for (const double front : {90.0, 1.9}) {  // [m]
      Scene scene;
      scene.model_name = model;
      scene.people = {walking_to({0.0, kAt}, 0.0), standing_at({1.0, 0.0}, kPi)};
      scene.walls = {{{20.0, kSide}, {-20.0, kSide}}, {{-20.0, -kSide}, {20.0, -kSide}}};
      scene.vehicles = {vehicle({front + 0.2, 0.0}, 0.5 * kPi, 0.0, 4.0, 0.4)};
      const Decision d = scene.first();
      EXPECT_TRUE(d.turns) << model;
      EXPECT_NEAR(d.direction, -2.5 * kDegree, 1e-6) << model << " " << front;
      const double to_wall = (kSide - kTurnedRadius + kAt) / std::sin(2.5 * kDegree);
      if (front > to_wall) {
        EXPECT_NEAR(d.free_distance, to_wall, 0.05) << model;
      } else {
        EXPECT_LT(d.free_distance, front - 0.24) << model;
        EXPECT_GT(d.free_distance, 1.4) << model;
      }
    }
  }
}

TEST(Shoulders, are_each_persons_own) {
  // Nobody turns but the one whose share is less than 1: contact is at the sum of what is left.
  for (const double own : {0.5, 1.0}) {
    for (const double others : {0.5, 1.0}) {
      Scene scene = before_a_row(kPi, others);
      scene.people[0].turned_width = own;
      const double turned = 0.24 * (own + others);  // 0.24, 0.36 or 0.48 m; half the gap is 0.35 m
      const Decision d = scene.first();
      if (turned < 0.35) {
        EXPECT_NEAR(d.free_distance, scene.parameters.sight, kGraze);
      } else {
        EXPECT_LT(d.speed, 1.34);
      }
      EXPECT_TRUE(d.turns);
    }
  }
}

TEST(Rays, are_those_of_who_has_turned_where_it_does) {
  // The chosen direction's ray is as long as it was found free, but for the distance to a queue.
  for (const char* name : {"heuristic", "plain"}) {
    for (const double heading : {0.0, kPi}) {
      Scene scene = before_a_row(heading);
      const auto model = make_model(name);
      const Decision d = scene.decide(*model)[0];
      const Persons persons = persons_of(scene.people);
      model->prepare({&persons, {}, nullptr, &scene.parameters});
      std::vector<Ray> rays;
      model->rays(0, rays);
      const auto ray = std::ranges::find(rays, d.direction, &Ray::direction);
      ASSERT_NE(ray, rays.end());
      EXPECT_TRUE(d.turns);
      EXPECT_NEAR(ray->free_distance, scene.parameters.sight, kGraze) << name << " " << heading;
    }
  }
}

// ---- by which equation --------------------------------------------------------------------------

/// 1 m before a long wall that faces the person: by Eq. 1 it stays straight on, by Eq. 2 it turns
/// along the wall.
Scene before_a_wall() {
  Scene scene;
  scene.parameters.margin_spread = 0.0;
  // Vehicles are felt, but weigh next to nothing: what is left is the equation.
  scene.parameters.discomfort = 1e-9;
  scene.parameters.slowing_cost = 1e3;
  scene.people = {walking_to({0, 0}, 0.0)};
  scene.walls = {{{1.24, -60.0}, {1.24, 60.0}}};
  return scene;
}

bool by_eq_2(const Scene& scene) {
  const double off = std::abs(scene.first().direction);
  EXPECT_TRUE(off == 0.0 || off > 70.0 * kDegree) << off / kDegree;
  return off > 0.0;
}

TEST(Equation, is_the_first_among_people_and_walls_unless_the_model_is_the_plain_one) {
  Scene scene = before_a_wall();
  for (const double equation : {1.0, 2.0}) {
    scene.parameters.equation = equation;
    for (const char* model : {"heuristic", "heuristic-original"}) {
      scene.model_name = model;
      EXPECT_FALSE(by_eq_2(scene)) << model;
    }
    scene.model_name = "plain";
    EXPECT_EQ(by_eq_2(scene), equation == 2.0);
  }
  scene.model_name = "heuristic";
  scene.parameters.discomfort = 0.0;  // the model as in the paper again
  EXPECT_TRUE(by_eq_2(scene));
}

TEST(Equation, is_the_second_for_who_feels_a_vehicle) {
  // Comes along the wall and passes the person closely in 2.5 s.
  Scene scene = before_a_wall();
  scene.parameters.sight = 20.0;
  const VehicleState felt = vehicle({0.0, -10.0}, kPi / 2, 4.0, 3.0, 1.6);
  VehicleState leaving = felt, parked = felt, far = felt;
  leaving.centre.y() = 10.0;
  parked.velocity = Vec2::Zero();
  far.centre = {-15.0, -3.0};
  scene.vehicles = {felt};
  EXPECT_TRUE(by_eq_2(scene));
  scene.parameters.equation = 1.0;
  EXPECT_FALSE(by_eq_2(scene));
  scene.parameters.equation = 2.0;
  for (const VehicleState& other : {leaving, parked, far}) {
    scene.vehicles = {other};
    EXPECT_FALSE(by_eq_2(scene));
  }
}

// ---- models that decide from lists --------------------------------------------------------------

/// Gets on at `speed_` while its body is as wide as `from_` at least, and tells what it was shown.
class Recorder : public PerceivingModel {
 public:
  struct Look {
    double radius, width;
    std::vector<double> others;
  };
  explicit Recorder(double speed) : speed_(speed) {}
  mutable std::vector<Look> looks;

 private:
  Decision decide_from(const Perceived& who) const override {
    Look look{who.radius, who.width, {}};
    for (const Neighbour& other : who.neighbours) look.others.push_back(other.radius);
    looks.push_back(look);
    return walk_with(speed_ * who.goal_direction, who);
  }
  double speed_;
};

/// What the first person sees, in turn, and whether it turns.
std::vector<Recorder::Look> looks_of(const Scene& scene, double speed, bool& turns,
                                     double present_width = 1.0) {
  Recorder model(speed);
  Persons persons = persons_of(scene.people);
  for (double& radius : persons.present_radius) radius *= present_width;
  model.prepare({&persons, {}, nullptr, &scene.parameters});
  std::vector<Decision> decisions(scene.people.size());
  model.decide(0, 1, decisions);
  turns = decisions[0].turns;
  return model.looks;
}

/// Somebody `gap` [m] of free way before the person's body.
Scene somebody_ahead(double gap) {
  Scene scene;
  scene.people = {walking_to({0, 0}, 0.0), standing_at({2 * 0.24 + gap, 0.1})};
  scene.people[0].turned_width = 0.6;
  scene.people[1].turned_width = 0.7;
  return scene;
}

TEST(SecondLook, is_taken_by_who_is_hindered_and_shows_all_with_their_shoulders_turned) {
  bool turns = false;
  const auto looks = looks_of(somebody_ahead(0.5), 0.1, turns, 0.9);
  EXPECT_TRUE(turns);
  ASSERT_EQ(looks.size(), 2u);
  EXPECT_NEAR(looks[0].radius, 0.9 * 0.24, 1e-6);  // as they are now
  EXPECT_NEAR(looks[0].width, 0.9, 1e-6);
  EXPECT_NEAR(looks[0].others.at(0), 0.9 * 0.24, 1e-6);
  EXPECT_NEAR(looks[1].radius, 0.6 * 0.24, 1e-6);
  EXPECT_NEAR(looks[1].width, 0.6, 1e-6);
  EXPECT_NEAR(looks[1].others.at(0), 0.7 * 0.24, 1e-6);
}

TEST(SecondLook, is_not_taken_by_who_gets_on_or_has_nobody_ahead_within_the_time_to_turn) {
  bool turns = true;
  EXPECT_EQ(looks_of(somebody_ahead(0.5), 1.0, turns).size(), 1u);  // over half its speed
  EXPECT_FALSE(turns);
  EXPECT_EQ(looks_of(somebody_ahead(1.34 + 0.1), 0.1, turns).size(), 1u);
  EXPECT_EQ(looks_of(somebody_ahead(1.34 - 0.1), 0.1, turns).size(), 2u);
  Scene behind = somebody_ahead(0.5);
  behind.parameters.field_of_view = 180.0;
  behind.people[1].at = -behind.people[1].at;
  EXPECT_EQ(looks_of(behind, 0.1, turns).size(), 1u);
  EXPECT_FALSE(turns);
  behind.people.pop_back();  // alone, before whatever it is
  EXPECT_EQ(looks_of(behind, 0.0, turns).size(), 1u);
  EXPECT_FALSE(turns);
}

}  // namespace
}  // namespace pedzone::test
