// The panel on the command line: what <pedestrians> says in a zone file, as options.
#pragma once

#include <CLI/CLI.hpp>

#include "zone/zone_file.hpp"

namespace pedzone {

struct PanelOptions {
  PanelText text;  ///< as given; empty: no people are asked for
};

/// Adds --pedestrians and --pedestrians-...
void add_panel_options(CLI::App& command, PanelOptions& options);

/// The zone file (nothing in it when `path` is empty), with the people that the options ask for.
/// Throws InputError.
ZoneFile read_zone_file(const std::string& path, const PanelOptions& options);

}  // namespace pedzone
