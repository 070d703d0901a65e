#include "study/plan/sumo_options.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "core/error.hpp"
#include "core/xml.hpp"
#include "study/plan/study_file.hpp"
#include "study/plan/sumo_answer.hpp"
#include "sumo/files/file_list.hpp"

namespace pedzone::study {
namespace {

struct OptionInfo {
  std::string name, type;  ///< BOOL, INT, FLOAT, TIME, FILE, STR or STR[]
  std::string otherwise;   ///< default
};
using OptionTable = std::map<std::string, OptionInfo, std::less<>>;  ///< by each of their names

/// What `sumo` itself says that it has.
OptionTable read_option_table() {
  const std::string text = sumo_answer({"--save-template", "/dev/stdout"});
  pugi::xml_document document;
  OptionTable table;
  if (document.load_buffer(text.data(), text.size())) {
    for (const auto& found : document.select_nodes("/configuration/*/*")) {
      const pugi::xml_node node = found.node();
      const OptionInfo info{node.name(), node.attribute("type").value(),
                            node.attribute("value").value()};
      table.emplace(info.name, info);
      for (const auto& other : split_words(node.attribute("synonymes").value())) {
        table.emplace(other, info);
      }
    }
  }
  if (table.empty()) throw SumoError("sumo --save-template tells no options");
  return table;
}

const OptionTable& option_table() {
  static const OptionTable table = read_option_table();
  return table;
}

/// Options that a study decides, or that its measures rest on.
struct Reserved {
  std::string_view name;  ///< also of all NAME.SOMETHING
  std::string_view allowed;
};
constexpr std::string_view kByAttributes = "attributes seeds, models and end of <study>";
constexpr std::string_view kMeasured = "other options: this one is for the study's measures";
constexpr std::string_view kExplicit = ".explicit";  // of devices: who has one
constexpr std::string_view kByStudy = "other options: a study starts SUMO itself";
constexpr Reserved kReserved[] = {
    {"seed", kByAttributes},
    {"random", kByAttributes},
    {"end", kByAttributes},
    {"pedestrian.model", kByAttributes},
    {"fcd-output", kMeasured},
    {"device.fcd", kMeasured},
    {"person-device.fcd", kMeasured},
    {"tripinfo-output", kMeasured},
    {"statistic-output", kMeasured},
    {"device.tripinfo", kMeasured},
    {"precision", kMeasured},
    {"human-readable-time", kMeasured},
    {"output-prefix", kMeasured},
    {"configuration-file", "attribute file of <scenario>"},
    {"save-configuration", kByStudy},
    {"save-template", kByStudy},
    {"save-schema", kByStudy},
    {"help", kByStudy},
    {"version", kByStudy},
    {"no-step-log", kByStudy},
    {"remote-port", kByStudy},
    {"num-clients", kByStudy},
};

/// Null where a study may set the option.
const Reserved* find_reserved(std::string_view option) {
  const auto found = std::ranges::find_if(kReserved, [&](const Reserved& reserved) {
    if (!option.starts_with(reserved.name)) return false;
    return option.size() == reserved.name.size() || option[reserved.name.size()] == '.';
  });
  return found == std::end(kReserved) ? nullptr : found;
}

bool is_value_of(const std::string& type, const std::string& value) {
  double number = 0.0;
  if (type == "INT") return parse_number(value, number) && number == static_cast<int>(number);
  if (type == "FLOAT") return parse_number(value, number);
  if (type == "BOOL") {
    constexpr std::string_view kWords[] = {"true", "false", "1", "0", "yes", "no", "on", "off"};
    return std::ranges::find(kWords, value) != std::end(kWords);
  }
  if (type != "TIME") return !value.empty();
  const auto parts = split_words(value, ':');
  return !parts.empty() && std::ranges::all_of(parts, [&](const std::string& part) {
    return parse_number(part, number);
  });
}

std::string describe_type(const std::string& type) {
  if (type == "INT") return "a whole number";
  if (type == "FLOAT") return "a number";
  if (type == "BOOL") return "true, false";
  return type == "TIME" ? "seconds or h:m:s" : "a value";
}

const OptionInfo& find_option(std::string_view name) {
  const auto found = option_table().find(name);
  if (found != option_table().end()) return found->second;
  throw SumoOptionError{"is no option of SUMO", std::string(name), "those of `sumo --help`"};
}

bool ends_as_option(const std::vector<std::string>& words, std::size_t next) {
  double number = 0.0;
  return next >= words.size() ||
         (words[next].starts_with("-") && !parse_number(words[next], number));
}

}  // namespace

void SumoOptions::set(std::string_view name, const std::string& value) {
  remove(name);
  words_.insert(words_.end(), {"--" + std::string(name), value});
}

void SumoOptions::remove(std::string_view name) {
  for (std::size_t i = 0; i + 1 < words_.size(); i += 2) {
    if (words_[i].substr(2) != name) continue;
    const auto first = words_.begin() + static_cast<std::ptrdiff_t>(i);
    words_.erase(first, first + 2);
    return;
  }
}

std::optional<std::string> SumoOptions::find(std::string_view name) const {
  for (std::size_t i = 0; i + 1 < words_.size(); i += 2) {
    if (words_[i].substr(2) == name) return words_[i + 1];
  }
  return std::nullopt;
}

void ask_sumo_options() { option_table(); }

std::optional<std::string> known_sumo_option(std::string_view name) {
  const auto found = option_table().find(name);
  return found == option_table().end() ? std::nullopt : std::optional(found->second.name);
}

bool is_measuring_list(std::string_view name) {
  const Reserved* reserved = find_reserved(name);
  if (!reserved || reserved->allowed != kMeasured) return false;
  return name.ends_with(kExplicit) || name == "fcd-output.filter-edges.input-file";
}

std::optional<std::string> chance_instead_of(std::string_view list) {
  if (!list.ends_with(kExplicit)) return std::nullopt;
  return std::string(list.substr(0, list.size() - kExplicit.size())) + ".probability";
}

std::optional<std::string> neutral_sumo_value(std::string_view name) {
  const Reserved* reserved = find_reserved(name);
  if (name == "pedestrian.model") return kStriping;
  const bool neutral = reserved && (reserved->allowed == kMeasured || name == "random");
  return neutral ? std::optional(find_option(name).otherwise) : std::nullopt;
}

std::string check_sumo_option(std::string_view name, const std::string& value) {
  const OptionInfo& option = find_option(name);
  if (const Reserved* reserved = find_reserved(option.name)) {
    throw SumoOptionError{"cannot be set by a study", std::string(name),
                          std::string(reserved->allowed)};
  }
  if (is_value_of(option.type, value)) return option.name;
  throw SumoOptionError{"is no value of SUMO's option " + option.name, value,
                        describe_type(option.type)};
}

SumoOptions parse_sumo_options(const std::vector<std::string>& words) {
  SumoOptions options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (!word.starts_with("-") || word.find_first_not_of('-') == std::string::npos) {
      throw SumoOptionError{"is no option", word, "--name value ..."};
    }
    const std::size_t equals = word.find('=');
    const std::string name =
        word.substr(word.starts_with("--") ? 2 : 1).substr(0, equals - (word[1] == '-' ? 2 : 1));
    const bool flag = find_option(name).type == "BOOL" && ends_as_option(words, i + 1);
    std::string value = "true";
    if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else if (!flag) {
      if (i + 1 == words.size()) throw SumoOptionError{"has no value", word, "--name value ..."};
      value = words[++i];
    }
    const std::string first = check_sumo_option(name, value);
    if (options.find(first)) throw SumoOptionError{"is given twice", word, "each option once"};
    options.set(first, value);
  }
  return options;
}

bool names_input_files(std::string_view option) {
  return option == "net-file" || option.ends_with("-files") || option.ends_with("input-file");
}

SumoOptions with_absolute_files(const SumoOptions& options, const Study& study) {
  SumoOptions resolved;
  for (std::size_t i = 0; i < options.words().size(); i += 2) {
    const std::string name = options.words()[i].substr(2);
    const std::string& value = options.words()[i + 1];
    std::string list;
    for (const std::string& file : split_file_list(value)) {
      list += (list.empty() ? "" : ",") + study.resolve(file);
    }
    resolved.set(name, names_input_files(name) ? list : value);
  }
  return resolved;
}

bool names_output_file(std::string_view option) {
  if (option.ends_with("-output") || option == "netstate-dump") return true;
  return option == "log" || option == "message-log" || option == "error-log";
}

}  // namespace pedzone::study
