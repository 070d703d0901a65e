// Recordings of runs: SUMO's floating-car data and pedzone's trajectories.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/xml_stream.hpp"
#include "results/recording.hpp"
#include "sumo/files/body_sizes.hpp"
#include "sumo/files/person_traits.hpp"

namespace pedzone {

struct RecordingSource {
  std::string file = {};  ///< SUMO's fcd-output or pedzone's trajectories, gzipped or not
  std::string fcd = {};  ///< vehicles, and persons whom SUMO walks, beside trajectories: fcd-output
                         ///< of the same run; empty: none
  double begin = -std::numeric_limits<double>::infinity();  ///< [s] what lies outside is left out
  double end = std::numeric_limits<double>::infinity();     ///< [s]
  std::vector<std::string> persons = {};                    ///< ids; empty: all
  bool needs_person = true;                                 ///< else a recording of nobody is one
};

/// What a scenario's files say of those who are recorded.
struct RecordingCast {
  BodySizes sizes;
  TraitReader traits;
  void read(const std::string& file) {
    sizes.read(file);
    traits.read(file);
  }
};

/// Whether a file is pedzone's trajectories, not fcd-output. Throws InputError where it cannot be
/// read.
bool is_trajectory_table(const std::string& file);

/// Reads a recording. Those who ride in a vehicle are left out while they do. Throws InputError
/// where a file is missing, empty, cut off or neither of the two, where its numbers are none, a
/// vehicle's type is not known, one of `persons` is not in it, or nobody is.
Recording read_recording(const RecordingSource& source, const RecordingCast& cast,
                         const ReadProgress& progress = {});

}  // namespace pedzone
