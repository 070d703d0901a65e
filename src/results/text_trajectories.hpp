// Trajectories as the text that PedPy and JuPedSim's older tools read: lines `id frame x y z` below
// a header that tells the frame rate and the unit.
#pragma once

#include <memory>
#include <string>

#include "results/trajectories.hpp"

namespace pedzone {

/// z [m] is 0: pedzone walks on the plane. The ids in SUMO stand in person_ids_file() beside it.
/// Throws InputError as CompleteFile.
std::unique_ptr<TrajectoryFile> make_text_trajectories(const std::string& path,
                                                       const std::string& option);

/// NAME.ids.csv beside NAME.txt and NAME.txt.gz.
std::string person_ids_file(const std::string& path);

}  // namespace pedzone
