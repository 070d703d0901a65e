#include "conflict/poses.hpp"

#include <cmath>

namespace pedzone {
namespace {

constexpr double kPiece = kPi / 36.0;  // [rad] numerical: 5 m from the centre 5 mm off
constexpr double kOff = 0.02;          // [m] numerical
constexpr double kStraight = 1e-6;     // [rad] numerical
constexpr double kSmall = 1e-3;        // [rad] numerical: its sine is it, but for 2e-10

Vec2 turned(const Vec2& v, double angle) {
  return std::cos(angle) * v + std::sin(angle) * left_of(v);
}

}  // namespace

double turn_between(const VehiclePose& v0, const VehiclePose& v1) {
  const double sine = cross(v0.axis, v1.axis), cosine = v0.axis.dot(v1.axis);
  if (cosine > 0.0 && std::abs(sine) < kSmall) return sine;  // nearly always: quicker by much
  return std::atan2(sine, cosine);
}

//   The chord of a share of an arc: 2 R sin(share φ/2) long. It leaves the whole arc's chord by the
//   half of what is left to turn.
VehiclePose pose_between(const VehiclePose& v0, const VehiclePose& v1, double share) {
  const double half = 0.5 * turn_between(v0, v1);
  const Vec2 way = v1.centre - v0.centre;
  VehiclePose pose = v1;
  pose.time = v0.time + share * (v1.time - v0.time);
  pose.axis = turned(v0.axis, 2.0 * share * half);
  pose.centre = v0.centre;
  if (std::abs(half) < kStraight) {
    pose.centre += share * way;
  } else {
    pose.centre += std::sin(share * half) / std::sin(half) * turned(way, (share - 1.0) * half);
  }
  return pose;
}

double bulge_between(const VehiclePose& v0, const VehiclePose& v1, double body) {
  const double half = 0.5 * std::abs(turn_between(v0, v1));
  if (half < kSmall) return 0.0;  // of 10 m less than 3 mm: the search has more to spare
  return 0.5 * (v1.centre - v0.centre).norm() * std::tan(0.5 * half) +
         body * (1.0 - std::cos(half));
}

double way_between(const VehiclePose& v0, const VehiclePose& v1, double body) {
  const double half = 0.5 * std::abs(turn_between(v0, v1));
  const double arc = half < kStraight ? 1.0 : half / std::sin(half);
  return arc * (v1.centre - v0.centre).norm() + 2.0 * half * body;
}

int pieces_between(const VehiclePose& v0, const VehiclePose& v1) {
  return 1 + static_cast<int>(std::abs(turn_between(v0, v1)) / kPiece);
}

//   A corner is off by its distance from the centre times the half of a piece's turn, at most.
int pieces_that_keep_axis(const VehiclePose& v0, const VehiclePose& v1, double body) {
  return 1 + static_cast<int>(0.5 * std::abs(turn_between(v0, v1)) * body / kOff);
}

}  // namespace pedzone
