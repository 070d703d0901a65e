#include "sumo/calls/session.hpp"

#include "sumo/calls/api.hpp"
#include "sumo/calls/both.hpp"

namespace pedzone::PEDZONE_CALLS {
namespace {

using api::Simulation;

class SessionCalls final : public Session {
 public:
  ~SessionCalls() override {
    try {
      SessionCalls::close();
    } catch (...) {  // a destructor must not throw; an explicit close() reports
    }
  }

  SumoPersons& persons() override { return *persons_; }
  SumoVehicles& vehicles() override { return *vehicles_; }
  SumoView* view() override { return view_.get(); }

  void step() override {
    const double before = SessionCalls::time();
    translated("in the step after " + std::to_string(before) + " s", [] { Simulation::step(); });
    const double now = SessionCalls::time();
    if (now >= before) return;
    throw SumoError("SUMO's time went back from " + std::to_string(before) + " s to " +
                    std::to_string(now) +
                    " s: another client has loaded something. pedzone cannot go on from there.");
  }

  void close() override {
    if (!open_) return;
    open_ = false;
    translated("to close", [] { Simulation::close(); });
  }

  double time() const override { return Simulation::getTime(); }
  double step_length() const override { return step_length_; }
  double end_time() const override { return end_time_; }
  bool nobody_left() const override { return Simulation::getMinExpectedNumber() <= 0; }
  long departed_persons() const override { return Simulation::getDepartedPersonNumber(); }
  long arrived_persons() const override { return Simulation::getArrivedPersonNumber(); }

  SumoEvents events() const override {
    SumoEvents events;
    events.teleports = Simulation::getStartingTeleportNumber();
    events.emergency_stops = Simulation::getEmergencyStoppingVehiclesNumber();
    for (const auto& collision : Simulation::getCollisions()) {
      events.collisions.push_back({collision.collider, collision.victim});
    }
    return events;
  }

  /// What SUMO refuses it answers; all else comes of the connection.
  bool is_lost(const std::exception& error) const override {
    return api::kRemote && dynamic_cast<const libsumo::TraCIException*>(&error) == nullptr;
  }

  std::string option(const std::string& name) const override {
    return translated("to tell option " + name, [&] { return Simulation::getOption(name); });
  }

  std::string edge_parameter(const std::string& edge, const std::string& key) const override {
    return api::Edge::getParameter(edge, key);
  }

  void set_edge_parameter(const std::string& edge, const std::string& key,
                          const std::string& value) override {
    api::Edge::setParameter(edge, key, value);
  }

 private:
  std::unique_ptr<SumoPersons> persons_ = person_calls();
  std::unique_ptr<SumoVehicles> vehicles_ = vehicle_calls();
  std::unique_ptr<SumoView> view_ = view_calls();
  double step_length_ = Simulation::getDeltaT(), end_time_ = Simulation::getEndTime();
  bool open_ = true;
};

}  // namespace

std::unique_ptr<Session> session_calls() { return std::make_unique<SessionCalls>(); }

}  // namespace pedzone::PEDZONE_CALLS
