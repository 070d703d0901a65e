#include "sumo/plan/standstills.hpp"

#include <algorithm>
#include <tuple>

namespace pedzone {
namespace {

constexpr double kNowhere = 1.5;  // [m] assumed: who is stuck still wanders by two steps

}  // namespace

bool is_at_rest(Activity activity) { return info_of(activity).speed == 0.0; }

void Standstills::update(double time, const std::vector<Present>& all,
                         const std::function<bool(const std::string& id)>& rests) {
  ++round_;
  all_.clear();
  for (const Present& one : all) {
    const auto [entry, is_new] = places_.try_emplace(one.id, Place{one.position, time, 0});
    Place& place = entry->second;
    place.round = round_;
    if (is_new) continue;
    if ((one.position - place.anchor).norm() > kNowhere || rests(one.id)) {
      place.anchor = one.position;
      place.since = time;
    } else if (time - place.since >= kLong) {
      all_.push_back({one.id, one.position, place.since, ""});
    }
  }
  std::erase_if(places_, [&](const auto& entry) { return entry.second.round != round_; });
  std::sort(all_.begin(), all_.end(), [](const Standstill& a, const Standstill& b) {
    return std::tie(a.since, a.id) < std::tie(b.since, b.id);
  });
  if (all_.size() <= most_) return;
  most_ = all_.size();
  most_at_ = time;
}

}  // namespace pedzone
