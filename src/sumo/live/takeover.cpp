#include "sumo/live/takeover.hpp"

#include <algorithm>
#include <utility>

#include "sumo/files/truth.hpp"
#include "sumo/live/person_hints.hpp"
#include "sumo/plan/outside_walkers.hpp"

namespace pedzone {
namespace {

constexpr double kNewPlan = 2.0;  // numerical: steps until somebody with another plan walks by it

}  // namespace

Takeover::Takeover(const Network& network, const std::vector<Zone>& zones,
                   std::vector<std::unique_ptr<Crowd>>& crowds, const Profiles& profiles,
                   const std::vector<WaypointPath>& paths, WalkSpeeds walk_speeds, double dawdling,
                   bool alone, SumoPersons& sumo)
    : network_(network),
      zones_(zones),
      crowds_(crowds),
      profiles_(profiles),
      paths_(paths),
      walk_speeds_(std::move(walk_speeds)),
      alone_(alone),
      sumo_(sumo),
      striping_share_(striping_share(dawdling)),
      zone_of_edge_(zones_of_edges(network, zones)),
      entries_(entries_of_zones(network, zone_of_edge_)),
      bystanders_(zones),
      edge_teller_(network, sumo),
      seen_(zones.size()) {}

void Takeover::read(double time, const Fleet& fleet) {
  look_at_bystanders(time);
  for (const Bystander& person : bystanders_.gone()) {
    if (person.guest) guests_[guest_index_.at(person.id)].gone = true;
    past_.erase(person.id);  // somebody else may get its id
  }
  drop_gone();
  check_guests(time, fleet);
  take_new(time, fleet);
  show_bystanders(fleet);
}

void Takeover::take_new(double time, const Fleet& fleet) {
  std::erase_if(replanned_, [&](const auto& one) { return time > one.second.until; });
  for (Bystander& person : bystanders_.all()) {
    if (!person.near || person.guest) continue;
    const bool was_moved = person.external;
    if (was_moved && !has_come_back(person, time)) continue;
    const std::string edge = sumo_.edge(person.id);
    // Outside of the zones it is SUMO's in every stage: that one need not be asked of SUMO.
    const int stages = zone_of(edge) < 0 ? 0 : sumo_.stages_left(person.id);
    const bool is_barred = edge == person.barred_edge && stages == person.barred_stages;
    if (is_barred && !was_moved) continue;
    if (!was_moved && zone_of(edge) >= 0 && is_declared(person.id)) {
      let_others_walk(person.id, true, time);
      continue;
    }
    const auto replanned = replanned_.find(person.id);
    const Vec2* position = replanned != replanned_.end() ? &replanned->second.position
                           : was_moved                   ? &person.position
                                                         : nullptr;
    const bool may_be_ours = consider(person.id, edge, stages, position, fleet);
    person.barred_edge = may_be_ours ? "" : edge;
    person.barred_stages = stages;
    if (was_moved && !person.guest) put_back(person, edge);
  }
}

/// Where it stands nobody can take it over, and SUMO would have it stand there for ever. Whom SUMO
/// walks is not touched: that ends SUMO.
void Takeover::put_back(const Bystander& person, const std::string& edge) {
  if (!is_to_be_put_back(person, edge) || !sumo_.walks(person.id)) return;
  const std::vector<int> route = edge_indices(network_, sumo_.edges(person.id));
  const auto plan = plan_let_go(network_, route, static_cast<int>(route.size()) - 1,
                                person.position, person.radius, sumo_.lane(person.id));
  if (plan) sumo_.release(person.id, *plan);
}

bool Takeover::is_declared(const std::string& id) const {
  return is_true(sumo_.parameter(id, "pedzone.external"));
}

void Takeover::let_others_walk(const std::string& id, bool declared, double time) {
  outsiders_.push_back({time, id});
  Bystander* person = bystanders_.find(id);
  if (person == nullptr) return;
  if (person->radius == 0.0) measure(*person, sumo_.size(id));
  person->looked_at = -1.0;  // where it was before pedzone walked it tells nothing
  bystanders_.look(*person, time, sumo_.position(id));
  leave_to_others(*person, time, declared);
}

bool Takeover::has_come_back(Bystander& person, double time) const {
  return is_to_be_asked(person, time) && comes_back(person, is_declared(person.id));
}

void Takeover::look_at_bystanders(double time) {
  // Read in each step: whom a program removes between two of them is in no list of SUMO's.
  bystanders_.update(sumo_.ids());
  for (Bystander& person : bystanders_.all()) {
    if (Bystanders::is_due(person, time)) {
      bystanders_.look(person, time, sumo_.position(person.id));
    }
  }
}

/// Lets the crowds see who else is near.
void Takeover::show_bystanders(const Fleet& fleet) {
  eyes_.clear();
  for (const Guest& guest : guests_) eyes_.push_back(guest.position);
  for (const FleetVehicle& vehicle : fleet.vehicles()) {
    eyes_.insert(eyes_.end(), {vehicle.front, vehicle.centre()});
  }
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    seen_[z].clear();
    bystanders_.seen_from(z, eyes_, in_sight_);
    for (Bystander* person : in_sight_) {
      if (rides(*person)) continue;
      if (person->radius == 0.0) measure(*person, sumo_.size(person->id));
      seen_[z].push_back(seen(*person, sumo_.speed(person->id), sumo_.heading(person->id)));
    }
    crowds_[z]->see(seen_[z]);
  }
}

