#include "sumo/plan/outside_walkers.hpp"

namespace pedzone {
namespace {

constexpr double kLetGo = 3.0;  // [s] assumed: who is walked from outside seldom stands so still
constexpr double kAskInterval = 0.5;  // [s] numerical

}  // namespace

void leave_to_others(Bystander& person, double time, bool declared) {
  person.external = true;
  person.declared = declared;
  person.ask_at = time + kLetGo;
}

bool is_to_be_asked(Bystander& person, double time) {
  if (!person.declared && person.velocity != Vec2::Zero()) person.ask_at = time + kLetGo;
  if (time < person.ask_at) return false;
  person.ask_at = time + kAskInterval;
  return true;
}

bool comes_back(Bystander& person, bool is_declared) {
  if (!is_declared) person.external = false;
  return !is_declared;
}

bool is_to_be_put_back(const Bystander& person, const std::string& edge) {
  return person.velocity == Vec2::Zero() && !edge.starts_with(':');
}

}  // namespace pedzone
