// What the commands that measure conflicts have in common: where to write them and which count.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "results/conflict_writer.hpp"

namespace pedzone {

struct ConflictOptions {
  std::string xml, csv;  ///< files to write; empty: not
  ConflictLimits limits;
  std::string of = "zones";  ///< zones: people whom pedzone walks; all
  /// Whether a conflict is told. Where it is not known who walked the person, all are.
  bool takes(const Conflict& conflict) const {
    return of == "all" || conflict.by_pedzone.value_or(true);
  }
  bool wanted() const { return !xml.empty() || !csv.empty(); }
  ConflictWriter::Paths paths() const;
};

/// Adds --conflict-output, --conflict-csv, --conflicts-of and the limits.
void add_conflict_options(CLI::App& command, ConflictOptions& options);

}  // namespace pedzone
