// Scenes for the crowd's tests: a zone from its outline, people by number, and a clock.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "crowd/crowd.hpp"

namespace pedzone::test {

/// Axis-parallel rectangle, counter-clockwise.
Ring box(double x0, double y0, double x1, double y1);

/// A zone that consists of `space` without `obstacles`. No heading noise unless `noise`.
Zone zone_of(const Region& space, const std::vector<Ring>& obstacles = {}, bool noise = false);
Zone zone_of(const Ring& space, const std::vector<Ring>& obstacles = {}, bool noise = false);

/// Nobody turns its shoulders there: bodies are hard discs.
Zone with_hard_bodies(Zone zone);

/// Nobody's doing: goes straight for its goal at full speed, blind to everything.
std::unique_ptr<WalkingModel> blind_model();

/// Decides the same for everybody, whatever there is.
std::unique_ptr<WalkingModel> fixed_model(const Decision& decision);

/// A vehicle at `centre` that drives with `velocity`; it faces `heading` [rad].
VehicleState vehicle_at(const Vec2& centre, double heading, double speed, double length = 5.0,
                        double width = 1.8);

/// Distance [m] from a point to a vehicle's rectangle; 0 inside. Independent of the crowd's own.
double clearance(const VehicleState& vehicle, const Vec2& point);

/// A crowd with a clock. People get the keys 1, 2, 3 ... unless they have one; they leave the
/// scene when they arrive.
class Scene {
 public:
  explicit Scene(const Zone& zone, std::uint64_t seed = 1);
  Scene(const Zone& zone, std::uint64_t seed, std::unique_ptr<WalkingModel> model);

  struct Person {
    NewPerson given;
    Crowd::Handle handle = 0;
    PersonView view;  ///< now, or when it arrived
    bool here = true;
    double arrival_time = -1.0;  ///< [s]; negative: still walking
    double walked = 0.0;         ///< [m]
    std::vector<Vec2> path;      ///< [m] its places after every step
  };

  /// Adds somebody with its velocity: `speed` times the preferred speed towards the destination.
  std::size_t add(const Vec2& from, const Destination& to, double preferred_speed = 1.34,
                  double start = 1.0);
  std::size_t add(NewPerson person);

  void step(double dt = 0.1);
  /// Steps until everybody has arrived or the time [s] is `until`.
  void run(double until, double dt = 0.1);

  std::size_t arrived() const;
  /// Largest overlap [m] of two bodies now (0: none), with their shoulders straight.
  double worst_overlap() const;
  /// The same of bodies as they hold their shoulders now.
  double worst_present_overlap() const;
  /// Least distance [m] from any centre to a wall minus the body's radius as it was, over all steps
  /// since the start; -1 when somebody was outside.
  double least_wall_gap() const { return least_wall_gap_; }
  /// Least gap [m] between a body and a vehicle at the end of any step.
  double least_vehicle_gap() const { return least_vehicle_gap_; }
  /// Longest way [m] anybody made in one step beyond what its preferred speed explains.
  double worst_jump() const { return worst_jump_; }

  const Zone& zone;
  Crowd crowd;
  std::vector<Person> people;
  std::vector<VehicleState> vehicles;  ///< moved on by step()
  double time = 0.0;                   ///< [s]

 private:
  void observe(double dt);
  template <class Radius>
  double worst_overlap_of(const Radius& radius) const;

  double least_wall_gap_ = 1e9, least_vehicle_gap_ = 1e9, worst_jump_ = 0.0;
};

/// The destination across x = `x` from y0 to y1, or the single point.
Destination line_at_x(double x, double y0, double y1);
Destination line_at_y(double y, double x0, double x1);
Destination point(double x, double y);

}  // namespace pedzone::test
