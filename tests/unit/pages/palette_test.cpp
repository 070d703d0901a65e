// Colours of models: the same on every page, told apart from each other and from the ground.
#include "pages/palette.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>
#include <utility>

#include "world/model_names.hpp"

namespace pedzone {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> all_models() {
  std::vector<std::string> names(std::begin(kModelNames), std::end(kModelNames));
  names.insert(names.end(), {"striping", "nonInteracting"});
  return names;
}

const std::vector<std::string> kPedzoneAndSumo = all_models();

double channel(std::string_view colour, std::size_t c) {
  const double value = std::stoi(std::string(colour.substr(1 + 2 * c, 2)), nullptr, 16) / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double luminance(std::string_view colour) {
  return 0.2126 * channel(colour, 0) + 0.7152 * channel(colour, 1) + 0.0722 * channel(colour, 2);
}

/// WCAG 2.1's contrast ratio, 1 to 21.
double contrast(std::string_view one, std::string_view other) {
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

TEST(ModelLooks, do_not_depend_on_the_page) {
  const auto all = model_looks(kPedzoneAndSumo);
  for (std::size_t m = 0; m < kPedzoneAndSumo.size(); ++m) {
    const auto alone = model_looks(std::vector<std::string>{"./own.so", kPedzoneAndSumo[m]});
    EXPECT_EQ(alone[1].colour.light, all[m].colour.light) << kPedzoneAndSumo[m];
    EXPECT_EQ(alone[1].colour.dark, all[m].colour.dark) << kPedzoneAndSumo[m];
    EXPECT_EQ(alone[1].dashes, all[m].dashes) << kPedzoneAndSumo[m];
  }
}

TEST(ModelLooks, differ) {
  std::vector<std::string> models = kPedzoneAndSumo;
  for (int i = 0; i < 6; ++i) models.push_back("./own-" + std::to_string(i) + ".so");
  std::set<std::pair<std::string_view, std::string_view>> light, dark;
  for (const ModelLook& look : model_looks(models)) {
    light.emplace(look.colour.light, look.dashes);
    dark.emplace(look.colour.dark, look.dashes);
  }
  EXPECT_EQ(light.size(), models.size());
  EXPECT_EQ(dark.size(), models.size());
}

TEST(Palette, shows_on_its_ground) {
  for (const Colour& colour : colours::kLines) {
    const double least = colour.name == "sky" ? 2.0 : 3.0;
    EXPECT_GT(contrast(colour.light, "#ffffff"), least) << colour.name;
    EXPECT_GT(contrast(colour.dark, "#101316"), 3.0) << colour.name;
  }
}

TEST(PaletteCss, names_every_colour_and_model_for_both_grounds) {
  const std::string css = palette_css(std::vector<std::string>{"plain", "orca"});
  const std::size_t dark = css.find("prefers-color-scheme:dark");
  ASSERT_NE(dark, std::string::npos);
  EXPECT_THAT(css.substr(0, dark), HasSubstr("--model-0:#009e73;--model-1:#d55e00;"));
  EXPECT_THAT(css.substr(dark), HasSubstr("--model-0:#1fc796;--model-1:#ff8f45;"));
  EXPECT_THAT(css, HasSubstr("--dash-0:7 3;--dash-1:none;"));
  for (const Colour& colour : colours::kLines) {
    EXPECT_THAT(css.substr(dark), HasSubstr("--" + std::string(colour.name) + ":"));
  }
}

}  // namespace
}  // namespace pedzone
