#include "world/activities.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace pedzone {
namespace {

// Lamberg and Muratori 2012: who texts walks a third slower and sways more, who phones a sixth
// slower. How much more they sway, and what they see and hear meanwhile, is assumed.
constexpr ActivityInfo kActivityList[] = {
    {Activity::kNone, "none", 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, {}, ""},
    {Activity::kTexting,
     "texting",
     20.0,
     2.0,
     0.67,
     0.35,
     0.8,
     2.5,
     {214, 39, 40},
     "speed: Lamberg and Muratori 2012; else assumed"},
    {Activity::kPhoning,
     "phoning",
     40.0,
     1.0,
     0.84,
     0.8,
     0.4,
     1.5,
     {255, 127, 14},
     "speed: Lamberg and Muratori 2012; else assumed"},
    {Activity::kLooking, "looking", 8.0, 2.0, 0.7, 0.6, 1.0, 3.0, {148, 103, 189}, "assumed"},
    {Activity::kChatting, "chatting", 30.0, 0.5, 0.0, 0.7, 0.7, 1.0, {44, 160, 44}, "assumed"},
    {Activity::kSitting, "sitting", 60.0, 0.5, 0.0, 0.7, 1.0, 1.0, {140, 86, 75}, "assumed"},
};
static_assert(std::size(kActivityList) == kActivities);

}  // namespace

std::span<const ActivityInfo> activity_list() { return kActivityList; }

const ActivityInfo& info_of(Activity activity) {
  return kActivityList[static_cast<std::size_t>(activity)];
}

const ActivityInfo* find_activity(std::string_view id) {
  const auto found = std::ranges::find(kActivityList, id, &ActivityInfo::id);
  return found == std::end(kActivityList) ? nullptr : &*found;
}

std::string activity_ids() { return comma_list(activity_list().subspan(1), &ActivityInfo::id); }

}  // namespace pedzone
