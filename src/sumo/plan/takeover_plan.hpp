// Who is taken over, and from where: plans over plain values. takeover.hpp says why persons are
// taken over as they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sumo/files/hint_values.hpp"
#include "sumo/plan/edges_walked.hpp"
#include "sumo/plan/fleet.hpp"
#include "sumo/plan/zone_route.hpp"

namespace pedzone {

/// What SUMO tells of a person on a walk.
struct WalkerSeen {
  std::string id;
  std::vector<std::string> edges;  ///< of its present walk
  int stages_left = 0;
  double length = 0.0;            ///< [m] of its present walk, as SUMO counts it
  double arrival_position = 0.0;  ///< [m] on the last edge
  Vec2 position = Vec2::Zero();   ///< [m]
  double heading = 0.0;           ///< [rad]
  double speed = 0.0;             ///< [m/s]
  double top_speed = 0.0;         ///< [m/s]
  double radius = 0.24;           ///< [m] of its body as a disc
};

/// What is remembered of a person that pedzone does not walk.
struct PersonPast {
  std::size_t plan = 0;         ///< the plan this belongs to
  int last = -1;                ///< route index of the edge it was released on
  int refused_edge = -1;        ///< edge on which it was found that it cannot be taken over
  int refused_stages = 0;       ///< so many stages of its plan were left when that was asked
  bool was_controlled = false;  ///< pedzone has walked it before
  bool was_given_back = false;  ///< and has given it back to SUMO
};

/// The walk of a person that is taken over.
struct TakeoverPlan {
  ZoneStretch stretch;
  Vec2 start = Vec2::Zero();      ///< [m] inside the walls
  EdgesWalked edges{};            ///< of the stretch
  std::size_t plan = 0;           ///< number of SUMO's plan for it
  double by_junctions = kNoWay;   ///< [m] as NewPerson
  std::vector<Waypoint> round{};  ///< what its route comes by, where that is a long way round
  bool place_freely = false;  ///< it departs here, or SUMO has brought it into a vehicle: it may be
                              ///< moved to the nearest free place
  bool from_sumo = true;      ///< false: pedzone has walked it until now
};

/// A number for SUMO's plan of a person: another one for another plan. `arrival_position` [m]: on
/// the last of its edges.
std::size_t plan_number(int stages_left, const std::vector<std::string>& edges,
                        double arrival_position);

/// The zone of each edge of the network; -1: SUMO's.
std::vector<int> zones_of_edges(const Network& network, const std::vector<Zone>& zones);

/// Plans the walk of a person on `edge` of a zone. Nothing where it cannot be taken over or is as
/// good as through the zone; `past` then remembers to ask no more on this edge.
/// `walked_until_now`: pedzone has walked the person up to here and its plan has changed. It is
/// then taken over however short the rest is, since SUMO would walk on from where it was before.
std::optional<TakeoverPlan> plan_takeover(const Network& network, const Zone& zone, int edge,
                                          const WalkerSeen& walker, bool walked_until_now,
                                          const Fleet& fleet, PersonPast& past);

/// Whether an edge begins or ends where a street does.
bool touches_street_end(const Network& network, int edge);

/// Whether SUMO walks somebody on across the end of a street if `next_edge` (id; empty: none) is
/// what it walks on next: that is shorter than to go back.
bool leads_round_street_end(const Network& network, const std::string& next_edge);

/// Whether people can come from an edge to a junction of a zone's edges. No edge of a zone is one.
std::vector<bool> entries_of_zones(const Network& network, const std::vector<int>& zone_of_edge);

/// The walk of a person that comes into a zone.
struct EntryPlan {
  int zone = 0;  ///< index into the zones
  TakeoverPlan plan;
};

/// Plans the walk of a person that is at the end of `edge`, before a zone, and comes from there
/// onto a walking area: SUMO would squeeze it past vehicles that stand there, and from there nobody
/// can be taken over. Nothing where it is not within a step of `dt` [s] of that end, or goes
/// elsewhere. `walked_until_now`: as of plan_takeover(); it is then beyond that end.
std::optional<EntryPlan> plan_entry(const Network& network, const std::vector<Zone>& zones,
                                    const std::vector<int>& zone_of_edge, int edge,
                                    const WalkerSeen& walker, bool walked_until_now, double dt,
                                    const Fleet& fleet, PersonPast& past);

/// What becomes of a person once the crowd has it.
enum class Entry {
  kWalks,
  kStaysOutside,  ///< SUMO walks it over a signalled crossing, to which the zone does not reach
  kNoRoom,        ///< there is none beside a vehicle, or one comes that could not stop in comfort:
                  ///< it is SUMO's for this step
};

/// The crowd shows a person of `radius` [m], whose walk was planned, as `view`. `dt` [s]: of the
/// step.
Entry entry_of(const TakeoverPlan& plan, const PersonView& view, double radius, const Fleet& fleet,
               double dt);

/// The share of its top speed at which SUMO's striping model lets a person walk freely. It takes a
/// random share of up to `dawdling` off in every step; ours walk as fast as that on average, or a
/// comparison would measure free speed.
double striping_share(double dawdling);

/// The person as the crowd gets it, in zone number `zone`.
NewPerson new_person(const WalkerSeen& walker, const TakeoverPlan& plan, const PersonHints& hints,
                     std::size_t zone, double preferred_speed);

}  // namespace pedzone
