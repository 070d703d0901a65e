// Half-planes and their linear program against brute force; the scenes of van den Berg et al. 2011.
#include "model/orca.hpp"

#include <gtest/gtest.h>

#include <random>

#include "model/velocity_obstacle.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double number(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }
  Vec2 in_disc(double radius) {
    const double r = number(0.0, radius), angle = number(-kPi, kPi);
    return r * unit(angle);
  }

 private:
  std::mt19937 engine_;
};

double shortfall(std::span<const HalfPlane> planes, std::size_t first, const Vec2& v) {
  double most = 0.0;
  for (const HalfPlane& plane : planes.subspan(first)) {
    most = std::max(most, plane.least - plane.normal.dot(v));
  }
  return most;
}

constexpr double kMost = 1.5, kGrid = 0.01;  // [m/s]

/// Calls visit(v) for a grid of velocities in the disc.
template <class Visit>
void for_velocities(const Visit& visit) {
  for (double x = -kMost; x <= kMost; x += kGrid) {
    for (double y = -kMost; y <= kMost; y += kGrid) {
      const Vec2 v(x, y);
      if (v.norm() <= kMost) visit(v);
    }
  }
}

TEST(HalfPlanes, the_program_is_as_good_as_brute_force) {
  Random random(1);
  HalfPlaneProgram program;
  int feasible = 0, infeasible = 0;
  for (int k = 0; k < 150; ++k) {
    std::vector<HalfPlane> planes;
    const int hard = k % 4, soft = 1 + k % 9;
    for (int i = 0; i < hard + soft; ++i) {
      const double least = i < hard ? random.number(-1.0, 0.0) : random.number(-1.2, 0.9);
      planes.push_back({unit(random.number(-kPi, kPi)), least});
    }
    const Vec2 wanted = random.in_disc(kMost);
    const Vec2 found = program.solve(planes, hard, kMost, wanted);
    const std::span<const HalfPlane> all(planes);
    EXPECT_LE(found.norm(), kMost + 1e-6);
    EXPECT_LE(shortfall(all.first(hard), 0, found), 1e-6);
    const double missed = shortfall(all, hard, found);
    double least_missed = 1e9, nearest = 1e9;
    for_velocities([&](const Vec2& v) {
      if (shortfall(all.first(hard), 0, v) > 0.0) return;
      const double misses = shortfall(all, hard, v);
      least_missed = std::min(least_missed, misses);
      if (misses == 0.0) nearest = std::min(nearest, (v - wanted).norm());
    });
    EXPECT_LE(missed, least_missed + 1e-6) << "case " << k;
    if (missed > 1e-6) {
      ++infeasible;
      // Nothing on the grid is better; the grid is not much worse (a shortfall has slope 1).
      EXPECT_GE(missed, least_missed - 2.0 * kGrid) << "case " << k;
    } else {
      ++feasible;
      EXPECT_LE((found - wanted).norm(), nearest + 1e-6) << "case " << k;
    }
  }
  EXPECT_GT(feasible, 30);
  EXPECT_GT(infeasible, 30);
}

/// Whether a point with that velocity comes within the body's radius of its polygon until `time`.
bool hits(const ConvexBody& body, const Vec2& velocity, double time) {
  constexpr int kMoments = 400;
  for (int k = 1; k <= kMoments; ++k) {
    const Vec2 at = velocity * (time * k / kMoments);
    bool inside = body.corners.size() > 2;
    for (std::size_t i = 0; i < body.corners.size(); ++i) {
      const Vec2 &a = body.corners[i], &b = body.corners[(i + 1) % body.corners.size()];
      const Vec2 along = b - a;
      const double s = along.squaredNorm() > 0.0
                           ? std::clamp((at - a).dot(along) / along.squaredNorm(), 0.0, 1.0)
                           : 0.0;
      if ((a + s * along - at).norm() < body.radius) return true;
      inside = inside && cross(along, at - a) > 0.0;
    }
    if (inside) return true;
  }
  return false;
}

