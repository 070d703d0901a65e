#include "pages/palette.hpp"

#include <algorithm>
#include <array>
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

std::string variables(std::span<const ModelLook> looks, bool dark) {
  const auto shade = [&](const Colour& colour) {
    return std::string(dark ? colour.dark : colour.light);
  };
  std::string css;
  for (const Colour& colour : kAll)
    css += "--" + std::string(colour.name) + ":" + shade(colour) + ";";
  for (std::size_t m = 0; m < looks.size(); ++m) {
    css += "--model-" + std::to_string(m) + ":" + shade(looks[m].colour) + ";";
  }
  return css;
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

std::string palette_css(std::span<const std::string> models) {
  const std::vector<ModelLook> looks = model_looks(models);
  std::string css =
      ":root{" + variables(looks, false) + "--model-recorded:var(--ink);--dash-recorded:none;";
  for (std::size_t m = 0; m < looks.size(); ++m) {
    const std::string_view dashes = looks[m].dashes.empty() ? "none" : looks[m].dashes;
    css += "--dash-" + std::to_string(m) + ":" + std::string(dashes) + ";";
  }
  return css + "}\n@media screen and (prefers-color-scheme:dark){:root{" + variables(looks, true) +
         "}}\n";
}

}  // namespace pedzone
