// The report of a study: one HTML page that needs nothing else.
#pragma once

#include <string>

#include "study/compare/results.hpp"
#include "study/run/store.hpp"

namespace pedzone::study {

/// The page.
std::string report_page(const Store& store, const Plan& plan, const Records& records,
                        const std::vector<Comparison>& comparisons,
                        const std::vector<FreeSpeed>& speeds);

/// A part of the page that plays: an animation's page, to be put into a frame.
struct ReportScene {
  std::string title;    ///< plain text
  std::string caption;  ///< plain text: what one sees, and by which rule it was chosen
  std::string page;     ///< HTML of view/animation
  std::string still;    ///< SVG for paper
  bool wide = false;    ///< of the still: as wide as the page
};

/// The run of the median seed, the reference beside each other model, per scenario; and the most
/// dangerous encounters of each model. Missing outputs leave theirs out.
std::vector<ReportScene> report_scenes(const Store& store, const Plan& plan,
                                       const Records& records);

}  // namespace pedzone::study
