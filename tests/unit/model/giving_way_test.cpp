// Giving way to vehicles: the discomfort and the choice of direction and speed against their
// definitions, worked out by samples in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/random.hpp"
#include "model/candidates.hpp"
#include "model/direction_kernel.hpp"
#include "model/heuristic_model.hpp"
#include "oracle.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kShares[] = {1.0, 1.2, 0.5, 0.0};

class Numbers {
 public:
  explicit Numbers(std::uint32_t seed) : random_(seed) {}
  double operator()(double least, double most) {
    return least + (most - least) * std::uniform_real_distribution<double>(0.0, 1.0)(random_);
  }
  bool chance(double share) { return (*this)(0.0, 1.0) < share; }

 private:
  std::mt19937 random_;
};

// ---- the discomfort of one vehicle --------------------------------------------------------------

class Discomfort : public testing::TestWithParam<const DirectionKernel*> {
 protected:
  /// One vehicle and a person at the origin, whose way is stopped at other times in each direction.
  struct Case {
    VehicleState vehicle;
    PersonSpec person;
    double margin = 1.0, time = 4.0, lag = 0.5, share = 1.0;
    float stop[kMaxDirections];
  };

  /// h of all directions by the kernel.
  void work_out(const Case& c, float* out) const {
    DirectionTask task;
    task.candidates = candidates_.view();
    task.cost = candidates_.excluded();
    task.heading_cos = static_cast<float>(std::cos(c.person.heading));
    task.heading_sin = static_cast<float>(std::sin(c.person.heading));
    task.speed = static_cast<float>(c.person.speed);
    const Vec2 ahead = unit(c.vehicle.heading), d = c.person.at - c.vehicle.centre;
    const auto number = [](double x) { return static_cast<float>(x); };
    const VehicleFelt annoyance{
        number(d.dot(ahead)),
        number(cross(ahead, d)),
        number(ahead.x()),
        number(ahead.y()),
        number(c.vehicle.velocity.x()),
        number(c.vehicle.velocity.y()),
        number(c.vehicle.length / 2.0),
        number(c.vehicle.width / 2.0),
        number(c.margin),
        number(std::hypot(c.vehicle.length, c.vehicle.width) / 2.0 + c.margin)};
    const PacedWalk walk{number(c.share),
                         number(c.time),
                         number(c.lag),
                         number(c.person.velocity.x()),
                         number(c.person.velocity.y()),
                         c.stop};
    GetParam()->discomfort(task, annoyance, walk, 0, candidates_.padded(), out);
  }

  double clearance(const Case& c, std::size_t k) const {
    const Vec2 wanted = c.share * c.person.speed * unit(c.person.heading + candidates_.offset(k));
    const double stop = c.share > 0.0 ? static_cast<double>(c.stop[k]) / c.share : 1e9;
    return least_clearance(c.vehicle, stride(c.person.at, c.person.velocity, wanted, c.lag, stop),
                           c.time);
  }

  Candidates candidates_;
};

