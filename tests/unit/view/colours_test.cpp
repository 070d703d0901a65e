// The time scale: lightness rises evenly, so that it reads in grey and for colour-blind people.
#include "view/colours.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <set>

namespace pedzone {
namespace {

std::array<double, 3> linear_rgb(std::string_view colour) {
  std::array<double, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = std::stoi(std::string(colour.substr(1 + 2 * c, 2)), nullptr, 16) / 255.0;
    rgb[c] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

/// L* of CIELAB, 0 to 100, for sRGB (IEC 61966-2-1).
double lightness(std::string_view colour) {
  const auto [red, green, blue] = linear_rgb(colour);
  const double y = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

TEST(ScaleColour, lightness_rises_evenly) {
  constexpr int kSteps = 50;
  const double all = lightness(scale_colour(1.0)) - lightness(scale_colour(0.0));
  EXPECT_GT(all, 60.0);
  for (int k = 0; k < kSteps; ++k) {
    const double rise = lightness(scale_colour((k + 1.0) / kSteps)) -
                        lightness(scale_colour(static_cast<double>(k) / kSteps));
    EXPECT_GT(rise, 0.4 * all / kSteps) << k;
    EXPECT_LT(rise, 2.0 * all / kSteps) << k;
  }
}

TEST(ScaleColour, its_end_still_shows_on_white) {
  EXPECT_LT(lightness(scale_colour(1.0)), 88.0) << "10 darker than white is told from it at once";
}

TEST(ScaleColour, beyond_its_ends_stays_there) {
  EXPECT_EQ(scale_colour(-1.0), scale_colour(0.0));
  EXPECT_EQ(scale_colour(2.0), scale_colour(1.0));
}

TEST(LineLook, all_differ_and_show_on_white) {
  std::set<std::pair<std::string_view, std::string_view>> looks;
  for (std::size_t i = 0; i < kLineLooks; ++i) {
    const LineLook look = line_look(i);
    looks.emplace(look.colour, look.dashes);
    EXPECT_LT(lightness(look.colour), 75.0) << look.colour;
  }
  EXPECT_EQ(looks.size(), kLineLooks);
}

}  // namespace
}  // namespace pedzone
