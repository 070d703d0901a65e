// Additional files as the runs of a study read them. Runs go on side by side: what an additional
// file has SUMO write (detectors, edge data) must go to each run's own folder.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace pedzone::study {

/// The text of a copy to lie elsewhere; unset where the file itself can be read. In the copy: what
/// it has SUMO write goes to files whose names begin with the path `outputs`, what it reads is
/// named by absolute paths. `movers`: whether persons and vehicles, and what makes groups of them,
/// stay in it. Outputs of files that it includes stay where they are. Throws InputError.
std::optional<std::string> additional_copy(const std::string& file, const std::string& outputs,
                                           bool movers);

/// The files that an additional file names to be read, those that they name in turn, too; absolute,
/// only those that are there. Throws InputError.
std::vector<std::string> files_named_in(const std::string& file);

/// Removes what makes groups of persons below a node; returns whether there was any.
bool dissolve_groups(pugi::xml_node root);

}  // namespace pedzone::study