TEST(VelocityObstacle, the_way_out_ends_on_its_border_and_no_shorter_one_does) {
  Random random(2);
  int inside = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec2 centre = random.number(3.5, 9.0) * unit(random.number(-kPi, kPi));
    const Vec2 along = random.number(0.5, 2.0) * unit(random.number(-kPi, kPi));
    const Vec2 across = random.number(0.2, 1.0) * left_of(along).normalized();
    const Vec2 corners[] = {centre + along + across, centre - along + across,
                            centre - along - across, centre + along - across};
    const ConvexBody body{k % 2 == 0 ? std::span<const Vec2>(corners) : std::span(&centre, 1),
                          random.number(0.2, 0.8)};
    const double time = 5.0;
    const Vec2 velocity = k % 3 == 0
                              ? random.in_disc(4.0)
                              : Vec2(random.number(0.2, 1.5) * centre / time + random.in_disc(0.4));
    const WayOut out = way_out(body, velocity, time, 0.1);
    const bool hit = hits(body, velocity, time);
    if (std::abs(out.depth) > 0.01) {
      EXPECT_EQ(hit, out.depth > 0.0) << "case " << k;
    }
    EXPECT_NEAR(out.normal.norm(), 1.0, 1e-9);
    if (out.depth < 0.01) continue;
    ++inside;
    EXPECT_FALSE(hits(body, velocity + (out.depth + 0.01) * out.normal, time)) << "case " << k;
    for (int turn = 0; turn < 72; ++turn) {
      const Vec2 shorter = 0.97 * out.depth * unit(turn * kPi / 36.0);
      EXPECT_TRUE(hits(body, velocity + shorter, time)) << "case " << k << " turn " << turn;
    }
  }
  EXPECT_GT(inside, 60);
}

TEST(VelocityObstacle, who_is_in_the_body_gets_out_within_the_step) {
  const Vec2 centre(0.3, 0.0);
  const WayOut out = way_out({{&centre, 1}, 0.5}, Vec2::Zero(), 5.0, 0.1);
  EXPECT_NEAR(out.normal.x(), -1.0, 1e-12);
  EXPECT_NEAR(out.depth, (0.5 - 0.3) / 0.1, 1e-9);
}

Scene two_head_on(double aside) {
  Scene scene;
  scene.model_name = "orca";
  scene.people = {walking_to({0.0, 0.0}, 0.0), walking_to({6.0, aside}, kPi)};
  return scene;
}

TEST(Orca, two_head_on_share_the_effort_equally) {
  for (const double aside : {0.0, 0.1, -0.3}) {
    const std::vector<Decision> d = two_head_on(aside).decide();
    const Vec2 first = d[0].speed * unit(d[0].direction),
               second = d[1].speed * unit(d[1].direction);
    const Vec2 change = first - Vec2(1.34, 0.0), other = second - Vec2(-1.34, 0.0);
    EXPECT_GT(change.norm(), 0.01);
    EXPECT_NEAR((change + other).norm(), 0.0, 1e-6) << "aside " << aside;
    // Together they pass: the relative velocity leaves room for both bodies.
    const Vec2 relative = first - second, p(6.0, aside);
    const double miss = std::abs(cross(relative.normalized(), p));
    EXPECT_GE(miss, 2.0 * 0.24 - 1e-4);
  }
}

TEST(Orca, before_a_vehicle_the_person_takes_all_of_the_effort) {
  Scene scene;
  scene.model_name = "orca";
  scene.people = {walking_to({0.0, 0.0}, 0.0)};
  scene.vehicles = {vehicle({14.0, 0.3}, kPi, 3.0)};
  const Decision d = scene.first();
  EXPECT_LT(d.direction, 0.0);  // the side on which there is less of it
  const Vec2 velocity = d.speed * unit(d.direction);
  // 5 s of this, or until it is past, and no contact.
  for (double t = 0.0; t < 5.0; t += 0.01) {
    const Vec2 at = t * velocity, c = Vec2(14.0, 0.3) + t * Vec2(-3.0, 0.0);
    const Vec2 out = (at - c).cwiseAbs() - Vec2(2.5, 1.0);
    EXPECT_GE(out.cwiseMax(0.0).norm(), 0.24 - 1e-3) << t;
  }
}

