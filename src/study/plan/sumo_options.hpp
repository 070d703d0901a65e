// SUMO's options as a study may set them: known by name, checked by type.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pedzone::study {

struct Study;

/// Why an option cannot be set.
struct SumoOptionError {
  std::string problem, value, allowed;
};

/// Options as words --name, value, --name, value ..., each option once and under its first name.
class SumoOptions {
 public:
  SumoOptions() = default;
  /// `words` have that form.
  explicit SumoOptions(std::vector<std::string> words) : words_(std::move(words)) {}

  /// In the place of an earlier value.
  void set(std::string_view name, const std::string& value);
  void remove(std::string_view name);
  std::optional<std::string> find(std::string_view name) const;
  const std::vector<std::string>& words() const { return words_; }

 private:
  std::vector<std::string> words_;
};

/// Asks SUMO for its options at once, not when they are first needed: what a driver knows, the
/// processes that it forks need not ask again. Throws as sumo_answer().
void ask_sumo_options();

/// An option's first name, also where a study may not set it; nothing where SUMO has none.
std::optional<std::string> known_sumo_option(std::string_view name);

/// What an option has to be for the study's measures; nothing for others.
std::optional<std::string> neutral_sumo_value(std::string_view name);

/// Whether the option lists what alone SUMO writes of what is measured. No value of such a list is
/// neutral.
bool is_measuring_list(std::string_view name);

/// The option by whose value 1 everybody is written, whoever such a list names; nothing where there
/// is none.
std::optional<std::string> chance_instead_of(std::string_view list);

/// An option's first name, where SUMO has it under this one and a study may set it to the value.
/// Throws SumoOptionError; SumoError where SUMO does not tell its options.
std::string check_sumo_option(std::string_view name, const std::string& value);

/// Words as on SUMO's command line (`--name value`, `--name=value`, `-n value`, `--flag`) as
/// options. Throws as check_sumo_option(), and for what is no option or given twice.
SumoOptions parse_sumo_options(const std::vector<std::string>& words);

/// Whether an option's value is a file, or files separated by commas, that SUMO reads.
bool names_input_files(std::string_view option);
/// The options with such files absolute; as written they are relative to the study's folder.
SumoOptions with_absolute_files(const SumoOptions& options, const Study& study);
/// Whether an option's value is a file that SUMO writes.
bool names_output_file(std::string_view option);

}  // namespace pedzone::study
