#include "sumo/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "core/error.hpp"
#include "crowd/zone_models.hpp"
#include "sumo/files/hint_values.hpp"
#include "sumo/files/path_vehicles.hpp"
#include "sumo/files/type_files.hpp"
#include "sumo/live/gui_view.hpp"
#include "sumo/live/stuck_watch.hpp"
#include "sumo/live/vehicle_reader.hpp"
#include "sumo/live/zone_marks.hpp"
#include "sumo/panel_people.hpp"
#include "sumo/plan/insertions.hpp"
#include "sumo/plan/lane_keeping.hpp"
#include "sumo/plan/stand_off.hpp"
#include "sumo/plan/steering.hpp"
#include "sumo/plan/told.hpp"
#include "sumo/plan/yielding.hpp"
#include "zone/any_zones.hpp"
#include "zone/shapes.hpp"

namespace pedzone {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double number_option(const Session& session, const std::string& name) {
  return std::strtod(session.option(name).c_str(), nullptr);
}

std::string time_text(double time) { return std::to_string(time) + " s"; }

/// The paths themselves, once their vehicles are known to be there.
const std::vector<VehiclePath>& known_vehicles(const SimulationOptions& options) {
  require_vehicles(options.scenario, options.vehicle_paths);
  return options.vehicle_paths;
}

std::unique_ptr<Session> open_session(const SimulationOptions& options, const Scenario& scenario) {
  if (options.attach) {
    return join_over_traci(*options.attach, read_type_files<DesiredSpeeds>(scenario));
  }
  if (options.own) {
    return start_own(*options.own, scenario.config,
                     words_for_sumo(scenario, options.seed, options.end),
                     read_type_files<DesiredSpeeds>(scenario));
  }
  return start_in_process(scenario.config, words_for_sumo(scenario, options.seed, options.end));
}

Stuck stuck_of(const Standstills& found) { return {found.all(), found.most(), found.most_at()}; }

}  // namespace

struct Simulation::Parts {
  explicit Parts(const SimulationOptions& options)
      : network(read_scenario_network(options.scenario)),
        zones(options.needs_zone ? build_zones(network, with_models(options.zones))
                                 : build_any_zones(network, with_models(options.zones))),
        paths(read_paths(options)),
        steering(known_vehicles(options)),
        panel_people(options, network, zones),
        session(open_session(options, panel_people.scenario())),
        begin(session->time()),
        end(options.end),
        vehicles(network, session->vehicles()),
        fleet(network, zones),
        yielding(zones),
        lane_keeping(zones),
        insertions(network, read_departures(panel_people.scenario(), network, zone_edges(), begin,
                                            end_time())),
        stand_offs(zones),
        attached(options.attach.has_value()),
        alone(options.alone),
        among_clients(!alone && number_option(*session, "num-clients") > 1.0),
        seed(options.seed ? *options.seed
                          : static_cast<std::uint64_t>(number_option(*session, "seed"))),
        profiles(options.profiles),
        crowds(make_crowds()),
        takeover(network, zones, crowds, profiles, paths,
                 read_type_files<WalkSpeeds>(panel_people.scenario()),
                 number_option(*session, "pedestrian.striping.dawdling"), alone,
                 session->persons()),
        gui(session->view(), session->persons(), crowds, takeover, options.screenshots) {
    if (session->option("pedestrian.model") != "striping") {
      throw InputError("is a pedestrian model that pedzone cannot take persons over from",
                       {options.scenario.config, 0, "option pedestrian.model",
                        session->option("pedestrian.model"), "striping"});
    }
    if (attached) join();
    gui.begin(zones, paths);
  }

  std::vector<WaypointPath> read_paths(const SimulationOptions& options) const {
    std::vector<WaypointPath> found = find_paths(network, zones, options.paths);
    require_known_hints(options.scenario, {options.profiles, found});
    return found;
  }

  std::vector<std::unique_ptr<Crowd>> make_crowds() {
    std::vector<std::unique_ptr<Crowd>> made;
    for (const Zone& zone : zones) made.push_back(std::make_unique<Crowd>(zone, seed));
    return made;
  }