TEST_P(Discomfort, is_that_of_the_least_clearance_on_the_way) {
  Numbers number(1);
  int outside = 0, inside = 0, stopped = 0, none = 0;
  for (int i = 0; i < 500; ++i) {
    Case c;
    // Every third along an axis, as in networks drawn on a grid, where digits cancel completely.
    const bool on_grid = i % 3 == 0;
    const auto angle = [&] {
      return on_grid ? std::floor(number(-2.0, 2.0)) * kPi / 2.0 : number(-kPi, kPi);
    };
    const double speed = number(-3.0, 8.0);
    c.vehicle = vehicle(number(0.5, 15.0) * unit(angle()), angle(), speed, number(2.0, 14.0),
                        number(0.8, 2.6));
    if (i % 3 == 1) c.vehicle.velocity = speed * unit(c.vehicle.heading + number(-0.6, 0.6));
    c.person.heading = angle();
    c.person.speed = number(0.5, 2.0);
    c.person.velocity = on_grid && number.chance(0.5)
                            ? Vec2(c.person.speed * unit(c.person.heading))
                            : Vec2(number(0.0, 2.0) * unit(number(-kPi, kPi)));
    c.margin = number.chance(0.3) ? number(0.05, 0.5) : number(0.5, 6.0);
    c.time = number.chance(0.1) ? 0.0 : number(0.1, 8.0);
    c.lag = number(0.05, 1.0);
    c.share = kShares[i % 4];
    for (float& stop : c.stop) {
      stop = static_cast<float>(number.chance(0.5) ? 10.0 / c.person.speed : number(0.01, 4.0));
    }
    float h[kMaxDirections] = {};
    work_out(c, h);
    for (std::size_t k = static_cast<std::size_t>(i % 6); k < candidates_.padded(); k += 6) {
      if (candidates_.excluded()[k] != 0.0F) continue;
      const double least = clearance(c, k);
      const Bounds expected = discomfort(least, c.margin);
      EXPECT_GE(h[k], expected.least - 1e-5) << "case " << i << " direction " << k << " " << least;
      EXPECT_LE(h[k], expected.most + 1e-5) << "case " << i << " direction " << k << " " << least;
      outside += least > 0.0 && least < c.margin ? 1 : 0;
      inside += least < 0.0 ? 1 : 0;
      none += least > c.margin ? 1 : 0;
      stopped += c.share > 0.0 && static_cast<double>(c.stop[k]) < c.share * c.time ? 1 : 0;
    }
  }
  for (const int n : {outside, inside, stopped, none}) EXPECT_GT(n, 500);
}

TEST_P(Discomfort, of_who_stands_before_a_vehicle_does_not_depend_on_the_points_of_the_compass) {
  // Before the middle of a vehicle 2 m wide the greatest depth is 1 m: h = 1 + 1/(2m).
  for (const double heading : {0.0, 0.3, kPi / 2, 2.0, kPi, -kPi / 2}) {
    Case c;
    c.share = 0.0;
    c.margin = 2.0;
    c.vehicle = vehicle(-10.0 * unit(heading), heading, 4.0, 4.0, 2.0);
    std::fill(std::begin(c.stop), std::end(c.stop), 7.5F);
    float h[kMaxDirections] = {};
    work_out(c, h);
    EXPECT_NEAR(h[30], 1.25, 1e-4) << heading;
  }
}

TEST_P(Discomfort, of_several_vehicles_is_the_worst) {
  Case c;
  std::fill(std::begin(c.stop), std::end(c.stop), 7.5F);
  c.person = walking_to({0, 0}, 0.0);
  c.margin = 3.0;
  float near[kMaxDirections] = {}, far[kMaxDirections] = {}, both[kMaxDirections] = {};
  const VehicleState vehicles[] = {vehicle({12.0, 1.0}, kPi, 2.0), vehicle({5, -9}, kPi / 2, 2.0)};
  int first_wins = 0, second_wins = 0;
  c.vehicle = vehicles[0];
  work_out(c, near);
  work_out(c, both);
  c.vehicle = vehicles[1];
  work_out(c, far);
  work_out(c, both);
  for (std::size_t k = 0; k < candidates_.padded(); ++k) {
    EXPECT_EQ(both[k], std::max(near[k], far[k])) << k;
    first_wins += near[k] > far[k] ? 1 : 0;
    second_wins += near[k] < far[k] ? 1 : 0;
  }
  EXPECT_GT(first_wins, 5);
  EXPECT_GT(second_wins, 5);
}

INSTANTIATE_TEST_SUITE_P(Kernels, Discomfort, testing::ValuesIn([] {
                           std::vector<const DirectionKernel*> kernels{&baseline_kernel()};
                           if (has_avx2()) kernels.push_back(&avx2_kernel());
                           return kernels;
                         }()),
                         [](const auto& test) { return std::string(test.param->name); });

// ---- the choice ---------------------------------------------------------------------------------

double caution_of(const Scene& scene, std::size_t person) {
  // A scene's key is the person's place, counted from 1, and its seed is 0.
  const std::uint64_t own = scene.people[person].key, key = own != 0 ? own : person + 1;
  return std::exp(scene.parameters.margin_spread * random_normal(0, key, 0, Purpose::kCaution));
}

