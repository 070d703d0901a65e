// Tells SUMO which edge of their walks those have come to whom pedzone walks.
#pragma once

#include <set>
#include <string>

#include "sumo/calls/persons.hpp"
#include "sumo/plan/bystanders.hpp"
#include "sumo/plan/edges_walked.hpp"

namespace pedzone {

class EdgeTeller {
 public:
  /// The rest must outlive it.
  EdgeTeller(const Network& network, SumoPersons& sumo) : network_(network), sumo_(sumo) {}

  /// A step of `dt` [s] is written from now on.
  void begin_step(double dt);

  /// Before a person is shown (SumoPersons::show), who is at `position` [m] for SUMO, has `radius`
  /// [m] and likes to walk at `speed` [m/s].
  void tell(const std::string& id, EdgesWalked& edges, const Vec2& position, double radius,
            double speed, const Fleet& fleet, Bystanders& others);

 private:
  bool is_free(const Lane& lane, const Vec2& position, double radius, const Fleet& fleet,
               Bystanders& others) const;

  const Network& network_;
  SumoPersons& sumo_;
  double dt_ = 0.0;              ///< [s]
  std::set<std::string> taken_;  ///< lanes on which somebody was put in this step
};

}  // namespace pedzone
