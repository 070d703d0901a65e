#include "view/colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pages/palette.hpp"

namespace pedzone {
namespace {

/// matplotlib's viridis (CC0) at k/15, without its last.
constexpr std::array<std::array<double, 3>, 15> kViridis{{{68, 1, 84},
                                                          {72, 26, 108},
                                                          {71, 47, 125},
                                                          {65, 68, 135},
                                                          {57, 86, 140},
                                                          {49, 104, 142},
                                                          {42, 120, 142},
                                                          {35, 136, 142},
                                                          {31, 152, 139},
                                                          {34, 168, 132},
                                                          {53, 183, 121},
                                                          {84, 197, 104},
                                                          {122, 209, 81},
                                                          {165, 219, 54},
                                                          {210, 226, 27}}};

constexpr std::array kLineColours{colours::kBlue,   colours::kVermilion, colours::kGreen,
                                  colours::kPurple, colours::kBlack,     colours::kAmber};
static_assert(kLineLooks == 2 * kLineColours.size());

}  // namespace

std::string scale_colour(double part) {
  const double at = std::clamp(part, 0.0, 1.0) * static_cast<double>(kViridis.size() - 1);
  const std::size_t from = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
  std::string colour = "#";
  for (std::size_t c = 0; c < 3; ++c) {
    const double value =
        std::lerp(kViridis[from][c], kViridis[from + 1][c], at - static_cast<double>(from));
    colour += fmt::format("{:02x}", static_cast<int>(std::lround(value)));
  }
  return colour;
}

LineLook line_look(std::size_t index) {
  return {kLineColours[index % kLineColours.size()].light,
          index / kLineColours.size() % 2 == 0 ? "" : "4 2"};
}

}  // namespace pedzone
