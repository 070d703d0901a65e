#include "world/activities.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace pedzone {
namespace {

// Lamberg and Muratori 2012: who texts walks a third slower and sways more, who phones a sixth
// slower. How much more they sway, and what they see and hear meanwhile, is assumed.
constexpr PastimeInfo kPastimeList[] = {
    {Pastime::kNone, "none", 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, {}, ""},
    {Pastime::kTexting,
     "texting",
     20.0,
     2.0,
     0.67,
     0.35,
     0.8,
     2.5,
     {214, 39, 40},
     "speed: Lamberg and Muratori 2012; else assumed"},
    {Pastime::kPhoning,
     "phoning",
     40.0,
     1.0,
     0.84,
     0.8,
     0.4,
     1.5,
     {255, 127, 14},
     "speed: Lamberg and Muratori 2012; else assumed"},
    {Pastime::kLooking, "looking", 8.0, 2.0, 0.7, 0.6, 1.0, 3.0, {148, 103, 189}, "assumed"},
    {Pastime::kChatting, "chatting", 30.0, 0.5, 0.0, 0.7, 0.7, 1.0, {44, 160, 44}, "assumed"},
    {Pastime::kSitting, "sitting", 60.0, 0.5, 0.0, 0.7, 1.0, 1.0, {140, 86, 75}, "assumed"},
};
static_assert(std::size(kPastimeList) == kPastimes);

}  // namespace

std::span<const PastimeInfo> pastime_list() { return kPastimeList; }

const PastimeInfo& info_of(Pastime pastime) {
  return kPastimeList[static_cast<std::size_t>(pastime)];
}

const PastimeInfo* find_pastime(std::string_view id) {
  const auto found = std::ranges::find(kPastimeList, id, &PastimeInfo::id);
  return found == std::end(kPastimeList) ? nullptr : &*found;
}

std::string pastime_ids() { return comma_list(pastime_list().subspan(1), &PastimeInfo::id); }

}  // namespace pedzone