/// A program that embeds us may have given a person another plan: it is then taken over anew,
/// from where it stands, if the new plan still leads through the zone.
void Takeover::check_guests(double time, const Fleet& fleet) {
  std::vector<std::pair<std::string, Vec2>> replanned;
  std::vector<std::string> moved;
  const double interval = alone_ ? kPlanIntervalAlone : kPlanInterval;
  for (Guest& guest : guests_) {
    if (alone_ && time < guest.watch.check_at) continue;
    const int left = sumo_.stages_left(guest.id);
    if (!is_due(guest.watch, time, left)) continue;
    note_look(guest.watch, time, left, interval);
    follow_speed(guest);
    const GuestFinding found = what_happened(guest.watch, sumo_.plan(guest.id), guest.position,
                                             [&] { return sumo_.position(guest.id); });
    guest.gone = found != GuestFinding::kUnchanged;
    if (found == GuestFinding::kMoved) moved.push_back(guest.id);
    if (found == GuestFinding::kReplanned) replanned.emplace_back(guest.id, guest.position);
  }
  drop_gone();
  for (const std::string& id : moved) let_others_walk(id, false, time);
  for (const auto& [id, position] : replanned) {
    PersonPast& past = past_[id];
    past = with_new_plan(past);
    consider(id, sumo_.edge(id), sumo_.stages_left(id), &position, fleet);
    // With removeStages its new walk begins with the next step, and in SUMO's old place.
    if (guest(id) == nullptr) replanned_[id] = {position, time + kNewPlan * dt_};
  }
}

/// A program that embeds us, or another client of SUMO's, may have told it to walk at another
/// speed.
void Takeover::follow_speed(Guest& guest) {
  if (!guest.top_speed) return;
  const double top = sumo_.top_speed(guest.id);
  if (top == *guest.top_speed) return;
  guest.top_speed = top;
  guest.preferred_speed = striping_share_ * std::max(0.0, top);
  crowds_[guest.zone]->set_preferred_speed(guest.handle, guest.preferred_speed);
}

/// -1: SUMO's, or not in the network.
int Takeover::zone_of(const std::string& edge) const {
  const auto found = network_.edge_index.find(edge);
  return found == network_.edge_index.end() ? -1 : zone_of_edge_[found->second];
}

/// Whether SUMO is about to walk it on across the end of a street. (Where people cross streets
/// anywhere they need not go there.)
bool Takeover::is_about_to_round_end(int edge, const WalkerSeen& walker) const {
  return touches_street_end(network_, edge) && walker.edges.size() > 1 &&
         leads_round_street_end(network_, sumo_.next_edge(walker.id));
}

/// False where it need not be asked again for as long as the person is on this edge in this stage.
bool Takeover::consider(const std::string& id, const std::string& edge_id, int stages_left,
                        const Vec2* known_position, const Fleet& fleet) {
  const int zone = zone_of(edge_id);
  if (zone < 0) {  // whoever comes back is looked at again
    if (const auto past = past_.find(id); past != past_.end()) past->second.refused_edge = -1;
    return consider_entry(id, edge_id, known_position, fleet);
  }
  const int edge = network_.edge_index.at(edge_id);
  PersonPast& past = past_[id];
  if (past.refused_edge == edge && past.refused_stages == stages_left) return false;
  past.refused_stages = stages_left;
  auto walker = sumo_.walker(id);
  if (!walker) return true;
  if (known_position != nullptr) {
    walker->position = *known_position;
  } else if (zones_[zone].streets.empty() && is_about_to_round_end(edge, *walker)) {
    return true;
  }
  const auto plan =
      plan_takeover(network_, zones_[zone], edge, *walker, known_position != nullptr, fleet, past);
  if (!plan || !add_guest(*walker, zone, *plan, fleet)) return true;
  totals_.take_over(past, known_position != nullptr);
  return true;
}

