// Where the people of a panel begin and end their walks.
#pragma once

#include <vector>

#include "demand/draws.hpp"
#include "demand/people.hpp"

namespace pedzone {

class Places {
 public:
  /// `parts`: foot_parts() of the network. Throws InputError for unknown zones and edges, edges
  /// that nobody may walk on, and where there is no way on foot from any origin to any destination.
  Places(const DemandInput& input, const PanelSpec& spec, const std::vector<int>& parts);

  struct Trip {
    PlannedPlace from, to;
  };
  /// Begin and end of a walk, at least 15 m from each other (as the crow flies) where the edges
  /// are long enough, between which there is a way on foot.
  Trip draw(Draws& draws) const;

  /// A place beside another for a body of that width: the `member`th of a group at that place.
  PlannedPlace beside(const PlannedPlace& place, int member, double width) const;

 private:
  struct Choice {
    std::vector<int> edges;       ///< Network indices
    std::vector<double> weights;  ///< area of their walking lanes [m2]
  };
  Choice choose(const DemandInput& input, const PanelSpec& spec, const char* attribute) const;
  void keep_joined(const PanelSpec& spec);
  PlannedPlace place_on(const Choice& choice, Draws& draws) const;
  Vec2 point(const PlannedPlace& place) const;
  const Lane& lane_of(int edge) const { return network_.lanes[walking_lane(network_, edge)]; }

  const Network& network_;
  const std::vector<int>& parts_;
  Choice from_, to_;
};

}  // namespace pedzone
