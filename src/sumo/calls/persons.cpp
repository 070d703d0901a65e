#include "sumo/calls/api.hpp"
#include "sumo/calls/both.hpp"
#include "sumo/files/frames.hpp"

namespace pedzone::PEDZONE_CALLS {
namespace {

constexpr int kKeepRouteFree = 2;  // moveToXY: may leave the network
// [m] moveToXY's matchThreshold: below 0 no lane is ever matched. SUMO looks for lanes in a box
// grown by it; so far below, the box is inside out beyond any network, and the search ends at its
// root (measured: half the call's cost).
constexpr double kNoMatch = -1e7;
constexpr int kKeepRoute = 1;     // moveToXY: onto the route
constexpr double kMatch = 100.0;  // [m] numerical: as far as SUMO looks by default

class PersonCalls final : public SumoPersons {
 public:
  /// Not getIDCount for their number: that counts those who are yet to depart, too.
  std::vector<std::string> ids() const override { return api::Person::getIDList(); }

  Vec2 position(const std::string& id) const override {
    const auto at = api::Person::getPosition(id);
    return {at.x, at.y};
  }

  double heading(const std::string& id) const override {
    return radians_from_sumo(api::Person::getAngle(id));
  }

  double speed(const std::string& id) const override { return api::Person::getSpeed(id); }
  double top_speed(const std::string& id) const override { return api::Person::getMaxSpeed(id); }

  BodySize size(const std::string& id) const override {
    return {api::Person::getLength(id), api::Person::getWidth(id)};
  }

  std::string edge(const std::string& id) const override { return api::Person::getRoadID(id); }

  std::string next_edge(const std::string& id) const override {
    return api::Person::getNextEdge(id);
  }

  std::string lane(const std::string& id) const override { return api::Person::getLaneID(id); }

  std::string vehicle(const std::string& id) const override { return api::Person::getVehicle(id); }

  int stages_left(const std::string& id) const override {
    return api::Person::getRemainingStages(id);
  }

  std::vector<std::string> edges(const std::string& id) const override {
    return api::Person::getEdges(id);
  }

  std::size_t plan(const std::string& id) const override {
    const auto stage = api::Person::getStage(id);
    return plan_number(stages_left(id), stage.edges, stage.arrivalPos);
  }

  bool walks(const std::string& id) const override {
    return api::Person::getStage(id).type == libsumo::STAGE_WALKING;
  }

  std::optional<WalkerSeen> walker(const std::string& id) const override {
    const auto stage = api::Person::getStage(id);
    if (stage.type != libsumo::STAGE_WALKING) return std::nullopt;
    WalkerSeen seen;
    seen.id = id;
    seen.edges = edges(id);
    seen.stages_left = stages_left(id);
    seen.length = stage.length;
    seen.arrival_position = stage.arrivalPos;
    seen.position = position(id);
    seen.heading = heading(id);
    seen.speed = speed(id);
    seen.top_speed = top_speed(id);
    seen.radius = disc_radius(size(id));
    return seen;
  }

  std::string type(const std::string& id) const override { return api::Person::getTypeID(id); }

  std::string parameter(const std::string& id, const std::string& key) const override {
    const std::string own = api::Person::getParameter(id, key);
    return own.empty() ? api::VehicleType::getParameter(type(id), key) : own;
  }

  TraciColour colour(const std::string& id) const override {
    const auto found = api::Person::getColor(id);
    return {found.r, found.g, found.b, found.a};
  }

  void set_colour(const std::string& id, const TraciColour& colour) override {
    api::Person::setColor(id,
                          libsumo::TraCIColor(colour.red, colour.green, colour.blue, colour.alpha));
  }

  void show(const std::string& id, const Vec2& position, double heading) override {
    api::Person::moveToXY(id, "", position.x(), position.y(), sumo_from_radians(heading),
                          kKeepRouteFree, kNoMatch);
  }

  void land(const std::string& id, const Vec2& position, double heading) override {
    api::Person::moveToXY(id, "", position.x(), position.y(), sumo_from_radians(heading),
                          kKeepRoute, kMatch);
  }

  void put_on(const std::string& id, const LaneMove& move) override {
    if (move.lateral) {
      api::Person::moveTo(id, move.lane, move.position, *move.lateral);
    } else {
      api::Person::moveTo(id, move.lane, move.position);
    }
  }

  bool release(const std::string& id, const ReleasePlan& plan) override {
    // SUMO would show a stop of 0 s in tripinfo where the last stage is removed.
    if (plan.remove_stage && stages_left(id) == 1) {
      api::Person::remove(id, libsumo::REMOVE_ARRIVED);
      return true;
    }
    if (plan.remove_stage) api::Person::removeStage(id, 0);
    if (plan.begin_anew) api::Person::replaceStage(id, 0, api::Person::getStage(id));
    for (const LaneMove& move : plan.moves) put_on(id, move);
    return false;
  }
};

}  // namespace

std::unique_ptr<SumoPersons> person_calls() { return std::make_unique<PersonCalls>(); }

}  // namespace pedzone::PEDZONE_CALLS