/// False where nobody comes to a zone from that edge.
bool Takeover::consider_entry(const std::string& id, const std::string& edge_id,
                              const Vec2* known_position, const Fleet& fleet) {
  constexpr double kFastest = 3.0;  // [m/s] numerical: who is farther away need not be asked for
  const auto edge = network_.edge_index.find(edge_id);
  if (edge == network_.edge_index.end() || !entries_[edge->second]) return false;
  const bool was_moved = known_position != nullptr;
  const Lane& lane = network_.lanes[walking_lane(network_, edge->second)];
  const Vec2& at = bystanders_.find(id)->position;
  const double reach = kFastest * dt_ + 0.5 * lane.width;
  const auto is_near = [&](const Vec2& end) { return (end - at).norm() < reach; };
  const bool near = is_near(lane.shape.front()) || is_near(lane.shape.back());
  if (!was_moved && (!near || is_declared(id))) return true;
  auto walker = sumo_.walker(id);
  if (!walker) return true;
  if (was_moved) walker->position = *known_position;
  PersonPast& past = past_[id];
  const auto entry = plan_entry(network_, zones_, zone_of_edge_, edge->second, *walker, was_moved,
                                dt_, fleet, past);
  if (entry && add_guest(*walker, entry->zone, entry->plan, fleet)) {
    totals_.take_over(past, was_moved);
  }
  return true;
}

/// False where there is no room beside a vehicle, and for who would rather cross at a junction
/// outside the zone; nothing else has changed then.
bool Takeover::add_guest(const WalkerSeen& walker, int zone, const TakeoverPlan& plan,
                         const Fleet& fleet) {
  Guest guest;
  guest.id = walker.id;
  guest.zone = zone;
  guest.stretch = plan.stretch;
  guest.edges = plan.edges;
  guest.watch.plan = plan.plan;
  guest.radius = walker.radius;
  const auto told = walk_speeds_.of(walker.id, walker.stages_left, walker.length);
  guest.preferred_speed = striping_share_ * told.value_or(walker.top_speed);
  if (!told) guest.top_speed = walker.top_speed;
  const PersonHints hints = read_hints(sumo_, walker.id, {profiles_, paths_});
  guest.handle = crowds_[zone]->add(
      new_person(walker, plan, hints, static_cast<std::size_t>(zone), guest.preferred_speed));
  const PersonView view = crowds_[zone]->view(guest.handle);
  guest.position = view.position;
  const Entry entry = entry_of(plan, view, guest.radius, fleet, dt_);
  if (entry != Entry::kWalks) {
    if (entry == Entry::kStaysOutside) {
      past_[walker.id].refused_edge = network_.edge_index.at(sumo_.edge(walker.id));
    }
    crowds_[zone]->remove(guest.handle);
    return false;
  }
  bystanders_.set_guest(walker.id, true);
  guest_index_[walker.id] = guests_.size();
  guests_.push_back(std::move(guest));
  return true;
}

/// How a person goes back to SUMO in this step; nothing: not yet.
std::optional<ReleasePlan> Takeover::hand_over(Guest& guest, const PersonView& view, double dt,
                                               const Fleet& fleet) const {
  if (!view.arrived || !is_plan_sure(guest.watch, sumo_.plan(guest.id))) return std::nullopt;
  const Walked walked{guest.position, view.position, guest.radius, guest.preferred_speed,
                      ends_trip(guest.stretch, guest.watch.stages_left)};
  ReleasePlan plan = plan_release(network_, guest.stretch, walked, sumo_.lane(guest.id), dt);
  if (!go_ahead_of_vehicles(network_, guest.stretch, fleet, dt, guest.kept, plan) ||
      !may_hand_over(walked, place_of(network_, plan), fleet, dt, guest.kept)) {
    return std::nullopt;
  }
  return plan;
}

void Takeover::give_back(const Guest& guest, const ReleasePlan& plan) {
  PersonPast& past = past_[guest.id];
  past.last = guest.stretch.last;
  if (!plan.moves.empty()) edge_teller_.note_release(plan.moves.back().lane);
  totals_.give_back(past, sumo_.release(guest.id, plan));
}

const Guest* Takeover::guest(std::size_t zone, Crowd::Handle handle) const {
  const auto found = std::ranges::find_if(guests_, [&](const Guest& one) {
    return one.zone == static_cast<int>(zone) && one.handle == handle;
  });
  return found == guests_.end() ? nullptr : &*found;
}

