// What people do beside walking, and what that does to them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pedzone {

enum class Activity : std::uint8_t { kNone, kTexting, kPhoning, kLooking, kChatting, kSitting };
inline constexpr std::size_t kActivities = 6;

struct ActivityInfo {
  Activity activity;
  std::string_view id;                 ///< "texting", ...
  double duration;                     ///< [s] mean; exponential
  double rate;                         ///< [1/min] at which somebody who does it at all begins
  double speed;                        ///< factor; 0: stands
  double field_of_view;                ///< factor
  double hearing;                      ///< factor
  double noise;                        ///< factor of the heading's variation
  std::array<std::uint8_t, 3> colour;  ///< red, green, blue in sumo-gui
  std::string_view source;
};

/// In the order of the enum, kNone (which changes nothing) included.
std::span<const ActivityInfo> activity_list();
const ActivityInfo& info_of(Activity activity);
/// Nullptr where none has that id; "none" is none.
const ActivityInfo* find_activity(std::string_view id);
/// "texting, phoning, ...", without "none".
std::string activity_ids();

}  // namespace pedzone
