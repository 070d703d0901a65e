// What the commands that measure conflicts have in common: where to write them and which count.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "results/conflict_writer.hpp"

namespace pedzone {

struct ConflictOptions {
  std::string xml, csv;  ///< files to write; empty: not
  ConflictLimits limits;
  bool wanted() const { return !xml.empty() || !csv.empty(); }
  ConflictWriter::Paths paths() const;
};

/// Adds --conflict-output, --conflict-csv and the limits.
void add_conflict_options(CLI::App& command, ConflictOptions& options);

}  // namespace pedzone
