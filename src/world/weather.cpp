#include "world/weather.hpp"

#include <algorithm>

namespace pedzone {
namespace {

// Speeds: in rain people walk some percent faster (Knoblauch et al. 1996 found it at crossings;
// the factor is assumed), on ice slower. Ice: friction about a quarter of that of a dry road.
constexpr Weather kWeather[] = {
    {"fair", 1.0, 1.0, 1.0, false, "changes nothing", ""},
    {"rain", 1.07, 0.7, 0.7, false, "people hurry under hoods and umbrellas; wet road",
     "direction of the effect on speed: Knoblauch et al. 1996; factors assumed"},
    {"heat", 0.95, 1.0, 1.0, true, "people slow down and seek the shade", "assumed"},
    {"ice", 0.75, 1.0, 0.25, false, "people and vehicles on ice", "assumed"},
};

}  // namespace

std::span<const Weather> weather_list() { return kWeather; }

const Weather* find_weather(std::string_view id) {
  const auto found = std::ranges::find(kWeather, id, &Weather::id);
  return found == std::end(kWeather) ? nullptr : &*found;
}

}  // namespace pedzone
