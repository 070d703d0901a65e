// On which recordings the default parameters were tuned: there a good score shows a good fit, not
// that the fit carries over.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "validation/clip.hpp"

namespace pedzone {

/// Site and name of a clip.
using ClipName = std::pair<std::string, std::string>;

/// The clips that `pedzone calibrate` found the defaults on, in order.
const std::vector<ClipName>& tuned_clips();

/// The clips of `data` with anybody in the first set of the tables (PersonSet::kRecorded).
std::vector<ClipName> scored_clips(const std::vector<Clip>& data);

/// Clips that were scored, as the tuning had them and as it had not.
struct ShownClips {
  std::vector<ClipName> tuned, held_back;
};
ShownClips shown_clips(const std::vector<ClipName>& scored);

/// "citr: back_01, 02, front_01; dut: intersection_01": what differs in a number only, once.
std::string listed(const std::vector<ClipName>& clips);

}  // namespace pedzone
