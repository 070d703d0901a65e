// Trajectories as JuPedSim's database, version 2, which JuPedSim 1.x writes and PedPy 1.x reads.
#pragma once

#include <memory>
#include <string>

#include "results/trajectories.hpp"

namespace pedzone {

/// Tables trajectory_data (frame, id, pos_x, pos_y, ori_x, ori_y), frame_data, metadata and
/// geometry are JuPedSim's [m]; person_ids (id, person) is ours, and so is `begin` [s] in metadata.
/// Throws InputError as PendingFile.
std::unique_ptr<TrajectoryFile> make_sqlite_trajectories(const std::string& path,
                                                         const std::string& option);

}  // namespace pedzone
