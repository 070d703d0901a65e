#include "sumo/live/takeover.hpp"

#include <algorithm>

#include "sumo/files/truth.hpp"
#include "sumo/live/person_hints.hpp"

namespace pedzone {
namespace {

constexpr double kPlanInterval = 0.5;  // [s] numerical
constexpr double kMoved = 0.01;        // [m] numerical: SUMO gives back what it is told, exactly
constexpr double kLetGo = 3.0;  // [s] assumed: who is walked from outside seldom stands so still

}  // namespace

Takeover::Takeover(const Network& network, const std::vector<Zone>& zones,
                   std::vector<std::unique_ptr<Crowd>>& crowds, const Profiles& profiles,
                   const std::vector<WaypointPath>& paths, double dawdling, SumoPersons& sumo)
    : network_(network),
      zones_(zones),
      crowds_(crowds),
      profiles_(profiles),
      paths_(paths),
      sumo_(sumo),
      striping_share_(striping_share(dawdling)),
      zone_of_edge_(zones_of_edges(network, zones)),
      bystanders_(zones),
      seen_(zones.size()) {}

void Takeover::read(double time, const Fleet& fleet) {
  look_at_bystanders(time);
  for (const std::string& id : bystanders_.gone()) guests_[guest_index_.at(id)].gone = true;
  drop_gone();
  check_guests(time, fleet);
  take_new(time, fleet);
  show_bystanders(fleet);
}

void Takeover::take_new(double time, const Fleet& fleet) {
  for (Bystander& person : bystanders_.all()) {
    if (!person.near || person.guest) continue;
    const bool was_moved = person.external;
    if (was_moved && !comes_back(person, time)) continue;
    const std::string edge = sumo_.edge(person.id);
    if (edge == person.barred_edge && !was_moved) continue;
    if (!was_moved && zone_of(edge) >= 0 && is_declared(person.id)) {
      leave_to_others(person.id, true, time);
      continue;
    }
    const Vec2* position = was_moved ? &person.position : nullptr;
    const bool may_be_ours = consider(person.id, edge, position, fleet);
    person.barred_edge = may_be_ours ? "" : edge;
    if (was_moved && !person.guest) put_back(person);
  }
}

/// Where it stands nobody can take it over, and SUMO would have it stand there for ever. Whom SUMO
/// walks is not touched: that ends SUMO.
void Takeover::put_back(const Bystander& person) {
  const bool stands = person.velocity == Vec2::Zero() && !sumo_.edge(person.id).starts_with(':');
  if (!stands || !sumo_.walks(person.id)) return;
  const std::vector<int> route = edge_indices(network_, sumo_.edges(person.id));
  const auto plan = plan_let_go(network_, route, static_cast<int>(route.size()) - 1,
                                person.position, person.radius, sumo_.lane(person.id));
  if (plan) sumo_.release(person.id, *plan);
}

/// Where SUMO does not have a person where it was put, another program has put it there.
bool Takeover::is_moved(const Guest& guest) const {
  return (sumo_.position(guest.id) - guest.position).norm() > kMoved;
}

bool Takeover::is_declared(const std::string& id) const {
  return is_true(sumo_.parameter(id, "pedzone.external"));
}

void Takeover::leave_to_others(const std::string& id, bool declared, double time) {
  outsiders_.push_back({time, id});
  Bystander* person = bystanders_.find(id);
  if (person == nullptr) return;
  if (person->radius == 0.0) measure(*person, sumo_.size(id));
  person->external = true;
  person->declared = declared;
  person->ask_at = time + kLetGo;
}

/// Who was declared is ours again when that is taken back; who was noticed, when it has stood for a
/// while at the very place where it was put last.
bool Takeover::comes_back(Bystander& person, double time) const {
  if (!person.declared && person.velocity != Vec2::Zero()) person.ask_at = time + kLetGo;
  if (time < person.ask_at) return false;
  person.ask_at = time + kPlanInterval;
  if (is_declared(person.id)) return false;
  person.external = false;
  return true;
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
      if (!sumo_.vehicle(person->id).empty()) continue;  // rides
      if (person->radius == 0.0) measure(*person, sumo_.size(person->id));
      seen_[z].push_back(seen(*person, sumo_.speed(person->id), sumo_.heading(person->id)));
    }
    crowds_[z]->see(seen_[z]);
  }
}

bool Takeover::has_plan(const Guest& guest) const {
  return plan_number(sumo_.stages_left(guest.id), sumo_.edges(guest.id)) == guest.plan;
}

/// A program that embeds us may have given a person another plan: it is then taken over anew,
/// from where it stands, if the new plan still leads through the zone. Reading plans is dear: each
/// is read twice a second and before it is acted upon, and when the number of stages has changed.
void Takeover::check_guests(double time, const Fleet& fleet) {
  std::vector<std::pair<std::string, Vec2>> replanned;
  std::vector<std::string> moved;
  for (Guest& guest : guests_) {
    const int left = sumo_.stages_left(guest.id);
    if (time < guest.check_at && left == guest.stages_left) continue;
    guest.check_at = time + kPlanInterval;
    guest.stages_left = left;
    const bool planned = has_plan(guest);
    if (planned && !is_moved(guest)) continue;
    guest.gone = true;
    if (planned) {  // SUMO moves a person itself with another plan only
      moved.push_back(guest.id);
      continue;
    }
    replanned.emplace_back(guest.id, guest.position);
  }
  drop_gone();
  for (const std::string& id : moved) leave_to_others(id, false, time);
  for (const auto& [id, position] : replanned) {
    PersonPast& past = past_[id];
    const bool given_back = past.was_given_back;
    past = {};
    past.was_controlled = true;
    past.was_given_back = given_back;
    consider(id, sumo_.edge(id), &position, fleet);
  }
}

