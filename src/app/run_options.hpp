// What `pedzone run` and `pedzone attach` can be told.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/conflict_options.hpp"
#include "app/panel_options.hpp"
#include "sumo/calls/own_sumo.hpp"

namespace pedzone {

struct RunOptions {
  std::string config;                ///< .sumocfg
  std::string zone_file;             ///< empty: the zone is found by itself
  std::optional<std::string> model;  ///< of every zone; unset: as the zone file says
  std::optional<std::uint64_t> seed;
  std::optional<double> end;  ///< [s]
  int threads = 0;            ///< 0: all cores
  bool strict = false;        ///< where there is nobody or nowhere to walk, that is an error
  std::string summary, trajectories, picture;  ///< files to write; empty: not
  std::string animation;                       ///< page to write; empty: not
  std::string scratch;   ///< folder for what only the animation is made of; empty: none
  std::string recorded;  ///< the fcd-output that the animation is made of
  std::string trajectories_of = "zones";   ///< or "all": those, too, whom SUMO walks
  std::string crossings;                   ///< file to write; empty: not
  std::string edge_data;                   ///< file to write; empty: not
  std::optional<double> edge_data_period;  ///< [s] of an interval; unset: the whole run
  std::string debug_shapes;                ///< file to write; empty: not
  std::optional<double> debug_time;        ///< [s] of the shapes; unset: the end
  ConflictOptions conflicts;
  PanelOptions panel;
  std::vector<std::string> sumo_options;  ///< what stands after `--`
  std::optional<TraciAddress> attach;     ///< a SUMO that runs; unset: one of our own
  std::string screenshots;                ///< folder; empty: none
  OwnSumo own;                            ///< how that is, where it is another process
  bool own_process() const { return own.gui || own.all_clients() > 0; }
};

/// How people are walked: the scenario, --zone, --model, --seed, --end, --threads.
void add_walking_options(CLI::App& command, RunOptions& options);
CLI::Validator a_port();  ///< of TCP
CLI::Option* add_screenshots(CLI::App& command, RunOptions& options);
/// --gui, --clients and what belongs to them.
void add_process_options(CLI::App& command, RunOptions& options);
void add_strict_flag(CLI::App& command, RunOptions& options);
/// The files to be written but those of conflicts.
void add_output_options(CLI::App& command, RunOptions& options);

}  // namespace pedzone
