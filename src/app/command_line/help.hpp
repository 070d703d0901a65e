// The text of --help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace pedzone {

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_positionals(const CLI::App* app) const override;
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

/// Help of this very command, whichever was chosen.
std::string help_of(const CLI::App& command);

}  // namespace pedzone