/// -1: SUMO's, or not in the network.
int Takeover::zone_of(const std::string& edge) const {
  const auto found = network_.edge_index.find(edge);
  return found == network_.edge_index.end() ? -1 : zone_of_edge_[found->second];
}

/// False where it need not be asked again for as long as the person is on this edge.
bool Takeover::consider(const std::string& id, const std::string& edge_id,
                        const Vec2* known_position, const Fleet& fleet) {
  const int zone = zone_of(edge_id);
  if (zone < 0) {  // whoever comes back is looked at again
    if (const auto past = past_.find(id); past != past_.end()) past->second.refused_edge = -1;
    return false;
  }
  const int edge = network_.edge_index.at(edge_id);
  PersonPast& past = past_[id];
  if (past.refused_edge == edge) return false;
  auto walker = sumo_.walker(id);
  if (!walker) return true;
  if (known_position != nullptr) walker->position = *known_position;
  const auto plan =
      plan_takeover(network_, zones_[zone], edge, *walker, known_position != nullptr, fleet, past);
  if (!plan || !add_guest(*walker, zone, *plan, fleet)) return true;
  if (known_position == nullptr) ++totals_.takeovers;  // else it was ours already
  if (!past.was_controlled) ++totals_.controlled;
  past.was_controlled = true;
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
  guest.plan = plan.plan;
  guest.radius = walker.radius;
  guest.preferred_speed = striping_share_ * walker.top_speed;
  const PersonHints hints = read_hints(sumo_, walker.id, {profiles_, paths_});
  guest.handle = crowds_[zone]->add(
      new_person(walker, plan, hints, static_cast<std::size_t>(zone), guest.preferred_speed));
  guest.position = crowds_[zone]->view(guest.handle).position;
  if (crowds_[zone]->view(guest.handle).stays_outside) {
    // SUMO walks it over the signalled crossing, to which the zone does not reach.
    past_[walker.id].refused_edge = network_.edge_index.at(sumo_.edge(walker.id));
    crowds_[zone]->remove(guest.handle);
    return false;
  }
  if (plan.place_freely && fleet.touches(guest.position, guest.radius)) {
    crowds_[zone]->remove(guest.handle);
    return false;
  }
  bystanders_.set_guest(walker.id, true);
  guest_index_[walker.id] = guests_.size();
  guests_.push_back(std::move(guest));
  return true;
}

/// How a person goes back to SUMO in this step; nothing: not yet. Neither where the crowd has
/// brought it nor where SUMO's lane has it then may a vehicle be in the way. One whose plan has
/// changed is looked at first.
std::optional<ReleasePlan> Takeover::hand_over(Guest& guest, const PersonView& view, double dt,
                                               const Fleet& fleet) const {
  if (!view.arrived) return std::nullopt;
  if (!has_plan(guest)) guest.check_at = 0.0;
  if (guest.check_at <= 0.0) return std::nullopt;
  const Walked walked{guest.position, view.position, guest.radius, guest.preferred_speed};
  ReleasePlan plan = plan_release(network_, guest.stretch, walked, sumo_.lane(guest.id), dt);
  const auto free = [&](const Vec2& place) {
    return may_release(place, guest.radius, fleet, dt, guest.kept);
  };
  const auto place = place_of(network_, plan);
  if (!free(view.position) || (place && !free(*place))) return std::nullopt;
  return plan;
}

void Takeover::give_back(const Guest& guest, const ReleasePlan& plan) {
  if (sumo_.release(guest.id, plan)) ++totals_.ended;
  PersonPast& past = past_[guest.id];
  past.last = guest.stretch.last;
  ++totals_.returns;
  if (!past.was_given_back) ++totals_.given_back;
  past.was_given_back = true;
}

void Takeover::count(const Guest& guest, const PersonView& view, double dt) {
  const double walked = (view.position - guest.position).norm();
  totals_.distance += walked;
  totals_.time += dt;
  if (guest.preferred_speed > 0.0) totals_.free_time += walked / guest.preferred_speed;
  if (view.motion != Motion::kWalking) totals_.waiting += dt;
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
  for (Guest& guest : guests_) {
    const PersonView view = crowds_[guest.zone]->view(guest.handle);
    count(guest, view, dt);
    const auto plan = hand_over(guest, view, dt, fleet);
    guest.gone = plan.has_value();
    // Before it is released: it may be over then.
    guest.colour.show(sumo_, guest.id, guest.gone ? Activity::kNone : view.activity);
    if (plan) {
      give_back(guest, *plan);
    } else {
      sumo_.show(guest.id, view.position, view.heading);
    }
    guest.position = view.position;
  }
  drop_gone();
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

void Takeover::people(std::vector<PersonAhead>& out) const {
  out.clear();
  for (const Guest& guest : guests_) {
    const PersonView view = crowds_[guest.zone]->view(guest.handle);
    out.push_back({view.position, view.velocity, guest.radius, view.zebra});
  }
}

void Takeover::add_outsiders(std::vector<PersonAhead>& out) {
  for (const Bystander& person : bystanders_.all()) {
    if (person.external && person.near) {
      out.push_back({person.position, person.velocity, person.radius});
    }
  }
}

void Takeover::add_bystanders(std::vector<PersonAhead>& out) const {
  for (const auto& near_zone : seen_) {
    for (const SeenPerson& person : near_zone) {
      out.push_back({person.position, person.velocity, person.radius});
    }
  }
}

}  // namespace pedzone