/// A person that has not got to get out of a vehicle's way at once; in open space, or beside a
/// wall.
Scene with_one_vehicle(Numbers& number, bool wall) {
  Scene scene;
  scene.parameters.equation = number.chance(0.25) ? 1.0 : 2.0;
  scene.parameters.slowing_cost = number(0.05, 0.8);
  scene.parameters.hurry_cost = number(0.1, 2.0);
  scene.parameters.discomfort = number(0.3, 4.0);
  scene.parameters.letting_pass = scene.parameters.meeting = 0.0;
  PersonSpec p = walking_to({0, 0}, number(-kPi, kPi));
  p.key = static_cast<std::uint64_t>(number(1.0, 1e6));
  p.speed = number(0.8, 1.8);
  p.velocity = number(0.0, 1.8) * unit(p.heading + number(-0.5, 0.5));
  p.goal = p.heading + number(-0.8, 0.8);
  scene.people = {p};
  while (scene.vehicles.empty()) {
    // It will be near where the person wants to be some time later.
    const double speed = number.chance(0.2) ? number(0.06, 0.6) : number(-2.0, 6.0);
    const double heading = number(-kPi, kPi), later = number(1.0, 5.0);
    const Vec2 meeting =
        later * p.speed * unit(p.goal) + number(0.0, 3.0) * unit(number(-kPi, kPi));
    const VehicleState v = vehicle(meeting - later * speed * unit(heading), heading, speed,
                                   number(2.0, 8.0), number(0.8, 2.6));
    const double soon = least_clearance(v, Stride{p.at, Vec2::Zero(), 0.0}, 1.1);
    if (std::abs(speed) > 0.05 && soon > 1.0) scene.vehicles = {v};
  }
  if (wall) {
    const Vec2 away = unit(p.heading + (number.chance(0.5) ? 1.0 : -1.0) * number(0.5, 2.0));
    const Vec2 middle = number(0.5, 4.0) * away;
    scene.walls = {{middle + 60.0 * left_of(away), middle - 60.0 * left_of(away)}};
    if (cross(scene.walls[0].b - scene.walls[0].a, p.at - scene.walls[0].a) < 0.0) {
      std::swap(scene.walls[0].a, scene.walls[0].b);
    }
  }
  return scene;
}

/// The value of a decision: of the speed shares that it may stand for, the best one's.
double value_of(const Scene& scene, const std::vector<Obstacle>& around, const Decision& d,
                double caution) {
  const PersonSpec& p = scene.people[0];
  double least = 1e300;
  for (const double share : kShares) {
    const double speed = std::min(static_cast<double>(static_cast<float>(share)) * p.speed,
                                  d.free_distance / scene.parameters.collision_time);
    if (std::abs(speed - d.speed) > 1e-9) continue;
    const double offset = wrap_angle(d.direction - p.heading);
    least = std::min(least, total_value(scene, around, offset, share, caution).least);
  }
  return least;
}

double best_value(const Scene& scene, const std::vector<Obstacle>& around, double caution) {
  std::vector<double> offsets = main_offsets();
  const std::vector<double> rest = rest_offsets();
  offsets.insert(offsets.end(), rest.begin(), rest.end());
  double best = 1e300;
  for (const double offset : offsets) {
    for (const double share : kShares) {
      best = std::min(best, total_value(scene, around, offset, share, caution).most);
    }
  }
  return best;
}

