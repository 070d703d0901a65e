// Which part of a SUMO walk pedzone walks, and how the person gets back to SUMO at its end.
// Pure: knows the network and the zone, not the running SUMO.
//
//   route:   e0      e1      e2      e3      e4
//   zone:           [--------- zone --------]
//   stretch:         first          last    next
//                    taken over     released ~1 m before the end of `last`; SUMO walks on.
//                                   Where the zone has the junction, too: at the begin of `next`
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "crowd/crowd.hpp"
#include "zone/zone.hpp"

namespace pedzone {

/// How far before the end of the last edge a person goes back to SUMO. [m] numerical: leaves
/// SUMO's model a lane to be on before the junction.
constexpr double kPortalInset = 1.0;

/// [m] assumed: so far from the middle of a lane somebody is in no vehicle's way whom SUMO walks:
/// half a car, a body, and half a stripe, by which it moves people to the middle of one.
constexpr double kClearOfVehicles = 1.5;

/// How far on the edge that it steps over to it goes back to SUMO. [m] numerical
constexpr double kEntryInset = 0.3;

/// How a walk is given back.
enum class Release {
  kLeave,        ///< the route goes on: moveTo the last lane, near its end
  kArrive,       ///< the walk ends in the zone: moveTo the arrival position
  kRemoveStage,  ///< a route of one edge with one lane: no lane to hop over
  kStepOver,     ///< the zone has the junction, too, or ends with edges too short to be put on:
                 ///< moveTo the edge after it
};

/// The part of a route that pedzone walks.
struct ZoneStretch {
  int last = 0;  ///< index into the route of the last edge walked
  Release release = Release::kLeave;
  int lane = -1;            ///< Network lane the person is put on
  int hop_lane = -1;        ///< lane of another edge (or of the same one-edge route) to hop over
  double position = 0.0;    ///< [m] lane position of the portal or arrival
  bool forward = true;      ///< walks along the lane's direction where it leaves
  Destination destination;  ///< where the crowd walks it to; where the walk goes on on a lane that
                            ///< vehicles use as well, at its outer side
};

/// Network indices of a route's edges; -1 for one that the network lacks.
std::vector<int> edge_indices(const Network& network, const std::vector<std::string>& edges);

/// Whether the route uses its edge `index` there for the first time: moveTo takes that place.
bool is_first_occurrence(const std::vector<int>& route, int index);

/// Whether the person leaves `edge` towards `next` at the edge's end (true) or its beginning
/// (false). Nothing when they do not meet, or when they meet at both ends and the person comes
/// from the end: SUMO would then take it forward. `before`: the edge that it comes from; -1: none.
std::optional<bool> leaves_forward(const Network& network, int before, int edge, int next);

/// Whether SUMO's persons pass from one edge to the other over a single walking area.
bool share_walking_area(const Network& network, int a, int b);

/// Plans the stretch of a walk that begins on route[first], which must be an edge of the zone. It
/// goes on as long as the zone links the route's edges: where a signalled or level crossing lies
/// between two of them, SUMO walks the person across.
/// `route` holds Network edge indices; `arrival_position` [m] on the last edge.
/// Nothing when SUMO's remote control cannot give the person back safely: too short edges, or
/// a release edge that the route uses earlier (moveTo takes an edge's first occurrence).
std::optional<ZoneStretch> plan_stretch(const Network& network, const Zone& zone,
                                        const std::vector<int>& route, int first,
                                        double arrival_position);

}  // namespace pedzone
