// Options that several commands have.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace pedzone {

/// The scenario and --zone.
void add_scenario(CLI::App& command, std::string& config, std::string& zone_file);
/// --threads; 0: all cores.
CLI::Option* add_threads(CLI::App& command, int& threads);
/// --seeds, 1 to 1000.
CLI::Option* add_seeds(CLI::App& command, int& seeds, const char* what);
/// --json: text for programs instead of for people.
void add_json_flag(CLI::App& command, bool& json);

/// Throws InputError where a model that was named by --model cannot be had.
void require_models(const std::vector<std::string>& names);

}  // namespace pedzone