  /// [s] below 0: open.
  double end_time() const { return end.value_or(session->end_time()); }

  std::vector<int> zone_edges() const {
    std::vector<int> edges;
    for (const Zone& zone : zones) edges.insert(edges.end(), zone.edges.begin(), zone.edges.end());
    return edges;
  }

  void join();
  void leave();
  template <typename Work>
  void with_time_of_errors(const Work& work);
  std::size_t people_in_sumo();
  void read(double dt);
  void forget(const std::string& vehicle);
  void send(const std::vector<SpeedOrder>& orders);
  void walk_and_yield(double dt);

  Clock::time_point started = Clock::now();
  double sumo_seconds = 0.0;
  Network network;
  std::vector<Zone> zones;
  std::vector<WaypointPath> paths;
  Steering steering;
  PanelPeople panel_people;
  std::unique_ptr<Session> session;
  double begin;               ///< [s] when this began
  std::optional<double> end;  ///< [s] what was asked for
  VehicleReader vehicles;
  Fleet fleet;
  SafeSpeeds safe_speeds = session->vehicles().safe_speeds();
  Told told;
  OutsideDrivers drivers{told};
  Yielding yielding;
  LaneKeeping lane_keeping;
  Insertions insertions;
  StandOffs stand_offs;
  bool attached;       ///< SUMO runs on without us
  bool alone;          ///< nobody else moves anybody
  bool among_clients;  ///< SUMO has others beside this one
  std::uint64_t seed;
  Profiles profiles;
  std::vector<std::unique_ptr<Crowd>> crowds;
  Takeover takeover;
  PushRecords pushes{zones, crowds, takeover, fleet};
  CrossingRecords crossings{zones, crowds, takeover};
  RunTotals totals;
  StuckWatch stuck{zones, crowds, takeover, *session};
  GuiView gui;
  ObservationReader reader{fleet, takeover, crowds, session->persons()};
  std::function<void(const Observation&)> observer;
  bool stepped = false;  ///< SUMO has done a step
  bool lost = false;     ///< it is there no more
  std::vector<std::string> stranded;
  std::vector<PersonAhead> people, outside;
  std::vector<VehicleState> states;
};

/// A SUMO that others started may have another network than its configuration says.
void Simulation::Parts::join() {
  try {
    mark_zones(*session, network, zones);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError("is not the network that SUMO runs: " + std::string(error.what()),
                     {network.file, 0, "", "", "the configuration with which SUMO was started"});
  }
}

void Simulation::Parts::leave() {
  SumoVehicles& sumo = session->vehicles();
  sumo.send(told.take_back(sumo.ids()));
  stranded = takeover.let_go();
  unmark_zones(*session, network, zones);
}

/// As it was known last where SUMO is there no more.
std::size_t Simulation::Parts::people_in_sumo() {
  return lost ? takeover.bystanders().all().size() : session->persons().ids().size();
}

/// What was known of that vehicle does not hold for the next one of its id.
void Simulation::Parts::forget(const std::string& vehicle) {
  session->vehicles().forget(vehicle);
  vehicles.forget(vehicle);
  told.forget(vehicle);
  drivers.forget(vehicle);
  yielding.forget(vehicle);
  stand_offs.forget(vehicle);
  fleet.forget(vehicle);
  totals.forget(vehicle);
}

/// Takes in SUMO's present state and shows it.
void Simulation::Parts::read(double dt) {
  for (const std::string& id : session->vehicles().new_or_gone()) forget(id);
  for (const std::string& id : session->vehicles().teleported()) fleet.teleport(id);
  std::vector<VehicleSeen> seen = vehicles.read(fleet, told, session->time());
  if (!alone) drivers.mark(seen, steering.steered(), session->time(), dt);
  fleet.update(std::move(seen), dt);
  steering.foresee(fleet, session->time(), dt);
  takeover.read(session->time(), fleet);
  totals.observe(fleet, takeover);
  stuck.update(session->time());
  // SUMO's outputs name a step by the time at which it began.
  if (observer && stepped) observer(reader.read(session->time() - dt));
}

