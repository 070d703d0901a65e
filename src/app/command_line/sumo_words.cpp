#include "app/command_line/sumo_words.hpp"

#include "app/command_line/option_text.hpp"
#include "study/plan/sumo_options.hpp"

namespace pedzone {

void add_sumo_words(CLI::App& command, std::vector<std::string>& words) {
  command.add_option(kSumoOptions, words, "Any options of SUMO; they win over what pedzone says");
}

void require_sumo_words(const CLI::App& command, const std::vector<std::string>& words) {
  if (!words.empty() && !words.front().starts_with("-")) {
    throw InputError(
        "is no option of SUMO",
        {.element = command_name(command), .value = words.front(), .allowed = synopsis(command)});
  }
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || command.get_option_no_throw(name) == nullptr) continue;
    if (study::known_sumo_option(name.substr(2))) continue;
    throw InputError("is an option of pedzone",
                     {"", 0, "after --", name, "options of SUMO; those of pedzone go before --"});
  }
}

bool is_sumo_option(const CLI::App& command, const std::string& option) {
  if (command.get_option_no_throw(kSumoOptions) == nullptr || !option.starts_with("--")) {
    return false;
  }
  try {
    return study::known_sumo_option(option.substr(2)).has_value();
  } catch (const std::exception&) {  // no `sumo` that could tell
    return false;
  }
}

InputError sumo_option_before_dashes(const CLI::App& command, const std::string& option) {
  return {"is an option of SUMO",
          {.element = "before --",
           .value = option,
           .allowed = "options of " + command_name(command) + "; those of SUMO go after --"}};
}

}  // namespace pedzone
