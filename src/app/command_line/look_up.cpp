#include "app/command_line/look_up.hpp"

#include "app/command_line/completion.hpp"
#include "app/command_line/help.hpp"
#include "app/command_line/man_page.hpp"
#include "app/command_line/option_text.hpp"
#include "app/command_line/terminal.hpp"
#include "app/command_line/values.hpp"
#include "app/guarded.hpp"
#include "app/parameter_table.hpp"
#include "app/profile_tables.hpp"

namespace pedzone {
namespace {

constexpr const char* kBash = "bash";

CLI::App* add_printing(CLI::App& app, int& code, const char* name, const char* what,
                       const char* example, const std::function<std::string()>& text) {
  CLI::App* command = app.add_subcommand(name, what);
  command->footer(std::string("Example:\n  ") + example);
  command->callback([text, &code] { code = guarded([&] { print_text(text()); }); });
  return command;
}

}  // namespace

void add_parameters(CLI::App& app, int& code) {
  add_printing(app, code, "parameters",
               "Print the tables of a zone's parameters and of <pedestrians> (Markdown)",
               "pedzone parameters | grep sight", parameter_tables);
}

void add_profiles(CLI::App& app, int& code) {
  add_printing(app, code, "profiles",
               "Print the tables of profiles, activities and weather (Markdown)",
               "pedzone profiles | less", profile_tables);
}

void add_help(CLI::App& app, int& code) {
  const auto words = std::make_shared<std::vector<std::string>>();
  add_printing(app, code, "help", "Print the help of a command", "pedzone help study run",
               [&app, words] { return help_of(find_command(app, *words)); })
      ->add_option("command", *words, "Its name [default: all commands]")
      ->check(any_beside(command_names(app)));
}

void add_completion(CLI::App& app, int& code) {
  const auto shell = std::make_shared<std::string>();
  add_printing(
      app, code, "completion", "Print what a shell needs to complete command lines",
      "source <(pedzone completion bash)",
      [&app, shell] { return *shell == kBash ? bash_completion(app) : zsh_completion(app); })
      ->add_option("shell", *shell, "Which shell")
      ->required()
      ->check(one_of({kBash, "zsh"}));
}

void add_man(CLI::App& app, int& code) {
  add_printing(app, code, "man", "Print the manual page (troff)", "pedzone man | man -l -",
               [&app] { return man_page(app); });
}

}  // namespace pedzone
