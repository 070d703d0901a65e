// Small scenes for the walking model: who stands where, decided once or walked through.
#pragma once

#include <random>
#include <vector>

#include "model/walking_model.hpp"

namespace pedzone::test {

struct PersonSpec {
  Vec2 at = Vec2::Zero();
  double heading = 0.0;  ///< [rad]
  Vec2 velocity = Vec2::Zero();
  double radius = 0.24;
  double turned_width = 0.5;  ///< with the shoulders turned, over the full width
  double speed = 1.34;        ///< preferred
  double goal = 0.0;          ///< [rad] direction
  double goal_distance = 100.0;
  std::uint64_t key = 0;  ///< 0: its index
};

/// A person that walks at its preferred speed towards its goal.
PersonSpec walking_to(const Vec2& at, double direction);

struct Scene {
  std::string model_name = "heuristic";
  std::vector<PersonSpec> people;
  std::vector<VehicleState> vehicles;
  std::vector<Wall> walls;
  Parameters parameters;

  std::vector<Decision> decide(WalkingModel& model) const;
  std::vector<Decision> decide() const;  ///< with a fresh model
  Decision first() const { return decide().front(); }
};

/// The same people and vehicles in another order: person i stood at place order[i].
struct Shuffled {
  Scene scene;
  std::vector<std::size_t> order;
};
Shuffled shuffled(const Scene& scene, std::uint32_t seed);

Persons persons_of(const std::vector<PersonSpec>& people);

VehicleState vehicle(const Vec2& centre, double heading, double speed, double length = 5.0,
                     double width = 2.0);

/// `n` people, `vehicles` and square obstacles with 4 walls each at random places of a square with
/// that density [1/m²] whose lower left corner is `origin`.
struct RandomScene {
  std::size_t people = 300;
  double density = 1.0;
  std::size_t vehicles = 0, obstacles = 0;
  Vec2 origin = Vec2(7000.0, -3000.0);
};
Scene random_scene(const RandomScene& spec, std::uint32_t seed);

/// Walks a scene's people towards fixed goals as the crowd does: velocities relax towards the
/// decisions, bodies turn into the chosen directions, vehicles drive on.
class Walkthrough {
 public:
  Walkthrough(const Scene& scene, std::vector<Vec2> goals);

  void step(double dt = 0.1);

  const Scene& scene() const { return scene_; }
  Vec2 at(std::size_t person) const { return scene_.people[person].at; }
  const Decision& decision(std::size_t person) const { return decisions_[person]; }
  double time() const { return time_; }
  /// Distance [m] between a body and the nearest vehicle; negative when they overlap.
  double clearance(std::size_t person) const;
  /// The least clearance so far, over all persons.
  double least_clearance() const { return least_clearance_; }
  Scene& mutable_scene() { return scene_; }

 private:
  Scene scene_;
  std::vector<Vec2> goals_;
  std::vector<Decision> decisions_;
  std::unique_ptr<WalkingModel> model_;
  WallIndex walls_;
  double time_ = 0.0, least_clearance_ = 1e9;
};

}  // namespace pedzone::test
