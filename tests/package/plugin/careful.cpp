// A walking model of one's own, from scratch: this file is all of it.
//
//   cmake -S . -B build -D CMAKE_PREFIX_PATH=<where pedzone is installed> && cmake --build build
//   pedzone run town.sumocfg --model build/libcareful.so
//
// People walk towards their goal, turn away from whoever and whatever is near, and go no faster
// than lets them stop a while before the one ahead. After A. Tordeux, M. Chraibi, A. Seyfried,
// Collision-free speed model for pedestrian dynamics, Traffic and Granular Flow '15, 2016.

#include <algorithm>
#include <cmath>

// A base that hands over what a person is aware of, and the macro that makes this a plug-in.
#include "model/perceiving_model.hpp"
#include "model/plugin.hpp"

using pedzone::Vec2;

// Numbers with their units, up here, where they are found.
constexpr double kRange = 0.1;           // [m] in which people's and walls' influence falls to 1/e
constexpr double kVehicleRange = 1.0;    // [m] the same of vehicles
constexpr double kPersonStrength = 8.0;  // against 1 for the goal
constexpr double kWallStrength = 5.0;
constexpr double kVehicleStrength = 8.0;
constexpr double kHeadway = 1.0;  // [s] to the one ahead

class Careful : public pedzone::PerceivingModel {
 public:
  // Nobody farther away than 5 m is asked for: smaller is faster.
  Careful() : PerceivingModel(5.0) {}

 protected:
  // Called for each person in each step, from several threads at once: read `who`, change nothing
  // else, and return the same for the same.
  pedzone::Decision decide_from(const pedzone::Perceived& who) const override {
    // All positions are relative to the person, in metres, x to the east.
    Vec2 wanted = who.goal_direction;
    for (const pedzone::Neighbour& other : who.neighbours) {
      const double gap = other.distance - who.radius - other.radius;
      wanted -= kPersonStrength * std::exp(-gap / kRange) * other.offset / other.distance;
    }
    for (const pedzone::Border& wall : who.borders) {
      if (wall.repeated) continue;  // two walls that share their nearest point push once
      wanted += kWallStrength * std::exp(-(wall.distance - who.radius) / kRange) * wall.normal;
    }
    for (const pedzone::SeenVehicle& vehicle : who.vehicles) {
      const double gap = vehicle.distance - who.radius;
      wanted += kVehicleStrength * std::exp(-gap / kVehicleRange) * vehicle.away;
    }
    const double length = wanted.norm();
    const Vec2 direction = length > 0.0 ? Vec2(wanted / length) : who.goal_direction;

    // The speed: what the gap ahead allows.
    double free = who.parameters->sight;  // [m]
    for (const pedzone::Neighbour& other : who.neighbours) {
      const double ahead = other.offset.dot(direction);
      const double beside = std::abs(pedzone::cross(direction, other.offset));
      const double contact = who.radius + other.radius;
      if (ahead > 0.0 && beside < contact) free = std::min(free, other.distance - contact);
    }
    for (const pedzone::SeenVehicle& vehicle : who.vehicles) {
      if (vehicle.away.dot(direction) >= 0.0) continue;  // it leads away from that one
      free = std::min(free, std::max(vehicle.distance - who.radius, 0.0));
    }
    const double speed = std::clamp(free / kHeadway, 0.0, who.speed);
    return walk_with(speed * direction, who);
  }
};

// The one line that pedzone looks for when it loads the library.
PEDZONE_WALKING_MODEL(Careful)
