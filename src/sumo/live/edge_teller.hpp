// Tells SUMO which edge of their walks those have come to whom pedzone walks.
#pragma once

#include <set>
#include <string>

#include "sumo/calls/persons.hpp"
#include "sumo/plan/bystanders.hpp"
#include "sumo/plan/edges_walked.hpp"
#include "sumo/plan/replanning.hpp"

namespace pedzone {

class EdgeTeller {
 public:
  /// The rest must outlive it.
  EdgeTeller(const Network& network, SumoPersons& sumo) : network_(network), sumo_(sumo) {}

  /// Another step is written from now on, at `time` [s].
  void begin_step(double time);
  /// Somebody is given back on that lane in this step.
  void note_release(const std::string& lane) { taken_.insert(lane); }

  /// Before a person is shown (SumoPersons::show), who is at `position` [m] for SUMO and has
  /// `radius` [m], and after all releases of the step. `watch`: of its plan, by which it is walked.
  void tell(const std::string& id, EdgesWalked& edges, PlanWatch& watch, const Vec2& position,
            double radius, const Fleet& fleet, Bystanders& others);

 private:
  bool is_free(const Lane& lane, const Vec2& position, double radius, const Fleet& fleet,
               Bystanders& others) const;

  const Network& network_;
  SumoPersons& sumo_;
  double time_ = 0.0;            ///< [s]
  std::set<std::string> taken_;  ///< lanes on which somebody was put in this step
};

}  // namespace pedzone
