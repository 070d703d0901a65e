// Who is where, and how fast, at one moment. Frozen while people decide.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/wall_index.hpp"
#include "world/attention.hpp"
#include "world/parameters.hpp"

namespace pedzone {

/// All persons of a zone as arrays of equal length: those pedzone walks first ([0, walking)),
/// then those it only sees (SUMO still walks them, near the zone).
struct Persons {
  std::vector<double> x, y;             ///< [m] centre of the body
  std::vector<double> vx, vy;           ///< [m/s]
  std::vector<double> heading;          ///< [rad] (-pi, pi] where the body faces
  std::vector<double> radius;           ///< [m] (0, 1] body as a disc
  std::vector<double> turned_radius;    ///< [m] (0, radius] with the shoulders turned all the way
  std::vector<double> present_radius;   ///< [m] [turned_radius, radius] as they are turned now
  std::vector<double> preferred_speed;  ///< [m/s] (0, 5]
  std::vector<double> goal_direction;   ///< [rad] α0: towards the current waypoint
  std::vector<double> goal_distance;    ///< [m] to the current waypoint
  std::vector<std::uint64_t> key;       ///< person_key(id)
  std::size_t walking = 0;              ///< how many pedzone walks

  std::size_t size() const { return x.size(); }
  /// All columns of numbers.
  std::array<std::vector<double>*, 11> numbers() {
    return {&x,
            &y,
            &vx,
            &vy,
            &heading,
            &radius,
            &turned_radius,
            &present_radius,
            &preferred_speed,
            &goal_direction,
            &goal_distance};
  }
};

/// [m] assumed: nobody walks farther in the time that people look ahead (`discomfortHorizon`).
inline constexpr double kGroundReach = 10.0;

/// A vehicle, or one part of a vehicle that bends: its rectangle and how that moves.
struct VehicleState {
  Vec2 centre = Vec2::Zero();      ///< [m] of the rectangle
  double heading = 0.0;            ///< [rad]
  Vec2 velocity = Vec2::Zero();    ///< [m/s] of the centre; against the heading: reversing
  double yaw_rate = 0.0;           ///< [rad/s]
  double gain = 0.0;               ///< [m/s] ≥ 0 so much faster than `velocity` people expect it
                                   ///< to drive in the next second, since it speeds up
  double claim = 0.0;              ///< [m] [0, 50] a vehicle that people hold up asks for so
                                   ///< much room ahead of its front bumper, along its way
  double claimed = 0.0;            ///< [s] for how long it has asked: people mind who has
                                   ///< asked for longest
  std::span<const Vec2> way;       ///< [m] from where its rear was when the step began along its
                                   ///< next lanes; empty where unknown. Read within the step only
  std::span<const int> yields_at;  ///< numbers of the crossings at which it gives way to people
  bool forwards = false;           ///< it drives along its way, even where it turns round
  bool leaves = false;             ///< where its way ends it leaves the network, or before
  double gone = 0.0;               ///< [m] that its rear has gone along its way since
  double lead = 0.0;               ///< [m] ≥ 0 it may get ahead of here until the step ends
  double lag = 0.0;                ///< [m] ≥ 0 it may be behind here: braked since the step began
  double slower = 0.0;             ///< [m/s] ≥ 0 at which that grows
  double starts = 0.0;             ///< [m] ≥ 0 it stands, and may drive off so far in the step
  double length = 5.0, width = 1.8;           ///< [m]
  std::uint64_t key = 0;                      ///< of its id, while it is the same vehicle: its
                                              ///< parts have the same
  bool electric = false;                      ///< no engine is heard
  bool horn = false;                          ///< sounds its horn
  bool invites = false;                       ///< signals "after you": people need not give way
  Eigen::AlignedBox2d ground = everywhere();  ///< [m] where it is about to drive on the ground that
                                              ///< people walk on. Found by the crowd

  static Eigen::AlignedBox2d everywhere() {
    constexpr double kFar = 1e12;  // [m] numerical
    return {Vec2::Constant(-kFar), Vec2::Constant(kFar)};
  }
  /// Whether it drives beside that ground, not on it: nobody minds it.
  bool apart() const { return ground.isEmpty(); }
  /// Whether somebody there could get into its way while it looks ahead.
  bool concerns(const Vec2& point) const {
    return ground.squaredExteriorDistance(point) <= kGroundReach * kGroundReach;
  }
};

struct Snapshot {
  const Persons* persons = nullptr;
  std::span<const VehicleState> vehicles;
  const WallIndex* walls = nullptr;
  const Parameters* parameters = nullptr;
  const Attention* attention = nullptr;  ///< null: everybody perceives as the parameters say
  std::uint64_t seed = 0;                ///< of what differs from person to person
  double step = 0.1;                     ///< [s] > 0 for which decisions hold
  std::optional<double> time = {};       ///< [s] since the crowd began, where there is a clock
};

}  // namespace pedzone