constexpr double kStep = 0.1;  // [s]
/// [rad] nobody aims quite at its goal: in perfect symmetry people stand for ever.
constexpr double kAskew = 0.02;

/// The least gap [m] between two bodies, as narrow as they can be, while people change places
/// across a circle.
double least_gap_on_circle(int people, double radius, double turned_width, double& slowest) {
  Scene scene;
  scene.model_name = "orca";
  scene.parameters.field_of_view = 180.0;  // agents of the paper know all positions
  std::vector<Vec2> goals;
  for (int k = 0; k < people; ++k) {
    const double angle = 2.0 * kPi * k / people;
    PersonSpec p = walking_to(radius * unit(angle), angle + kPi);
    p.velocity = Vec2::Zero();
    p.turned_width = turned_width;
    scene.people.push_back(p);
    goals.emplace_back(-radius * unit(angle));
  }
  const auto model = make_model(scene.model_name);
  double least = 1e9;
  slowest = 0.0;
  for (int step = 0; step < 120.0 / kStep; ++step) {
    double left = 0.0;
    for (int k = 0; k < people; ++k) {
      PersonSpec& p = scene.people[k];
      const Vec2 way = goals[k] - p.at;
      p.goal = angle_of(way) + kAskew * (k % 3 - 1);
      p.goal_distance = way.norm();
      left = std::max(left, way.norm());
      for (int j = 0; j < k; ++j) {
        const double touching = 2.0 * turned_width * p.radius;
        least = std::min(least, (p.at - scene.people[j].at).norm() - touching);
      }
    }
    if (left < 1.0) return least;
    slowest = kStep * step;
    const std::vector<Decision> decisions = scene.decide(*model);
    for (int k = 0; k < people; ++k) {
      PersonSpec& p = scene.people[k];
      p.velocity = decisions[k].speed * unit(decisions[k].direction);
      p.at += kStep * p.velocity;
      p.heading = decisions[k].direction;
    }
  }
  ADD_FAILURE() << "not everybody arrived";
  return least;
}

TEST(Orca, people_on_a_circle_reach_the_opposite_side_without_overlap) {
  for (const double turned_width : {1.0, 0.5}) {
    for (const int people : {2, 5, 12, 30}) {
      double time = 0.0;
      const double gap = least_gap_on_circle(people, 10.0, turned_width, time);
      // Where they meet in the middle there may be no velocity in all half-planes (section 5.3),
      // and velocities hold for a whole step: a tenth of two radii at most.
      EXPECT_GT(gap, -0.05) << people << " people, width " << turned_width;
      EXPECT_LT(time, 3.0 * 20.0 / 1.34) << people << " people, width " << turned_width;
    }
  }
}

TEST(Orca, a_wall_ahead_is_approached_ever_more_slowly_and_one_beside_is_no_hindrance) {
  Scene scene;
  scene.model_name = "orca";
  scene.people = {walking_to({0.0, 0.0}, 0.0)};
  const double distance = 0.5, gap = distance - 0.24;
  scene.walls = {{{distance, -20.0}, {distance, 20.0}}};  // walkable to its left, the west
  const Decision ahead = scene.first();
  EXPECT_NEAR(ahead.speed * std::cos(ahead.direction), gap / 0.5, 1e-3);
  scene.people[0] = walking_to({0.0, 0.0}, kPi / 2.0);
  const Decision beside = scene.first();
  EXPECT_NEAR(beside.direction, kPi / 2.0, 1e-9);
  EXPECT_NEAR(beside.speed, 1.34, 1e-9);
}

}  // namespace
}  // namespace pedzone::test
