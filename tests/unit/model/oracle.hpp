// What the model must come to, worked out another way: contacts by walking on in steps of 1 ms,
// directions by trying all of them in double precision. Shares nothing with src/model.
#pragma once

#include <algorithm>
#include <vector>

#include "scene.hpp"

namespace pedzone::test {

/// Distance [m] from a point to a vehicle's rectangle, 0 inside.
double distance_to(const VehicleState& vehicle, const Vec2& point);
double distance_to(const Wall& wall, const Vec2& point);

/// Least step of the oracle [s]; contacts are found up to one step late.
inline constexpr double kOracleStep = 1e-3;

/// Something that must not be touched: its distance from a point at a time.
struct Obstacle {
  enum class Kind { kDisc, kVehicle, kWall } kind = Kind::kDisc;
  Vec2 at = Vec2::Zero(), velocity = Vec2::Zero();  ///< disc
  VehicleState vehicle;
  Wall wall;
  double contact = 0.0;  ///< [m] least distance that is no contact

  double distance(const Vec2& point, double time) const;
  double speed() const;  ///< [m/s]
};

Obstacle disc(const Vec2& at, const Vec2& velocity, double contact);
Obstacle rectangle(const VehicleState& vehicle, double contact);
Obstacle segment(const Wall& wall, double contact);

/// Time [s] until a point that walks from `from` with `velocity` touches it, at most `horizon`.
double time_to_contact(const Obstacle& obstacle, const Vec2& from, const Vec2& velocity,
                       double horizon);

/// Offsets [rad] from the heading: 61 over ±75°, and every 5° of the rest.
std::vector<double> main_offsets();
std::vector<double> rest_offsets();

/// d(α) of Eq. 1 or Eq. 2 (without d_max², which Eq. 2 leaves out).
double value(int equation, double free, double sight, double from_goal);

/// How wide two people are to each other: as their shoulders are, or turned, or turned towards who
/// comes and as their shoulders are behind who walks ahead.
enum class Width { kFull, kTurned, kByFacing };

/// [m] between the centres of two people who touch.
double contact_distance(const PersonSpec& a, const PersonSpec& b, Width width);

/// Obstacles that the person is aware of by sight and hearing, in a scene where nobody touches
/// anything.
std::vector<Obstacle> aware_of(const Scene& scene, std::size_t person, Width width = Width::kFull);

/// 1 or 2: by which equation the model chooses where no vehicle is felt.
int equation_of(const Scene& scene);

/// The choice by Eq. 1 or 2 among the main directions, or among all.
struct OracleChoice {
  double offset = 0.0;  ///< [rad]
  double free = 0.0;    ///< [m]
  double margin = 0.0;  ///< [m²] by which the second best is worse
};
OracleChoice best_direction(const Scene& scene, std::size_t person, bool all_directions,
                            Width width = Width::kFull);

/// The whole decision where no vehicle is felt: with the shoulders turned where the best of the
/// main directions is free for less than the time to turn; by Eq. 3 before who walks ahead.
struct OracleDecision {
  OracleChoice choice;
  bool turns = false;
  double free = 0.0;  ///< [m] for Eq. 3
  bool clear = true;  ///< else a comparison within it is too close to tell
};
OracleDecision decision_of(const Scene& scene, std::size_t person);

/// Distance [m] from a point to a vehicle's rectangle; negative inside: the depth.
double signed_distance_to(const VehicleState& vehicle, const Vec2& point);

/// How giving_way.hpp takes a person to go on: shifted at once by what its present velocity still
/// carries it, then straight on, from `stop` [s] on standing.
struct Stride {
  Vec2 from = Vec2::Zero(), velocity = Vec2::Zero();
  double stop = 1e9;

  Vec2 at(double time) const { return from + std::min(time, stop) * velocity; }
};
/// `now`: the person's velocity [m/s], which relaxes to `wanted` within `lag` [s].
Stride stride(const Vec2& at, const Vec2& now, const Vec2& wanted, double lag, double stop);

/// The least signed distance [m] within [0, horizon], by samples: `samples` of them, a further 100
/// beside the best one.
double least_clearance(const VehicleState& vehicle, const Stride& stride, double horizon,
                       int samples = 4000);

/// Bounds of a number.
struct Bounds {
  double least = 0.0, most = 0.0;
};
/// The discomfort h by its definition, where the least clearance is known to 0.1 mm. Inside the
/// rectangle the model takes the depth in the middle of the crossing for the greatest one: at least
/// half of it, since depth is concave along a line.
Bounds discomfort(double clearance, double margin);

/// d(α) + d_max²·[k·h + w·(1 − s)²] of one direction [rad from the heading] and speed share, for
/// the scene's first person among the vehicles and walls that it is aware of; its margins are
/// `caution` times the usual. A graze may be a contact or not.
Bounds total_value(const Scene& scene, const std::vector<Obstacle>& around, double offset,
                   double share, double caution);

}  // namespace pedzone::test
