// The colours of all pictures and pages. A model has the same everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pedzone {

/// A colour as CSS writes it, on light ground and on dark. Pictures that are files of their own
/// have light ground.
struct Colour {
  std::string_view name, light, dark;
};

namespace colours {

/// For lines, marks and letters: told from their ground (WCAG 2.1, 1.4.11: contrast of 3, but for
/// sky). Those of Okabe and Ito 2008, which colour-blind people tell apart, darker where they would
/// be lost on white; and more that go with them.
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
inline constexpr Colour kBlack{"black", "#222222", "#eef0f2"};
inline constexpr std::array kLines{kBlue, kVermilion, kGreen, kPurple, kAmber,   kSky,    kBrown,
                                   kGrey, kSilver,    kOlive, kTeal,   kCrimson, kViolet, kBlack};

/// For areas with an outline: Okabe and Ito's that are too light for lines.
inline constexpr Colour kYellow{"yellow", "#f0e442", "#f0e442"};
inline constexpr Colour kOrange{"orange", "#e69f00", "#e69f00"};
inline constexpr Colour kPink{"pink", "#cc79a7", "#e59ac4"};
inline constexpr std::array kFills{kYellow, kOrange, kPink};

/// Of maps. They are pale: people, vehicles and densities lie on them. Zones take theirs in turn,
/// so that neighbours differ.
inline constexpr Colour kGround{"ground", "#ffffff", "#14171b"};
inline constexpr Colour kZone{"zone", "#d3e8c8", "#2b362e"};
inline constexpr Colour kZone1{"zone-1", "#e6f0e0", "#34433a"};
inline constexpr Colour kZone2{"zone-2", "#e4e8c3", "#38402c"};
inline constexpr Colour kZone3{"zone-3", "#c8e2da", "#2a3f3f"};
inline constexpr Colour kZoneEdge{"zone-edge", "#6f8f60", "#8fa886"};
inline constexpr Colour kObstacle{"obstacle", "#b9b2a8", "#545b64"};
inline constexpr Colour kObstacleEdge{"obstacle-edge", "#857e74", "#77808b"};
inline constexpr Colour kRoad{"road", "#dcdcda", "#262b31"};
inline constexpr Colour kFootway{"footway", "#eee7d9", "#2d2b26"};
inline constexpr Colour kCrossing{"crossing", "#e9ebeb", "#22272c"};
inline constexpr Colour kWaypoint{"waypoint", "#c8102e", "#ff8090"};
inline constexpr std::array kZones{kZone, kZone1, kZone2, kZone3};
inline constexpr std::array kMap{kGround,   kZone,         kZone1, kZone2,   kZone3,    kZoneEdge,
                                 kObstacle, kObstacleEdge, kRoad,  kFootway, kCrossing, kWaypoint};

/// Of pictures that are files of their own, apart from what they show.
inline constexpr std::string_view kPaper = "#ffffff";     ///< ground; halos of letters and marks
inline constexpr std::string_view kInk = kBlack.light;    ///< letters, ticks, scale bars
inline constexpr std::string_view kAxis = "#333333";      ///< axes of charts
inline constexpr std::string_view kGridLine = "#dddddd";  ///< at their ticks
inline constexpr std::string_view kRule = "#666666";      ///< between a map and its legend
inline constexpr std::string_view kShade = "#000000";     ///< what colours are darkened with

}  // namespace colours

/// The colour `part` [0, 1] of the way from one to another, both as `#rrggbb`.
std::string mixed_colour(std::string_view from, std::string_view to, double part);

/// How a model's lines look, wherever they are drawn.
struct ModelLook {
  Colour colour;
  std::string_view dashes;  ///< as SVG writes them; empty: none
};

/// Looks of these models, in their order. Models that are known by name (pedzone's, SUMO's and the
/// reference rows of a validation) have their own; all others get spare ones by turns.
std::vector<ModelLook> model_looks(std::span<const std::string> models);

/// Every colour as a style sheet's variable by its name (`--blue`), for light or for dark ground.
std::string palette_variables(bool dark);

/// A style sheet for light ground, dark ground and paper: these variables, and of the models, from
/// 0 on, `--model-0` and `--dash-0`. `--model-recorded` and `--dash-recorded` are for what was
/// recorded.
std::string palette_css(std::span<const std::string> models);

}  // namespace pedzone