void Simulation::Parts::send(const std::vector<SpeedOrder>& orders) {
  told.note(orders);
  session->vehicles().send(orders);
}

/// From SUMO's present state to what it is told for its next step.
void Simulation::Parts::walk_and_yield(double dt) {
  SumoVehicles& sumo = session->vehicles();
  read(dt);
  takeover.people(people);
  takeover.sumo_people(outside);
  const PeopleNear near(people);
  send(yielding.plan(fleet.vehicles(), near, outside, safe_speeds, session->time(), dt));
  send(lane_keeping.plan(fleet, near, dt));
  people.insert(people.end(), outside.begin(), outside.end());
  send(stand_offs.plan(fleet.vehicles(), people, dt));
  fleet.states(dt, states);
  insertions.add_claims(session->time(), dt, sumo.pending(), fleet, states);
  for (std::size_t z = 0; z < crowds.size(); ++z) crowds[z]->step(dt, fleet.states_near(z, states));
  for (const std::string& id : pushes.take(session->time(), dt)) yielding.stop(id);
  crossings.take(session->time());
  takeover.write(session->time(), dt, fleet);
  gui.update();
  if (steering.over()) return;
  const auto length = [&](const std::string& id) { return sumo.length(id); };
  sumo.send(steering.plan(session->time(), sumo.ids(), length));
}

Simulation::Simulation(const SimulationOptions& options) {
  try {
    parts_ = std::make_unique<Parts>(options);
  } catch (const InputError&) {
    throw;
  } catch (const SumoError&) {
    throw;
  } catch (const std::exception& error) {
    if (!options.attach && !options.own) throw;
    throw SumoError("SUMO has gone while pedzone joined it: " + std::string(error.what()) +
                    " (Another client broke off, or has not told its order with setOrder.)");
  }
}

Simulation::~Simulation() = default;

/// Runs what talks to SUMO and turns what SUMO throws into a SumoError.
template <typename Work>
void Simulation::Parts::with_time_of_errors(const Work& work) {
  const auto gone = [this] {
    lost = true;
    return ConnectionLost("SUMO has gone at " + time_text(session->time()) +
                          ": it was closed, or another client broke off, or it died. (It ends in "
                          "the first step where two clients have the same order.)");
  };
  try {
    work();
  } catch (const InputError&) {
    throw;
  } catch (const ConnectionLost&) {
    throw gone();
  } catch (const SumoError&) {
    throw;
  } catch (const std::exception& error) {
    if (session->is_lost(error)) throw gone();
    throw SumoError("SUMO refused a call at " + time_text(session->time()) + ": " + error.what());
  }
}

void Simulation::step() {
  parts_->with_time_of_errors([this] {
    parts_->walk_and_yield(parts_->session->step_length());
    const Clock::time_point before = Clock::now();
    parts_->session->step();
    parts_->stepped = true;
    parts_->sumo_seconds += seconds_since(before);
    parts_->totals.count_persons(parts_->session->departed_persons(),
                                 parts_->session->arrived_persons());
    parts_->totals.count_events(parts_->session->events());
  });
}

bool Simulation::finished() const {
  const double end = end_time();
  return end >= 0.0 ? parts_->session->time() >= end : parts_->session->nobody_left();
}

void Simulation::observe(std::function<void(const Observation&)> observer) {
  parts_->observer = std::move(observer);
}

void Simulation::close() {
  if (parts_->lost) return;
  parts_->with_time_of_errors([this] {
    if (parts_->observer) parts_->read(parts_->session->step_length());
    if (parts_->attached) parts_->leave();
    parts_->session->close();
  });
}

