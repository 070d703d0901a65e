// What is read of persons in SUMO, and what they are told: calls, and no decision.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sumo/files/body_sizes.hpp"
#include "sumo/plan/release_plan.hpp"
#include "sumo/plan/takeover_plan.hpp"

namespace pedzone {

/// As SUMO has it.
struct TraciColour {
  int red = 0, green = 0, blue = 0, alpha = 255;  ///< [0, 255]
  bool operator==(const TraciColour&) const = default;
};

class SumoPersons {
 public:
  virtual ~SumoPersons() = default;

  virtual std::vector<std::string> ids() const = 0;           ///< of all in SUMO
  virtual Vec2 position(const std::string& id) const = 0;     ///< [m]
  virtual double speed(const std::string& id) const = 0;      ///< [m/s]
  virtual double heading(const std::string& id) const = 0;    ///< [rad]
  virtual double top_speed(const std::string& id) const = 0;  ///< [m/s] that it walks at most
  virtual BodySize size(const std::string& id) const = 0;
  virtual std::string edge(const std::string& id) const = 0;  ///< in a junction an inner one
  /// That SUMO walks it to next, inside junctions, too; empty: none.
  virtual std::string next_edge(const std::string& id) const = 0;
  virtual std::string lane(const std::string& id) const = 0;     ///< that SUMO has it on
  virtual std::string vehicle(const std::string& id) const = 0;  ///< it rides in; empty: none
  virtual int stages_left(const std::string& id) const = 0;
  virtual std::vector<std::string> edges(
      const std::string& id) const = 0;                       ///< of its present stage
  virtual std::size_t plan(const std::string& id) const = 0;  ///< its number (plan_number)
  virtual bool walks(const std::string& id) const = 0;        ///< its present stage is a walk
  /// Nothing where its present stage is no walk.
  virtual std::optional<WalkerSeen> walker(const std::string& id) const = 0;
  /// Its own parameter, else that of its type.
  virtual std::string parameter(const std::string& id, const std::string& key) const = 0;
  virtual std::string type(const std::string& id) const = 0;
  virtual TraciColour colour(const std::string& id) const = 0;

  virtual void set_colour(const std::string& id, const TraciColour& colour) = 0;
  /// From the end of the next step on it is exactly there, on no lane, and no model of SUMO's moves
  /// it. To be called for every step.
  virtual void show(const std::string& id, const Vec2& position, double heading) = 0;
  /// As show(), but on the nearest lane of its route, for one step: in the next one it is to be
  /// released or shown.
  virtual void land(const std::string& id, const Vec2& position, double heading) = 0;
  /// To be followed by show(): SUMO has it on that lane from now on, and counts it among those who
  /// walk there until the end of the next step. `move` is to be where SUMO has it: a client that
  /// asks before the step would find it elsewhere.
  virtual void put_on(const std::string& id, const LaneMove& move) = 0;
  /// It is SUMO's again. True: its plan is over and SUMO knows it no more.
  virtual bool release(const std::string& id, const ReleasePlan& plan) = 0;
};

}  // namespace pedzone
