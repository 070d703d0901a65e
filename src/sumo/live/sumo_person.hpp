// What is read of persons in SUMO, and what they are told: calls, and no decision.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sumo/files/body_sizes.hpp"
#include "sumo/plan/release_plan.hpp"
#include "sumo/plan/takeover_plan.hpp"

namespace pedzone {

/// As SUMO has it.
struct TraciColour {
  int red = 0, green = 0, blue = 0, alpha = 255;  ///< [0, 255]
};

namespace sumo_person {

std::vector<std::string> ids();         ///< of all in SUMO
Vec2 position(const std::string& id);   ///< [m]
double speed(const std::string& id);    ///< [m/s]
double heading(const std::string& id);  ///< [rad]
BodySize size(const std::string& id);
std::string edge(const std::string& id);     ///< it is on; in a junction an inner one
std::string lane(const std::string& id);     ///< that SUMO has it on
std::string vehicle(const std::string& id);  ///< in which it rides; empty: none
int stages_left(const std::string& id);
std::vector<std::string> edges(const std::string& id);  ///< of its present stage
bool walks(const std::string& id);                      ///< its present stage is a walk
/// Nothing where its present stage is no walk.
std::optional<WalkerSeen> walker(const std::string& id);
/// Its own parameter, else that of its type.
std::string parameter(const std::string& id, const std::string& key);
std::string type(const std::string& id);
TraciColour colour(const std::string& id);

void set_colour(const std::string& id, const TraciColour& colour);
/// From the end of the next step on it is exactly there, on no lane, and no model of SUMO's moves
/// it. To be called for every step.
void show(const std::string& id, const Vec2& position, double heading);
/// It is SUMO's again. True: its plan is over and SUMO knows it no more.
bool release(const std::string& id, const ReleasePlan& plan);

}  // namespace sumo_person
}  // namespace pedzone
