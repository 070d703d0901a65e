// A program that embeds pedzone and meddles with the persons between two steps, as programs that
// control a simulation do: removes persons in mid-walk, sends them elsewhere, gives them new
// stages, adds new ones. Which person, when and how is drawn from a seed.
//
//   meddler SCENARIO SEED EVENTS [TRAJECTORIES | --plain] [-- SUMO OPTIONS]
//
// EVENTS: time,event,person, one line an event, for the checks. --plain meddles with plain SUMO,
// without pedzone: what that does not survive is the meddling's fault.
#include <libsumo/libsumo.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/trajectories.hpp"
#include "sumo/calls/session.hpp"
#include "sumo/simulation.hpp"

namespace {

using libsumo::Person;
using Random = std::mt19937_64;

constexpr double kEventsPerSecond = 0.5;
constexpr int kMostAdded = 30;

double draw(Random& random) { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }

std::size_t pick(Random& random, std::size_t count) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

bool is_street(const std::string& edge) { return !edge.empty() && edge[0] != ':'; }

class Meddler {
 public:
  Meddler(unsigned long seed, const std::string& events, double step_length)
      : random_(seed), events_(events), chance_(kEventsPerSecond * step_length) {
    for (const std::string& edge : libsumo::Edge::getIDList()) {
      if (is_street(edge)) streets_.push_back(edge);
    }
  }

  /// Between two steps: mostly nothing, sometimes an event.
  void meddle() {
    if (draw(random_) >= chance_) return;
    const std::vector<std::string> persons = Person::getIDList();
    const std::size_t event = pick(random_, 7);
    if (event == 0 || persons.empty()) {
      add();
      return;
    }
    const std::string person = persons[pick(random_, persons.size())];
    if (Person::getStage(person).type != libsumo::STAGE_WALKING) return;
    switch (event) {
      case 1:
        remove(person);
        break;
      case 2:
        reroute(person);
        break;
      case 3:
        walk_elsewhere_next(person);
        break;
      case 4:
        walk_on_afterwards(person);
        break;
      case 5:
        stop_afterwards(person);
        break;
      default:
        change_speed(person);
        break;
    }
  }

 private:
  void remove(const std::string& person) {
    log("remove", person);
    Person::remove(person);
  }

  /// (Within a junction SUMO 1.15 itself breaks on this, sooner or later.)
  void reroute(const std::string& person) {
    if (!is_street(Person::getRoadID(person))) return;
    log("reroute", person);
    Person::rerouteTraveltime(person);
  }

  /// Another walk after the present one, instead of the last stage. (SUMO 1.15 itself breaks when
  /// the stage that is being walked is replaced or removed.)
  void walk_elsewhere_next(const std::string& person) {
    const std::vector<std::string> edges = Person::getStage(person).edges;
    if (edges.empty() || Person::getRemainingStages(person) != 2) return;
    if (Person::getStage(person, 1).type != libsumo::STAGE_WALKING) return;
    const std::vector<libsumo::TraCIStage> way = libsumo::Simulation::findIntermodalRoute(
        edges.back(), streets_[pick(random_, streets_.size())]);
    if (way.size() != 1 || way[0].type != libsumo::STAGE_WALKING || way[0].edges.empty()) return;
    log("elsewhere", person);
    Person::replaceStage(person, 1, way[0]);
  }

  void walk_on_afterwards(const std::string& person) {
    const std::vector<std::string> edges = Person::getStage(person).edges;
    if (edges.empty() || Person::getRemainingStages(person) > 1) return;
    log("walk_on", person);
    Person::appendWalkingStage(person, {edges.back()}, draw(random_) * lane_length(edges.back()));
  }

  void stop_afterwards(const std::string& person) {
    log("stop", person);
    Person::appendWaitingStage(person, 5.0, "meddled with");
  }

  void change_speed(const std::string& person) {
    log("speed", person);
    Person::setSpeed(person, 0.5 + 1.5 * draw(random_));
  }

  void add() {
    const std::string edge = streets_[pick(random_, streets_.size())];
    const std::string goal = streets_[pick(random_, streets_.size())];
    if (added_ == kMostAdded) return;
    const std::vector<libsumo::TraCIStage> way =
        libsumo::Simulation::findIntermodalRoute(edge, goal);
    if (way.size() != 1 || way[0].type != libsumo::STAGE_WALKING || way[0].edges.empty()) return;
    const std::string person = "added" + std::to_string(added_++);
    log("add", person);
    Person::add(person, edge, draw(random_) * lane_length(edge));
    Person::appendWalkingStage(person, way[0].edges, draw(random_) * lane_length(goal));
  }

  double lane_length(const std::string& edge) { return libsumo::Lane::getLength(edge + "_0"); }

  /// Written at once, so that the last line tells what an abort came from.
  void log(const char* event, const std::string& person) {
    events_ << libsumo::Simulation::getTime() << ',' << event << ',' << person << std::endl;
  }

  Random random_;
  std::ofstream events_;
  double chance_;
  int added_ = 0;
  std::vector<std::string> streets_;
};

void run_plain(const pedzone::Scenario& scenario, unsigned long seed, const std::string& events) {
  const auto session =
      pedzone::start_in_process(scenario.config, pedzone::words_for_sumo(scenario, {}, {}));
  Meddler meddler(seed, events, session->step_length());
  while (session->time() < session->end_time()) {
    meddler.meddle();
    session->step();
  }
  session->close();
}

void run_with_pedzone(const pedzone::Scenario& scenario, unsigned long seed,
                      const std::string& events, const std::string& trajectories) {
  pedzone::SimulationOptions options;
  options.scenario = scenario;
  pedzone::Simulation simulation(options);
  pedzone::TrajectoryWriter writer(trajectories, "TRAJECTORIES");
  Meddler meddler(seed, events, libsumo::Simulation::getDeltaT());
  while (!simulation.finished()) {
    meddler.meddle();
    const double time = simulation.time();  // by which SUMO's outputs name the step's result
    simulation.step();
    for (const pedzone::Guest& guest : simulation.guests()) {
      writer.row(time, guest.id, simulation.view(guest));
    }
  }
  simulation.close();
  writer.finish();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr, "usage: meddler SCENARIO SEED EVENTS TRAJECTORIES|--plain [-- ...]\n");
    return 2;
  }
  try {
    const std::vector<std::string> sumo_options(argv + std::min(argc, 6), argv + argc);
    const pedzone::Scenario scenario = pedzone::read_scenario(argv[1], sumo_options);
    const unsigned long seed = std::strtoul(argv[2], nullptr, 10);
    if (std::string(argv[4]) == "--plain") {
      run_plain(scenario, seed, argv[3]);
    } else {
      run_with_pedzone(scenario, seed, argv[3], argv[4]);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Error: %s\n", error.what());
    return 1;
  }
}