const std::vector<std::string>& Simulation::stranded() const { return parts_->stranded; }
double Simulation::time() const { return parts_->session->time(); }
double Simulation::step_length() const { return parts_->session->step_length(); }
double Simulation::end_time() const { return parts_->end_time(); }
const std::vector<Zone>& Simulation::zones() const { return parts_->zones; }
const Network& Simulation::network() const { return parts_->network; }
const std::vector<WaypointPath>& Simulation::paths() const { return parts_->paths; }
const std::vector<Guest>& Simulation::guests() const { return parts_->takeover.guests(); }
const std::vector<JamRecord>& Simulation::jams() const { return parts_->takeover.jams(); }
const std::vector<OutsideRecord>& Simulation::outside_vehicles() const {
  return parts_->drivers.found();
}
const std::vector<OutsideRecord>& Simulation::outside_persons() const {
  return parts_->takeover.outsiders();
}
bool Simulation::misses_drivers() const {
  return parts_->among_clients && !parts_->lost && !parts_->drivers.any();
}
const std::vector<StreetCrossed>& Simulation::crossings() const { return parts_->crossings.all(); }
const std::vector<RunIntoRecord>& Simulation::run_into() const { return parts_->pushes.run_into(); }
PersonView Simulation::view(const Guest& guest) const {
  return parts_->crowds[guest.zone]->view(guest.handle);
}

std::vector<Passer> Simulation::passers() const {
  std::vector<Passer> passers;
  const SumoPersons& sumo = parts_->session->persons();
  for (const std::string& id : sumo.ids()) {
    if (parts_->takeover.guest(id) != nullptr || !sumo.vehicle(id).empty()) continue;
    passers.push_back({id, sumo.position(id), sumo.heading(id)});
  }
  return passers;
}

Region Simulation::ground(bool everything) const {
  std::vector<Region> parts;
  for (const Zone& zone : zones()) {
    parts.push_back(zone.walkable);
    parts.push_back(zone.crossable);
  }
  if (everything) {
    for (const Lane& lane : network().lanes) {
      if (lane.persons) parts.push_back(area_of(lane));
    }
  }
  return unite(parts);
}

bool Simulation::warns() const {
  return parts_->session->option("no-warnings") == "false" &&
         parts_->session->option("aggregate-warnings") == "-1";
}

bool Simulation::miscounts_walking() const {
  return !zones().empty() && !parts_->session->option("person-summary-output").empty();
}

const Standstills& Simulation::stuck_persons() const { return parts_->stuck.persons(); }

std::vector<Insight> Simulation::insights() {
  const std::vector<Guest>& all = guests();
  std::vector<Insight> insights(all.size());
  for (std::size_t z = 0; z < parts_->crowds.size(); ++z) {
    std::vector<Crowd::Handle> handles;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].zone != static_cast<int>(z)) continue;
      handles.push_back(all[k].handle);
      places.push_back(k);
    }
    std::vector<Insight> some = parts_->crowds[z]->insights(handles);
    for (std::size_t k = 0; k < some.size(); ++k) insights[places[k]] = std::move(some[k]);
  }
  return insights;
}

RunSummary Simulation::summary() const {
  std::size_t in_sumo = 0;
  parts_->with_time_of_errors([&] {
    in_sumo = parts_->people_in_sumo();
    if (!parts_->lost) parts_->stuck.look(time());
  });
  RunSummary summary =
      parts_->totals.summary(parts_->takeover, parts_->pushes, parts_->yielding, in_sumo);
  if (std::ranges::any_of(zones(), [](const Zone& zone) { return !zone.streets.empty(); })) {
    summary.crossings = totals_of(crossings());
  }
  summary.stuck_persons = stuck_of(parts_->stuck.persons());
  summary.stuck_vehicles = stuck_of(parts_->stuck.vehicles());
  summary.time.simulated_s = time() - parts_->begin;
  summary.time.wall_s = seconds_since(parts_->started);
  summary.time.sumo_s = parts_->sumo_seconds;
  summary.time.pedzone_s = summary.time.wall_s - parts_->sumo_seconds;
  if (summary.time.person_steps > 0) {
    summary.time.us_per_person_step =
        1e6 * summary.time.pedzone_s / static_cast<double>(summary.time.person_steps);
  }
  return summary;
}

}  // namespace pedzone
