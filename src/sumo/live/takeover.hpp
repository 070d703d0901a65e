// Takeover and release: persons of SUMO become pedzone's while they walk in a zone.
//
// The recipe is the only one of many measured that neither aborts SUMO 1.15 nor strands anybody:
//   take over   on an ordinary edge of the zone, or in the last step before a walking area from
//               which the zone begins, in a walking stage: moveToXY with no edge and
//               matchThreshold -1 in every step, so that SUMO's lane model skips the person.
//               From a walking area it ends SUMO after the release ("Disconnected walk"), also
//               with moveTo the edge's lane first: it keeps the inner edge (tried);
//   walk        moveTo each next edge of the route, once, before moveToXY as above: SUMO has the
//               person on that edge then (edge_teller.hpp);
//   leave       in the hand-over step no moveToXY, but moveTo the last lane. If SUMO still has the
//               person on that very lane, first a hop over another lane, since a move to the same
//               lane does not enter the lane's list again;
//   arrive      the same at the arrival position; a route of one edge with one lane has no lane
//               to hop over: its stage is removed where it ends.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "sumo/calls/persons.hpp"
#include "sumo/files/walk_speeds.hpp"
#include "sumo/live/edge_teller.hpp"
#include "sumo/live/person_colour.hpp"
#include "sumo/plan/bystanders.hpp"
#include "sumo/plan/outside_drivers.hpp"
#include "sumo/plan/release_plan.hpp"
#include "sumo/plan/replanning.hpp"
#include "sumo/plan/takeover_plan.hpp"
#include "sumo/plan/walk_totals.hpp"
#include "sumo/plan/yield_plan.hpp"

namespace pedzone {

/// A person that pedzone walks at present.
struct Guest {
  std::string id;
  int zone = 0;  ///< index into the zones
  Crowd::Handle handle = 0;
  ZoneStretch stretch;
  EdgesWalked edges;             ///< of it
  PlanWatch watch;               ///< of SUMO's plan for it
  Vec2 position = Vec2::Zero();  ///< [m] at SUMO's present time
  double radius = 0.24;          ///< [m]
  double preferred_speed = 0.0;  ///< [m/s]
  /// [m/s] SUMO's, that this follows from; none: its <walk> says it.
  std::optional<double> top_speed;
  double kept = 0.0;  ///< [s] kept at its end by vehicles
  PersonColour colour;
  bool landed = false;  ///< SUMO has it on its lane, since its next stage begins where that is
  bool gone = false;    ///< no longer ours: dropped at the end of the phase
};

/// Somebody who was stuck among people and squeezed through.
struct JamRecord {
  double time = 0.0;  ///< [s] when it began to
  std::string person, zone;
  Vec2 position = Vec2::Zero();  ///< [m]
};

class Takeover {
 public:
  /// `dawdling`: SUMO's option pedestrian.striping.dawdling. `alone`: no other program is about.
  /// The rest must outlive it.
  Takeover(const Network& network, const std::vector<Zone>& zones,
           std::vector<std::unique_ptr<Crowd>>& crowds, const Profiles& profiles,
           const std::vector<WaypointPath>& paths, WalkSpeeds walk_speeds, double dawdling,
           bool alone, SumoPersons& sumo);

  /// After a step of SUMO, at `time` [s]: forgets persons that are gone, notices new plans, takes
  /// over who has entered a zone, and lets the crowds see who else is near.
  void read(double time, const Fleet& fleet);

  /// After the crowds have walked for `dt` [s] from `time` [s] on: writes everybody's place, hands
  /// over who is at the end of its stretch, lists who jams.
  void write(double time, double dt, const Fleet& fleet);

  /// Gives everybody back at once, wherever they are. Returns the ids of those who cannot be: SUMO
  /// has them stand where they are.
  std::vector<std::string> let_go();

  const std::vector<Guest>& guests() const { return guests_; }
  /// The guest of that id; nullptr: SUMO walks it.
  const Guest* guest(const std::string& id) const;
  /// The guest whom the crowd of a zone knows by that handle; nullptr: none.
  const Guest* guest(std::size_t zone, Crowd::Handle handle) const;
  const WalkTotals& totals() const { return totals_; }
  /// Of all steps so far, in time.
  const std::vector<JamRecord>& jams() const { return jams_; }
  Bystanders& bystanders() { return bystanders_; }
  /// As vehicles see them: the guests, and those near a zone whom another program walks, of whom
  /// SUMO's vehicles may know nothing.
  void people(std::vector<PersonAhead>& out);
  /// Who was found to be walked by another program, each time.
  const std::vector<OutsideRecord>& outsiders() const { return outsiders_; }
  /// Those near a zone whom SUMO walks.
  void sumo_people(std::vector<PersonAhead>& out);

 private:
  void check_guests(double time, const Fleet& fleet);
  void follow_speed(Guest& guest);
  void look_at_bystanders(double time);
  void show_bystanders(const Fleet& fleet);
  bool rides(const Bystander& person) const;
  bool is_declared(const std::string& id) const;
  int zone_of(const std::string& edge) const;
  void let_others_walk(const std::string& id, bool declared, double time);
  bool has_come_back(Bystander& person, double time) const;
  void give_back(const Guest& guest, const ReleasePlan& plan);
  void show(Guest& guest, const PersonView& view, const Fleet& fleet);
  void put_back(const Bystander& person, const std::string& edge);
  void take_new(double time, const Fleet& fleet);
  bool is_about_to_round_end(int edge, const WalkerSeen& walker) const;
  bool consider(const std::string& id, const std::string& edge, int stages_left,
                const Vec2* known_position, const Fleet& fleet);
  bool consider_entry(const std::string& id, const std::string& edge, const Vec2* known_position,
                      const Fleet& fleet);
  bool add_guest(const WalkerSeen& walker, int zone, const TakeoverPlan& plan, const Fleet& fleet);
  std::optional<ReleasePlan> hand_over(Guest& guest, const PersonView& view, double dt,
                                       const Fleet& fleet) const;
  void drop_gone();
  void list_jams(double time);

  /// Where somebody was, and is for its next walk, whose plan has changed while it does not walk.
  struct Replanned {
    Vec2 position = Vec2::Zero();  ///< [m]
    double until = 0.0;            ///< [s] it is SUMO's where it walks no sooner
  };

  const Network& network_;
  const std::vector<Zone>& zones_;
  std::vector<std::unique_ptr<Crowd>>& crowds_;
  const Profiles& profiles_;
  const std::vector<WaypointPath>& paths_;
  WalkSpeeds walk_speeds_;
  bool alone_;
  SumoPersons& sumo_;
  double striping_share_;          ///< of top speed, see takeover_plan.hpp
  std::vector<int> zone_of_edge_;  ///< -1: SUMO's
  std::vector<bool> entries_;      ///< of edges: people come from there to a zone
  double dt_ = 0.0;                ///< [s] of the last step
  Bystanders bystanders_;
  EdgeTeller edge_teller_;
  std::vector<Guest> guests_;  ///< in order of takeover
  std::unordered_map<std::string, std::size_t> guest_index_;
  std::unordered_map<std::string, PersonPast> past_;
  std::unordered_map<std::string, Replanned> replanned_;
  std::vector<Vec2> eyes_;                     ///< [m] who looks at bystanders
  std::vector<Bystander*> in_sight_;           ///< of them
  std::vector<std::vector<SeenPerson>> seen_;  ///< per zone
  WalkTotals totals_;
  std::vector<JamRecord> jams_;
  std::vector<OutsideRecord> outsiders_;
};

}  // namespace pedzone
