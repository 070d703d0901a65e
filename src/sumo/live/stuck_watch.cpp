#include "sumo/live/stuck_watch.hpp"

namespace pedzone {
namespace {

constexpr double kEvery = 5.0;  // [s] assumed: looking at everybody is dear

std::string on_edge(const std::string& edge) {
  return edge.empty() ? edge : "on edge '" + edge + "'";
}

}  // namespace

void StuckWatch::update(double time) {
  if (time >= look_at_) look(time);
}

void StuckWatch::look(double time) {
  if (time == looked_at_) return;
  looked_at_ = time;
  look_at_ = time + kEvery;
  present_.clear();
  for (std::string& id : sumo_.persons().ids()) {
    const Vec2 position = sumo_.persons().position(id);
    present_.push_back({std::move(id), position});
  }
  persons_.update(time, present_, [this](const std::string& id) { return rests(id); });
  present_.clear();
  for (const std::string& id : sumo_.vehicles().ids()) {
    if (const auto position = sumo_.vehicles().front(id)) present_.push_back({id, *position});
  }
  vehicles_.update(time, present_,
                   [this](const std::string& id) { return sumo_.vehicles().is_at_stop(id); });
  for (Standstill& one : persons_.named()) one.where = place_of_person(one.id);
  for (Standstill& one : vehicles_.named()) one.where = on_edge(sumo_.vehicles().edge(one.id));
}

bool StuckWatch::rests(const std::string& person) const {
  const Guest* guest = takeover_.guest(person);
  if (guest == nullptr) return !sumo_.persons().walks(person);
  return is_at_rest(crowds_[guest->zone]->view(guest->handle).activity);
}

std::string StuckWatch::place_of_person(const std::string& id) const {
  const Guest* guest = takeover_.guest(id);
  return guest != nullptr ? "in zone '" + zones_[guest->zone].id + "'"
                          : on_edge(sumo_.persons().edge(id));
}

}  // namespace pedzone
