#include "sumo/live/gui_view.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/error.hpp"
#include "world/activities.hpp"

namespace pedzone {
namespace {

// The legend stands in src/sumo/README.md.
constexpr TraciColour kWalking{60, 160, 75}, kMakingWay{240, 180, 0}, kWaiting{220, 50, 40},
    kForGroup{140, 80, 200}, kStanding{110, 110, 110};
constexpr ShapeLook kZone{{70, 130, 230, 40}, true, 0.1, -1};
constexpr ShapeLook kZoneEdge{{70, 130, 230, 200}, false, 0.15, 0};
constexpr ShapeLook kRays{{230, 90, 20}, false, 0.05, 5};
constexpr TraciColour kWaypoint{140, 80, 200, 255};
constexpr std::size_t kAskedAtOnce = 20;  // numerical: each is a message to SUMO and its answer

}  // namespace

TraciColour colour_of(const PersonView& person) {
  if (person.activity != Activity::kNone) {
    const auto& [red, green, blue] = info_of(person.activity).colour;
    return {red, green, blue};
  }
  if (person.waits_for_group) return kForGroup;
  if (person.motion == Motion::kWaiting) return kWaiting;
  if (person.makes_way) return kMakingWay;
  return person.motion == Motion::kStanding ? kStanding : kWalking;
}

GuiView::GuiView(SumoView* sumo, SumoPersons& persons,
                 const std::vector<std::unique_ptr<Crowd>>& crowds, const Takeover& takeover,
                 std::string screenshots)
    : sumo_(sumo != nullptr && sumo->is_there() ? sumo : nullptr),
      persons_(persons),
      crowds_(crowds),
      takeover_(takeover),
      screenshots_(std::move(screenshots)) {
  if (sumo_ != nullptr || screenshots_.empty()) return;
  throw InputError("cannot be taken: the SUMO that runs has no window",
                   {"", 0, "--screenshots", screenshots_, "a sumo-gui"});
}

void GuiView::begin(const std::vector<Zone>& zones, const std::vector<WaypointPath>& paths) {
  if (sumo_ == nullptr) return;
  for (const Zone& zone : zones) {
    int number = 0;
    for (const auto& polygon : zone.walkable) {
      const std::string id = "pedzone." + zone.id + "." + std::to_string(number++);
      std::vector<Vec2> ring = polygon.outer;
      ring.push_back(ring.front());
      sumo_->draw(id, ring, "pedzone.zone", kZone);
      sumo_->draw(id + ".edge", ring, "pedzone.zone", kZoneEdge);
    }
  }
  for (const WaypointPath& path : paths) {
    int number = 0;
    for (std::size_t z = 0; z < zones.size(); ++z) {
      for (const Waypoint& waypoint : path.waypoints(z)) {
        sumo_->mark("pedzone." + path.id + "." + std::to_string(number++), waypoint.at,
                    "pedzone.waypoint", kWaypoint);
      }
    }
  }
}

void GuiView::update() {
  if (sumo_ == nullptr) return;
  for (const Guest& guest : takeover_.guests()) {
    const TraciColour colour = colour_of(crowds_[guest.zone]->view(guest.handle));
    const auto [entry, is_new] = shown_.try_emplace(guest.id, colour);
    if (!is_new && entry->second == colour) continue;
    entry->second = colour;
    persons_.set_colour(guest.id, colour);
  }
  show_rays();
  if (screenshots_.empty()) return;
  char name[32];
  std::snprintf(name, sizeof name, "/step-%06ld.png", pictures_++);
  sumo_->screenshot(screenshots_ + name);
}

/// Asks of some at a time: it takes a moment until a selection is seen.
bool GuiView::is_selected(std::size_t guest) {
  const std::vector<Guest>& all = takeover_.guests();
  const bool known = std::ranges::find(selected_, all[guest].id) != selected_.end();
  const std::size_t turn = (guest + all.size() - asked_ % all.size()) % all.size();
  return known || turn < kAskedAtOnce ? sumo_->is_selected(all[guest].id) : false;
}

void GuiView::show_rays() {
  std::vector<std::string> now;
  const std::vector<Guest>& all = takeover_.guests();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!is_selected(k)) continue;
    const std::vector<Insight> insight = crowds_[all[k].zone]->insights(std::array{all[k].handle});
    std::vector<Vec2> fan;
    for (const Ray& ray : insight.front().rays) {
      fan.push_back(insight.front().position);
      fan.push_back(insight.front().position + unit(ray.direction) * ray.free_distance);
    }
    if (fan.empty()) continue;
    sumo_->draw("pedzone.rays." + all[k].id, fan, "pedzone.rays", kRays);
    now.push_back(all[k].id);
  }
  asked_ += kAskedAtOnce;
  for (const std::string& id : selected_) {
    if (std::ranges::find(now, id) == now.end()) sumo_->erase("pedzone.rays." + id);
  }
  selected_ = std::move(now);
}

}  // namespace pedzone
