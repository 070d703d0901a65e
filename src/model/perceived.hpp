// What one person is aware of, in plain numbers: all that a model other than the heuristic reads.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/vec.hpp"
#include "world/parameters.hpp"

namespace pedzone {

/// Another person.
struct Neighbour {
  Vec2 offset;      ///< [m] from the person to it
  Vec2 velocity;    ///< [m/s]
  double radius;    ///< [m] as it holds its shoulders now, or would if it turned them
  double distance;  ///< [m] > 0 between the centres
};

/// A wall as seen from its walkable side, which is to the left of a → b.
struct Border {
  Vec2 nearest;     ///< [m] from the person to the wall's nearest point
  Vec2 a, b;        ///< [m] from the person to its ends
  Vec2 normal;      ///< unit vector to the walkable side
  double distance;  ///< [m] ≥ 0 to the nearest point
  bool repeated;    ///< its nearest point is an end that a border before it in the list shares:
                    ///< to be left out where points, not lines, count
};

/// A vehicle: a rectangle.
struct SeenVehicle {
  Vec2 centre;                     ///< [m] from the person to the rectangle's centre
  Vec2 axis;                       ///< unit vector of its heading
  Vec2 velocity;                   ///< [m/s]
  double half_length, half_width;  ///< [m]
  Vec2 nearest;                    ///< [m] from the person to the nearest point of its outline
  Vec2 away;                       ///< unit vector in which the distance grows fastest
  double distance;                 ///< [m] to the outline; negative: the person's centre is inside
  bool moving;                     ///< else it is parked
};

/// The person and what it is aware of: whom it sees (within its field of view and the model's
/// reach), walls that it faces, vehicles that it sees, hears and minds. All lists are sorted by
/// distance, the nearest first, and hold the same bits whatever the order of persons and vehicles.
/// What stands farther away than the person's goal is left out: nobody avoids it.
struct Perceived {
  Vec2 velocity;               ///< [m/s]
  Vec2 heading;                ///< unit vector
  Vec2 goal_direction;         ///< unit vector towards the current waypoint
  double goal_distance;        ///< [m]
  double radius;               ///< [m] as it holds its shoulders now, or would if it turned them
  double width;                ///< (0, 1] that radius over the one with straight shoulders
  double speed;                ///< [m/s] > 0 preferred
  double caution;              ///< > 0 factor of the room wanted to vehicles (profiles)
  double step;                 ///< [s] for which the decision holds
  std::optional<double> time;  ///< [s] of the snapshot
  std::uint64_t key;           ///< of the person, for random numbers that belong to it
  std::uint64_t seed;          ///< for the same
  const Parameters* parameters;

  std::vector<Neighbour> neighbours;
  std::vector<Border> borders;
  std::vector<SeenVehicle> vehicles;
};

}  // namespace pedzone