/// Of cases in which the direction that would be taken anyway is a discomfort.
struct Compared {
  int all = 0, slower = 0, faster = 0, elsewhere = 0;
};
Compared compare_with_best_value(bool wall) {
  constexpr double kTolerance = 0.2;  // [m²] of 100 and more: 5 mm of free way
  Numbers number(2);
  Compared compared;
  for (int i = 0; i < 300; ++i) {
    const Scene scene = with_one_vehicle(number, wall);
    const std::vector<Obstacle> around = aware_of(scene, 0);
    const double caution = caution_of(scene, 0);
    // Whoever has no discomfort where it would go anyway, by Eq. 1, looks no further.
    OracleChoice anyway = best_direction(scene, 0, false);
    if (std::abs(anyway.free - scene.parameters.near_distance) < 0.02) continue;
    if (anyway.free < scene.parameters.near_distance) anyway = best_direction(scene, 0, true);
    Scene comfort = scene;
    comfort.parameters.discomfort = 0.0;
    const double costs = total_value(scene, around, anyway.offset, 1.0, caution).least -
                         total_value(comfort, around, anyway.offset, 1.0, caution).least;
    if (anyway.margin < kTolerance || costs < kTolerance) continue;
    const Decision d = scene.first();
    const double chosen = value_of(scene, around, d, caution);
    EXPECT_LE(chosen, best_value(scene, around, caution) + kTolerance) << "case " << i;
    ++compared.all;
    compared.slower += d.speed < 0.8 * std::min(scene.people[0].speed, d.free_distance / 0.5);
    compared.faster += d.speed > 1.01 * scene.people[0].speed;
    const double off = wrap_angle(d.direction - scene.people[0].heading - anyway.offset);
    compared.elsewhere += std::abs(off) > 0.01;
  }
  return compared;
}

TEST(GivingWay, chooses_the_best_of_all_directions_and_speeds) {
  const Compared compared = compare_with_best_value(false);
  EXPECT_GT(compared.all, 80);
  EXPECT_GT(compared.slower, 15);
  EXPECT_GT(compared.faster, 10);
  EXPECT_GT(compared.elsewhere, 25);
}

TEST(GivingWay, takes_who_comes_to_a_wall_to_stand_there) {
  const Compared compared = compare_with_best_value(true);
  EXPECT_GT(compared.all, 80);
  EXPECT_GT(compared.slower, 15);
  EXPECT_GT(compared.elsewhere, 25);
}

// ---- where nothing is left of it ----------------------------------------------------------------

bool same(const Decision& a, const Decision& b) {
  return a.direction == b.direction && a.speed == b.speed && a.free_distance == b.free_distance &&
         a.waits == b.waits && a.turns == b.turns;
}

struct Comparison {
  std::size_t all = 0, different = 0, waiting = 0;
};
/// Of a scene as it is with the one by another model.
void compare_with(const char* model, const Scene& scene, Comparison& sum) {
  Scene paper = scene;
  paper.model_name = model;
  const std::vector<Decision> a = scene.decide(), b = paper.decide();
  for (std::size_t i = 0; i < a.size(); ++i) {
    ++sum.all;
    sum.different += same(a[i], b[i]) ? 0 : 1;
    sum.waiting += b[i].waits ? 1 : 0;
  }
}

Scene among_vehicles(std::uint32_t seed) {
  return random_scene({.people = 300, .density = 0.4, .vehicles = 10, .obstacles = 6}, seed);
}

TEST(GivingWay, of_no_weight_leaves_every_decision_as_it_was_to_the_bit) {
  Comparison without, with;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    Scene scene = among_vehicles(seed);
    compare_with("plain", scene, with);
    scene.parameters.discomfort = 0.0;
    compare_with("plain", scene, without);
  }
  EXPECT_EQ(without.different, 0U);
  EXPECT_GT(without.waiting, 20U);
  EXPECT_GT(with.different, 500U);
}

TEST(GivingWay, needs_a_vehicle_that_moves) {
  // Then people walk as in the paper that it builds on, by Eq. 1.
  Comparison parked, gone;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    Scene scene = among_vehicles(seed);
    scene.parameters.near_distance = 0.0;  // no way is barred
    for (VehicleState& v : scene.vehicles) v.velocity = (seed % 2) * 0.049 * unit(v.heading);
    compare_with("heuristic-original", scene, parked);
    scene.vehicles.clear();
    compare_with("heuristic-original", scene, gone);
  }
  EXPECT_EQ(parked.different, 0U);
  EXPECT_EQ(gone.different, 0U);
}

}  // namespace
}  // namespace pedzone::test
