#include "app/profile_tables.hpp"

#include <fmt/format.h>

#include "world/activities.hpp"
#include "world/profiles.hpp"
#include "world/weather.hpp"

namespace pedzone {
namespace {

std::string profiles() {
  const Profiles profiles;
  std::string head = "| attribute | unit, range | meaning |", rule = "| --- | --- | --- |";
  for (const Profile& profile : profiles.all()) {
    head += fmt::format(" {} |", profile.id);
    rule += " --- |";
  }
  std::string text = head + "\n" + rule + "\n";
  for (const ProfileField& field : profile_fields()) {
    text += fmt::format("| `{}` | {} [{}, {}] | {} |", field.key, field.unit, field.least,
                        field.most, field.meaning);
    for (const Profile& profile : profiles.all()) {
      const std::string_view source = source_of(profile, field);
      text += source == "assumed" ? fmt::format(" {} |", profile.*field.member)
                                  : fmt::format(" {} ({}) |", profile.*field.member, source);
    }
    text += "\n";
  }
  for (const Profile& profile : profiles.all()) {
    text += fmt::format("\n- `{}`: {}", profile.id, profile.meaning);
  }
  return text + "\n";
}

std::string activities() {
  std::string text =
      "| activity | begins [1/min] | lasts [s] | speed | sight | hearing | heading noise | source "
      "|\n| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const ActivityInfo& info : activity_list()) {
    if (info.activity == Activity::kNone) continue;
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", info.id, info.rate,
                        info.duration, info.speed, info.field_of_view, info.hearing, info.noise,
                        info.source);
  }
  return text;
}

std::string weather() {
  std::string text =
      "| weather | people's speed | field of view | vehicles' deceleration | meaning | source "
      "|\n| --- | --- | --- | --- | --- | --- |\n";
  for (const Weather& info : weather_list()) {
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", info.id, info.speed,
                        info.field_of_view, info.deceleration, info.meaning, info.source);
  }
  return text;
}

}  // namespace

std::string profile_tables() {
  return "Profiles; where no source stands beside a number, it is assumed.\n\n" + profiles() +
         "\nActivities: factors of what a person has otherwise.\n\n" + activities() +
         "\nWeather: factors, too.\n\n" + weather();
}

}  // namespace pedzone
