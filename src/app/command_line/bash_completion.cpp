#include <fmt/format.h>

#include "app/command_line/completion.hpp"
#include "app/command_line/option_text.hpp"
#include "app/command_line/values.hpp"

namespace pedzone {
namespace {

/// The script's name of a command: "/study/run"; of the program: "".
std::string path_of(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? "" : path_of(*parent) + "/" + command.get_name();
}

/// The lines of three `case`s.
struct BashCases {
  std::string commands;  ///< which words choose a command
  std::string values;    ///< what an option's value may be
  std::string words;     ///< what may stand in a command else
};

void add_cases(CLI::App& command, BashCases& cases) {
  const std::string path = path_of(command);
  std::vector<std::string> words = command_names(command);
  for (CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    const std::vector<std::string> choices = choices_of(*option);
    if (!option->nonpositional()) words.insert(words.end(), choices.begin(), choices.end());
    if (!option->nonpositional() || option->get_items_expected_max() == 0) continue;
    // Without choices: nothing of ours, and so files.
    cases.values += fmt::format("    '{} {}') words='{}' ;;\n", path, option->get_name(),
                                fmt::join(choices, " "));
  }
  const std::vector<std::string> options = option_names(command);
  words.insert(words.end(), options.begin(), options.end());
  cases.words += fmt::format("    '{}') words='{}' ;;\n", path, fmt::join(words, " "));
  for (CLI::App* inner : command.get_subcommands({})) {
    if (inner->get_group().empty()) continue;
    cases.commands += fmt::format("      '{}') command+=/$word ;;\n", path_of(*inner));
    add_cases(*inner, cases);
  }
}

constexpr const char* kScript = R"(# bash completion for pedzone, made by `pedzone completion bash`
_pedzone() {{
  local command= words= word
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    [[ $word != -- ]] || return 0
    case $command/$word in
{}    esac
  done
  word=${{COMP_WORDS[COMP_CWORD-1]}}
  [[ $word != = ]] || word=${{COMP_WORDS[COMP_CWORD-2]}}  # bash parts --kind=path at the =
  case "$command $word" in
{}    *)
    case $command in
{}    esac ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "${{COMP_WORDS[COMP_CWORD]}}"))
}}
complete -o default -F _pedzone pedzone
)";

}  // namespace

std::string bash_completion(CLI::App& app) {
  BashCases cases;
  add_cases(app, cases);
  return fmt::format(kScript, cases.commands, cases.values, cases.words);
}

}  // namespace pedzone
