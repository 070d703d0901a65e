// The colours of all pictures and pages. A model has the same everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pedzone {

/// A colour for lines and marks, as CSS writes it, on light ground and on dark: both are told from
/// their ground (WCAG 2.1, 1.4.11: contrast of 3, but for sky).
struct Colour {
  std::string_view name, light, dark;
};

/// Those of Okabe and Ito 2008, which colour-blind people tell apart (darker where they would be
/// lost on white), and more that go with them.
namespace colours {
inline constexpr Colour kBlue{"blue", "#0072b2", "#56b4e9"};
inline constexpr Colour kVermilion{"vermilion", "#d55e00", "#ff8f45"};
inline constexpr Colour kGreen{"green", "#009e73", "#1fc796"};
inline constexpr Colour kPurple{"purple", "#a8528a", "#e59ac4"};
inline constexpr Colour kAmber{"amber", "#a87400", "#e8c34d"};
inline constexpr Colour kSky{"sky", "#56b4e9", "#9ad7ff"};
inline constexpr Colour kBrown{"brown", "#7a3b00", "#c98a5a"};
inline constexpr Colour kGrey{"grey", "#5b6169", "#aab2bb"};
inline constexpr Colour kSilver{"silver", "#858d96", "#808993"};
inline constexpr Colour kOlive{"olive", "#6f7400", "#c3cc4a"};
inline constexpr Colour kTeal{"teal", "#00798c", "#4fc9dc"};
inline constexpr Colour kCrimson{"crimson", "#b3123f", "#ff7d9b"};
inline constexpr Colour kViolet{"violet", "#5b4bb5", "#b3a6ff"};
inline constexpr std::array kAll{kBlue, kVermilion, kGreen, kPurple, kAmber,   kSky,   kBrown,
                                 kGrey, kSilver,    kOlive, kTeal,   kCrimson, kViolet};
}  // namespace colours

/// How a model's lines look, wherever they are drawn.
struct ModelLook {
  Colour colour;
  std::string_view dashes;  ///< as SVG writes them; empty: none
};

/// Looks of these models, in their order. Models that are known by name (pedzone's, SUMO's and the
/// reference rows of a validation) have their own; all others get spare ones by turns.
std::vector<ModelLook> model_looks(std::span<const std::string> models);

/// A style sheet of variables, for light ground, dark ground and paper: each colour by its name
/// (`--blue`), and of these models, from 0 on, `--model-0` and `--dash-0`. `--model-recorded` and
/// `--dash-recorded` are for what was recorded.
std::string palette_css(std::span<const std::string> models);

}  // namespace pedzone
