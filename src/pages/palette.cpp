#include "pages/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pedzone {
namespace {

using namespace colours;

constexpr std::array kKnown{
    std::pair{std::string_view{"heuristic"}, ModelLook{kBlue, ""}},
    std::pair{std::string_view{"heuristic-original"}, ModelLook{kSky, "6 3"}},
    std::pair{std::string_view{"plain"}, ModelLook{kGreen, "7 3"}},
    std::pair{std::string_view{"orca"}, ModelLook{kVermilion, ""}},
    std::pair{std::string_view{"social-force"}, ModelLook{kPurple, ""}},
    std::pair{std::string_view{"gradient-navigation"}, ModelLook{kAmber, ""}},
    std::pair{std::string_view{"optimal-steps"}, ModelLook{kBrown, ""}},
    std::pair{std::string_view{"constant-velocity"}, ModelLook{kSilver, "9 3 2 3"}},
    std::pair{std::string_view{"constant velocity"}, ModelLook{kSilver, "9 3 2 3"}},
    std::pair{std::string_view{"straight to goal"}, ModelLook{kOlive, "2 2.5"}},
    std::pair{std::string_view{"striping"}, ModelLook{kGrey, ""}},
    std::pair{std::string_view{"nonInteracting"}, ModelLook{kGrey, "2 2.5"}}};

constexpr std::array kSpare{ModelLook{kTeal, ""},       ModelLook{kCrimson, ""},
                            ModelLook{kViolet, ""},     ModelLook{kTeal, "6 3"},
                            ModelLook{kCrimson, "6 3"}, ModelLook{kViolet, "6 3"}};

std::string variable(std::string_view name, std::string_view value) {
  return "--" + std::string(name) + ":" + std::string(value) + ";";
}

std::string model_variables(std::span<const ModelLook> looks, bool dark) {
  std::string css;
  for (std::size_t m = 0; m < looks.size(); ++m) {
    const Colour& colour = looks[m].colour;
    css += variable("model-" + std::to_string(m), dark ? colour.dark : colour.light);
  }
  return css;
}

int channel(std::string_view colour, std::size_t c) {
  return std::stoi(std::string(colour.substr(1 + 2 * c, 2)), nullptr, 16);
}

}  // namespace

std::vector<ModelLook> model_looks(std::span<const std::string> models) {
  std::vector<ModelLook> looks;
  std::size_t spare = 0;
  for (const std::string& model : models) {
    const auto known =
        std::ranges::find_if(kKnown, [&](const auto& one) { return one.first == model; });
    looks.push_back(known != kKnown.end() ? known->second : kSpare[spare++ % kSpare.size()]);
  }
  return looks;
}

std::string mixed_colour(std::string_view from, std::string_view to, double part) {
  std::string colour = "#";
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = std::lerp(channel(from, c), channel(to, c), part);
    colour += fmt::format("{:02x}", static_cast<int>(std::lround(value)));
  }
  return colour;
}

std::string palette_variables(bool dark) {
  std::string css;
  const auto add = [&](std::span<const Colour> colours) {
    for (const Colour& one : colours) css += variable(one.name, dark ? one.dark : one.light);
  };
  add(kLines);
  add(kFills);
  add(kMap);
  return css;
}

std::string palette_css(std::span<const std::string> models) {
  const std::vector<ModelLook> looks = model_looks(models);
  std::string css = ":root{" + palette_variables(false) + model_variables(looks, false) +
                    variable("model-recorded", "var(--ink)") + variable("dash-recorded", "none");
  for (std::size_t m = 0; m < looks.size(); ++m) {
    css +=
        variable("dash-" + std::to_string(m), looks[m].dashes.empty() ? "none" : looks[m].dashes);
  }
  return css + "}\n@media screen and (prefers-color-scheme:dark){:root{" + palette_variables(true) +
         model_variables(looks, true) + "}}\n";
}

}  // namespace pedzone
