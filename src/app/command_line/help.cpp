#include "app/command_line/help.hpp"

#include <fmt/format.h>

#include "app/command_line/option_text.hpp"
#include "core/xml.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kColumn = 30, kWidth = 98;  // where meanings begin, and lines end

/// A name and, beside or below it, what it means.
std::string entry(const std::string& name, const std::string& meaning) {
  std::string text, line = "  " + name;
  bool begun = line.size() < kColumn;  // whether the meaning stands beside the name
  line.resize(std::max(line.size(), begun ? kColumn - 1 : 0), ' ');
  for (const std::string& word : split_words(meaning)) {
    if (!begun || line.size() + 1 + word.size() > kWidth) {
      text += line + "\n";
      line = std::string(kColumn - 1, ' ');
      begun = true;
    }
    line += " " + word;
  }
  return text + line + "\n";
}

}  // namespace

HelpFormatter::HelpFormatter() { label("Positionals", "Arguments"); }

std::string HelpFormatter::make_usage(const CLI::App* app, std::string /*name*/) const {
  return fmt::format("Usage: {}\n\n", synopsis(*app));
}

std::string HelpFormatter::make_positionals(const CLI::App* app) const {
  const std::string text = Formatter::make_positionals(app);
  return text.empty() ? "" : text + "\n";
}

std::string HelpFormatter::make_group(std::string group, bool is_positional,
                                      std::vector<const CLI::Option*> options) const {
  std::string text = group + ":\n";
  for (const CLI::Option* option : options) text += make_option(option, is_positional);
  return text;
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool /*is_positional*/) const {
  const OptionText text = text_of(*option);
  std::string name = fmt::format("{}", fmt::join(text.names, ", "));
  if (!name.empty() && !text.value.empty()) name += " ";
  return entry(name + text.value, text.meaning);
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description());
}

std::string help_of(const CLI::App& command) {
  return command.get_formatter()->make_help(&command, "", CLI::AppFormatMode::Normal);
}

}  // namespace pedzone
