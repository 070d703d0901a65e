// Room beside vehicles in narrow streets, for bodies with their shoulders turned.
//
//      wall =========================================
//               x            x: stands aside, while the vehicle drives past; or goes past it
//         [ vehicle ]  ->       while it stands
//
//      wall =========================================
#pragma once

#include <optional>
#include <span>

#include "geometry/rectangle.hpp"
#include "geometry/wall_index.hpp"
#include "world/snapshot.hpp"

namespace pedzone {

inline constexpr double kStepsAside = 10.0;  ///< [m] assumed: nobody walks farther to step aside

/// A body beside a vehicle.
struct BodyBeside {
  double radius = 0.24;  ///< [m] with straight shoulders
  double turned = 0.12;  ///< [m] with its shoulders turned
};

/// Somebody else there, with shoulders turned.
struct OtherBody {
  Vec2 position = Vec2::Zero();  ///< [m]
  double radius = 0.12;          ///< [m]
};

/// What leaves people little room.
struct SideRoom {
  const WallIndex& walls;
  std::span<const Rectangle> vehicles;     ///< near there, without that which is minded
  std::span<const OtherBody> others = {};  ///< who may be where one wants to step
};

/// Whether a vehicle is nearer than `reach` [m] to a point, or comes so near, driving on along its
/// way.
bool comes_within(const VehicleState& vehicle, const Vec2& point, double reach);

/// The nearest place to `from` [m], a place ahead of the vehicle on its way, to which a body can
/// step from there and let the vehicle drive past: with its shoulders turned it fits between the
/// vehicle's way and a wall, the full body is not touched. Of the places at one distance along the
/// way that with most room, up to `wanted` [m] beyond the vehicle's side. Nothing where there is
/// none within reach.
std::optional<Vec2> place_aside(const SideRoom& room, const VehicleState& vehicle, const Vec2& from,
                                const BodyBeside& body, double wanted);

/// Whether the vehicle, driving on along its way, comes nearer than now to a body at `point` [m]
/// and touches it, or nearly so: the rear of a vehicle that turns.
bool swings_over(const VehicleState& vehicle, const Vec2& point, double radius);

/// Whether the vehicle cannot drive on along its way while a body stays at `point` [m].
bool holds_up(const VehicleState& vehicle, const Vec2& point, double radius);

/// The nearest place to `from` [m] to which a turned body can step out of what the vehicle is about
/// to sweep, with nobody on the straight way there. Nothing where there is none within 8 m. For one
/// that is not much nearer nobody turns back who goes by `heading` [rad]: of two places as far away
/// it would reach neither.
std::optional<Vec2> place_clear(const SideRoom& room, const VehicleState& vehicle, const Vec2& from,
                                const BodyBeside& body, double heading);

/// Whether the straight way of a body that reaches `reach` [m] to its sides leads through the
/// vehicle, as it is now. Who is nearer to it than that may still step away from it.
bool leads_through(const VehicleState& vehicle, const Vec2& from, const Vec2& to, double reach);

/// Whether it stands or creeps where people walk: one can go past it.
bool may_be_passed(const VehicleState& vehicle);

/// A way along a standing vehicle from one end to the other.
struct SideWay {
  double lateral = 0.0;  ///< [m] from the vehicle's axis, positive to the left
  bool narrow = false;   ///< passable with turned shoulders only
};

/// The way along the vehicle's left (side 1) or right side (-1); nothing where a turned body does
/// not fit.
std::optional<SideWay> way_beside(const SideRoom& room, const VehicleState& vehicle, double side,
                                  const BodyBeside& body);

}  // namespace pedzone
