#include "validation/tuned_clips.hpp"

#include <algorithm>

#include "validation/scores.hpp"

namespace pedzone {
namespace {

/// What a clip's name has before its number, and the number.
std::pair<std::string, std::string> split(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  if (end == std::string::npos || end + 1 == name.size() || name[end] != '_') return {name, ""};
  return {name.substr(0, end + 1), name.substr(end + 1)};
}

}  // namespace

const std::vector<ClipName>& tuned_clips() {
  static const std::vector<ClipName> kClips{
#define tuned_clip(site, name) {site, name},
#include "validation/tuned_clips.inc"
#undef tuned_clip
  };
  return kClips;
}

std::vector<ClipName> scored_clips(const std::vector<Clip>& data) {
  std::vector<ClipName> names;
  for (const Clip& clip : data) {
    const VehicleWays ways(clip);
    const bool scored = std::ranges::any_of(clip.persons, [&](const PersonTrack& track) {
      return counts(track) && measure(clip, ways, track, track.places).clearance < kInteracting;
    });
    if (scored) names.emplace_back(clip.site, clip.name);
  }
  return names;
}

ShownClips shown_clips(const std::vector<ClipName>& scored) {
  ShownClips shown;
  for (const ClipName& clip : scored) {
    (std::ranges::count(tuned_clips(), clip) > 0 ? shown.tuned : shown.held_back).push_back(clip);
  }
  return shown;
}

std::string listed(const std::vector<ClipName>& clips) {
  std::string text, site, stem;
  for (const auto& [of, name] : clips) {
    const auto [begin, number] = split(name);
    if (text.empty() || of != site) {
      text += (text.empty() ? "" : "; ") + of + ": " + name;
    } else {
      text += ", " + (begin == stem && !number.empty() ? number : name);
    }
    site = of;
    stem = begin;
  }
  return text;
}

}  // namespace pedzone
