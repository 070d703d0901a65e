// What the commands that show a recorded run have in common: the run, and the place it was in.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "results/place.hpp"
#include "sumo/files/recording_reader.hpp"

namespace pedzone {

struct RecordingOptions {
  RecordingSource source;
  std::string scenario;                   ///< SUMO configuration; empty: not given
  std::vector<std::string> sumo_options;  ///< that win over it
  std::string zone_file;                  ///< empty: zones are found by themselves
  std::vector<std::string> types;         ///< more route or additional files
};

/// A file's name without folder and endings: what is shown is called so where nothing else is said.
std::string name_of_file(const std::string& file);

/// Adds the positional file and the options.
void add_recording_options(CLI::App& command, RecordingOptions& options);
/// Only those that say what is shown of a recording, and more files that tell of who is in it.
void add_recording_filter(CLI::App& command, RecordingOptions& options);

/// The place of --scenario and --zone; null without a scenario. Throws InputError.
std::unique_ptr<Place> read_place(const RecordingOptions& options);

/// Says which people's sizes are guessed, where any are.
void warn_of_guessed_sizes(const BodySizes& sizes);

/// The recording with what the files of --scenario and --vtypes say of everybody; shows progress.
/// Throws InputError.
Recording read_recording(const RecordingOptions& options);

}  // namespace pedzone
