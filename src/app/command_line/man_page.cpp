#include "app/command_line/man_page.hpp"

#include <fmt/format.h>

#include "app/command_line/option_text.hpp"
#include "core/text.hpp"

namespace pedzone {
namespace {

/// Text that troff prints as it is: no character commands.
std::string escaped(std::string_view text) {
  std::string out;
  bool begins_line = true;
  for (const char letter : text) {
    if (begins_line && (letter == '.' || letter == '\'')) out += "\\&";
    if (letter == '\\') {
      out += "\\e";
    } else if (letter == '-') {
      out += "\\-";
    } else {
      out += letter;
    }
    begins_line = letter == '\n';
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }

std::string option_entry(const CLI::Option& option) {
  const OptionText text = text_of(option);
  std::string names = comma_list(text.names, bold);
  if (!names.empty() && !text.value.empty()) names += " ";
  return fmt::format(".TP\n{}\\fI{}\\fR\n{}\n", names, escaped(text.value), escaped(text.meaning));
}

/// Options by group; what --help shows of each command alike is left out.
std::string options(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : shown_options(command)) {
    if (!option->nonpositional()) text += option_entry(*option);
  }
  for (const std::string& group : command.get_groups()) {
    std::string entries;
    for (const CLI::Option* option : shown_options(command)) {
      const bool help = option == command.get_help_ptr() && command.get_parent() != nullptr;
      if (option->get_group() == group && option->nonpositional() && !help) {
        entries += option_entry(*option);
      }
    }
    if (!entries.empty()) text += fmt::format(".PP\n\\fI{}\\fR\n{}", escaped(group), entries);
  }
  return text;
}

std::string verbatim(const std::string& text) {
  return text.empty() ? "" : fmt::format(".PP\n.nf\n{}\n.fi\n", escaped(text));
}

/// A section for each command, those inside it after it.
std::string sections(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : shown_commands(app)) {
    text += fmt::format(".SS {}\n{}.\n.PP\n{}\n{}{}", bold(command_name(*command)),
                        escaped(command->get_description()), bold(synopsis(*command)),
                        options(*command), verbatim(command->get_footer()));
    text += sections(*command);
  }
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  return fmt::format(
      ".TH PEDZONE 1 \"\" \"pedzone {}\" \"User Commands\"\n.nh\n.ad l\n"
      ".SH NAME\npedzone \\- {}\n"
      ".SH SYNOPSIS\n{}\n"
      ".SH OPTIONS\n{}"
      ".SH COMMANDS\n{}"
      ".SH NOTES\n{}",
      app.version(), escaped(app.get_description()), bold(synopsis(app)), options(app),
      sections(app), verbatim(app.get_footer()));
}

}  // namespace pedzone
