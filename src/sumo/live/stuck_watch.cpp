#include "sumo/live/stuck_watch.hpp"

#include <algorithm>

#include "world/activities.hpp"

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
  for (std::size_t k = 0; k < std::min(Standstills::kNamed, persons_.all().size()); ++k) {
    persons_.all()[k].where = place_of_person(persons_.all()[k].id);
  }
  for (std::size_t k = 0; k < std::min(Standstills::kNamed, vehicles_.all().size()); ++k) {
    vehicles_.all()[k].where = on_edge(sumo_.vehicles().edge(vehicles_.all()[k].id));
  }
}

bool StuckWatch::rests(const std::string& person) const {
  const Guest* guest = takeover_.guest(person);
  if (guest == nullptr) return !sumo_.persons().walks(person);
  return info_of(crowds_[guest->zone]->view(guest->handle).activity).speed == 0.0;
}

std::string StuckWatch::place_of_person(const std::string& id) const {
  const Guest* guest = takeover_.guest(id);
  return guest != nullptr ? "in zone '" + zones_[guest->zone].id + "'"
                          : on_edge(sumo_.persons().edge(id));
}

}  // namespace pedzone
