// What a user says of SUMO's options: on the command line after `--`, else in the configuration.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/xml.hpp"

namespace pedzone {

/// One option of SUMO's with its synonyms, as on the command line and in a configuration.
struct SumoOption {
  std::vector<std::string> names;  ///< the first is the one SUMO prints
};

/// An option on SUMO's command line: `--name value`, `--name=value`, `-n value`, `--flag`.
struct OptionWords {
  std::string value;         ///< of a flag without one: true
  std::size_t first, count;  ///< the words that say it
};
std::optional<OptionWords> find_option_words(const std::vector<std::string>& words,
                                             const SumoOption& option);

/// Has the words say that option, once and with that value: SUMO takes an option but once.
void set_option(std::vector<std::string>& words, const SumoOption& option,
                const std::string& value);

class SaidOptions {
 public:
  /// Throws InputError where the configuration is missing or malformed.
  SaidOptions(const std::string& config, const std::vector<std::string>& words)
      : config_(config), words_(words) {}

  const XmlFile& config() const { return config_; }
  /// Nothing: SUMO's default. The command line wins over the configuration.
  std::optional<std::string> value(const SumoOption& option) const;
  bool on_command_line(const SumoOption& option) const;
  /// Whether a flag is set.
  bool is_true(const SumoOption& option) const;
  /// Names the place where the option is said.
  InputError error(const SumoOption& option, const std::string& problem, const std::string& value,
                   const std::string& allowed) const;

 private:
  pugi::xml_node in_configuration(const SumoOption& option) const;

  XmlFile config_;
  std::vector<std::string> words_;
};

}  // namespace pedzone