void Takeover::list_jams(double time) {
  for (std::size_t z = 0; z < crowds_.size(); ++z) {
    for (const JamNotice& jam : crowds_[z]->jams()) {
      const Guest* const found = guest(z, jam.handle);
      if (found != nullptr) jams_.push_back({time, found->id, zones_[z].id, jam.position});
    }
  }
}

void Takeover::write(double time, double dt, const Fleet& fleet) {
  list_jams(time);
  dt_ = dt;
  edge_teller_.begin_step(time);
  for (Guest& guest : guests_) {
    const PersonView view = crowds_[guest.zone]->view(guest.handle);
    totals_.walk(guest.position, view, guest.preferred_speed, dt);
    const auto plan = hand_over(guest, view, dt, fleet);
    const bool lands = plan && plan->remove_stage && !guest.landed &&
                       !ends_trip(guest.stretch, guest.watch.stages_left);
    guest.gone = plan && !lands;
    // Before it is released: it may be over then.
    guest.colour.show(sumo_, guest.id, guest.gone ? Activity::kNone : view.activity);
    if (guest.gone) {
      give_back(guest, *plan);
    } else if (lands) {
      sumo_.land(guest.id, view.position, view.heading);
    }
    guest.landed = lands;
  }
  for (Guest& guest : guests_) {
    const PersonView view = crowds_[guest.zone]->view(guest.handle);
    if (!guest.gone && !guest.landed) show(guest, view, fleet);
    guest.position = view.position;
  }
  drop_gone();
}

/// To be called when all releases of the step are done.
void Takeover::show(Guest& guest, const PersonView& view, const Fleet& fleet) {
  edge_teller_.tell(guest.id, guest.edges, guest.watch, guest.position, guest.radius, fleet,
                    bystanders_);
  sumo_.show(guest.id, view.position, view.heading);
}

std::vector<std::string> Takeover::let_go() {
  std::vector<std::string> stranded;
  for (Guest& guest : guests_) {
    const std::vector<int> route = edge_indices(network_, sumo_.edges(guest.id));
    const auto plan = plan_let_go(network_, route, guest.stretch.last, guest.position, guest.radius,
                                  sumo_.lane(guest.id));
    guest.colour.show(sumo_, guest.id, Activity::kNone);
    if (!plan) {
      stranded.push_back(guest.id);
      continue;
    }
    guest.gone = true;
    give_back(guest, *plan);
  }
  drop_gone();
  return stranded;
}

void Takeover::drop_gone() {
  const auto gone = [](const Guest& guest) { return guest.gone; };
  if (std::none_of(guests_.begin(), guests_.end(), gone)) return;
  for (const Guest& guest : guests_) {
    if (!guest.gone) continue;
    crowds_[guest.zone]->remove(guest.handle);
    bystanders_.set_guest(guest.id, false);
  }
  std::erase_if(guests_, gone);
  guest_index_.clear();
  for (std::size_t i = 0; i < guests_.size(); ++i) guest_index_[guests_[i].id] = i;
}

const Guest* Takeover::guest(const std::string& id) const {
  const auto found = guest_index_.find(id);
  return found == guest_index_.end() ? nullptr : &guests_[found->second];
}

bool Takeover::rides(const Bystander& person) const { return !sumo_.vehicle(person.id).empty(); }

void Takeover::people(std::vector<PersonAhead>& out) {
  out.clear();
  for (const Guest& guest : guests_) {
    const PersonView view = crowds_[guest.zone]->view(guest.handle);
    const bool leaves = guest.stretch.release == Release::kLeave && guest.stretch.forward;
    out.push_back({view.position, view.velocity, guest.radius, view.crosswalk,
                   std::max(0.0, guest.radius - view.radius), leaves ? guest.stretch.lane : -1,
                   view.crosses});
  }
  for (const Bystander& person : bystanders_.all()) {
    if (person.external && person.near && !rides(person)) {
      out.push_back({person.position, person.velocity, person.radius});
    }
  }
}

void Takeover::sumo_people(std::vector<PersonAhead>& out) {
  out.clear();
  for (const Bystander& person : bystanders_.all()) {
    if (person.guest || person.external || !person.near || rides(person)) continue;
    PersonAhead& ahead = out.emplace_back();  // with a usual radius until it is measured
    ahead.position = person.position;
    ahead.velocity = person.velocity;
    if (person.radius > 0.0) ahead.radius = person.radius;
  }
}

}  // namespace pedzone
