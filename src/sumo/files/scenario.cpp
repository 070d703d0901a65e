#include "sumo/files/scenario.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "core/xml.hpp"
#include "sumo/files/file_list.hpp"
#include "sumo/files/net_reader.hpp"

namespace pedzone {
namespace {

namespace fs = std::filesystem;

/// One option of SUMO's with its synonyms, as on the command line and in a configuration.
struct Option {
  std::vector<std::string> names;  ///< the first is the one SUMO prints
};

const Option kNetFile{{"net-file", "n", "net"}};
const Option kAdditional{{"additional-files", "a", "additional"}};
const Option kRoutes{{"route-files", "r", "routes"}};
const Option kModel{{"pedestrian.model"}};
const Option kSeed{{"seed"}};
const Option kBegin{{"begin", "b"}};
const Option kDawdling{{"pedestrian.striping.dawdling"}};

bool is_name_of(const Option& option, std::string_view name) {
  return std::find(option.names.begin(), option.names.end(), name) != option.names.end();
}

/// An option on SUMO's command line: `--name value`, `--name=value`, `-n value`.
struct Given {
  std::string value;
  std::size_t first, count;  ///< the words that say it
};
std::optional<Given> find_given(const std::vector<std::string>& words, const Option& option) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string_view word = words[i];
    if (word.size() < 2 || word.front() != '-') continue;
    word.remove_prefix(word.starts_with("--") ? 2 : 1);
    const std::size_t equals = word.find('=');
    if (!is_name_of(option, word.substr(0, equals))) continue;
    if (equals != std::string_view::npos) return Given{std::string(word.substr(equals + 1)), i, 1};
    if (i + 1 < words.size()) return Given{words[i + 1], i, 2};
  }
  return std::nullopt;
}

std::optional<std::string> on_command_line(const std::vector<std::string>& words,
                                           const Option& option) {
  const auto given = find_given(words, option);
  return given ? std::optional(given->value) : std::nullopt;
}

/// The element of an option in a configuration; sections nest it one level deep.
pugi::xml_node in_configuration(const pugi::xml_node& root, const Option& option) {
  return root.find_node([&](const pugi::xml_node& node) {
    return is_name_of(option, node.name()) && node.attribute("value");
  });
}

/// A number, or a time as "h:m:s" or "d:h:m:s" in seconds.
std::optional<double> parse_time(const std::string& text) {
  constexpr double kUnits[] = {1.0, 60.0, 3600.0, 86400.0};
  const auto parts = split_words(text, ':');
  if (parts.empty() || parts.size() > std::size(kUnits)) return std::nullopt;
  double sum = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    double number = 0.0;
    if (!parse_number(parts[i], number)) return std::nullopt;
    sum += number * kUnits[parts.size() - 1 - i];
  }
  return sum;
}

double number_of(const XmlFile& config, const std::vector<std::string>& words, const Option& option,
                 double otherwise) {
  const auto given = on_command_line(words, option);
  const pugi::xml_node node = in_configuration(config.root(), option);
  if (!given && !node) return otherwise;
  const std::string text = given ? *given : node.attribute("value").value();
  if (const auto number = parse_time(text)) return *number;
  const std::string allowed = "a number";
  if (!given) throw config.error("is not a number", node, "value", text, allowed);
  throw InputError("is not a number",
                   {"", 0, "SUMO option --" + option.names.front(), text, allowed});
}

std::vector<std::string> split_files(const std::string& list, const fs::path& folder) {
  std::vector<std::string> files;
  for (const std::string& word : split_file_list(list)) {
    const fs::path path(word);
    files.push_back(path.is_absolute() || folder.empty() ? word : (folder / path).string());
  }
  return files;
}

std::vector<std::string> files_of(const XmlFile& config, const std::vector<std::string>& words,
                                  const Option& option) {
  const auto given = on_command_line(words, option);
  const pugi::xml_node node = in_configuration(config.root(), option);
  const std::vector<std::string> files =
      given ? split_files(*given, {})
            : split_files(node.attribute("value").value(), fs::path(config.file()).parent_path());
  for (const std::string& file : files) {
    if (fs::is_regular_file(file)) continue;
    if (given) {
      throw InputError("does not exist", {"", 0, "SUMO option --" + option.names.front(), file,
                                          "a file that can be read"});
    }
    throw config.error("does not exist", node, "value", file, "a file that can be read");
  }
  return files;
}

void require_striping(const XmlFile& config, const std::vector<std::string>& words) {
  const std::string problem = "is a pedestrian model that pedzone cannot take persons over from";
  if (const auto given = on_command_line(words, kModel)) {
    if (*given == "striping") return;
    throw InputError(problem, {"", 0, "SUMO option --pedestrian.model", *given, "striping"});
  }
  const pugi::xml_node node = in_configuration(config.root(), kModel);
  const std::string model = node.attribute("value").value();
  if (node && model != "striping") throw config.error(problem, node, "value", model, "striping");
}

/// Whether a file, gzipped or not, has a person or a flow of them. Read in pieces: route files
/// can be too large to hold.
bool has_person(const std::string& name) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(name.c_str(), "rb"), gzclose);
  if (!file) return false;
  constexpr std::string_view kPerson = "<person";
  std::string text;
  std::array<char, 1 << 16> piece;
  for (int got = 0; (got = gzread(file.get(), piece.data(), piece.size())) > 0;) {
    text.append(piece.data(), static_cast<std::size_t>(got));
    if (text.find(kPerson) != std::string::npos) return true;
    text.erase(0, text.size() - std::min(text.size(), kPerson.size()));
  }
  return false;
}

}  // namespace

Scenario read_scenario(const std::string& config, const std::vector<std::string>& sumo_options) {
  require_striping(XmlFile(config), sumo_options);
  return read_any_scenario(config, sumo_options);
}

Scenario read_any_scenario(const std::string& config,
                           const std::vector<std::string>& sumo_options) {
  const XmlFile file(config);
  Scenario scenario;
  scenario.config = config;
  scenario.sumo_options = sumo_options;
  const std::vector<std::string> nets = files_of(file, sumo_options, kNetFile);
  if (nets.size() != 1) {
    throw file.error("names no network", file.root(), "", "",
                     "a SUMO configuration with <net-file value=\"...\"/>");
  }
  scenario.net_file = nets.front();
  scenario.additional_files = files_of(file, sumo_options, kAdditional);
  scenario.route_files = files_of(file, sumo_options, kRoutes);
  return scenario;
}

Network read_scenario_network(const Scenario& scenario) {
  Network network = read_network(scenario.net_file);
  const bool walkable = std::any_of(network.lanes.begin(), network.lanes.end(),
                                    [](const Lane& lane) { return lane.persons; });
  if (!walkable) {
    throw InputError(
        "has no lane that persons may use",
        {scenario.net_file, 0, "<net>", "", "a network with lanes that allow pedestrians"});
  }
  for (const std::string& file : scenario.additional_files) read_shapes(file, network);
  return network;
}

void require_persons(const Scenario& scenario) {
  const auto any = [](const std::vector<std::string>& files) {
    return std::any_of(files.begin(), files.end(), has_person);
  };
  if (any(scenario.route_files) || any(scenario.additional_files)) return;
  throw InputError("names no person", {scenario.config, 0, "<route-files>", "",
                                       "route or additional files with <person> or <personFlow>"});
}

ScenarioNumbers read_numbers(const Scenario& scenario) {
  constexpr double kSumoSeed = 23423, kSumoDawdling = 0.2;  // SUMO's defaults
  const XmlFile config(scenario.config);
  const auto number = [&](const Option& option, double otherwise) {
    return number_of(config, scenario.sumo_options, option, otherwise);
  };
  return {static_cast<std::uint64_t>(std::max(0.0, number(kSeed, kSumoSeed))), number(kBegin, 0.0),
          std::clamp(number(kDawdling, kSumoDawdling), 0.0, 1.0)};
}

void add_additional_file(Scenario& scenario, const std::string& file) {
  auto& words = scenario.sumo_options;
  // SUMO takes an option once.
  while (const auto given = find_given(words, kAdditional)) {
    const auto first = words.begin() + static_cast<std::ptrdiff_t>(given->first);
    words.erase(first, first + static_cast<std::ptrdiff_t>(given->count));
  }
  std::string files;
  for (const std::string& other : scenario.additional_files) files += other + ",";
  words.insert(words.end(), {"--" + kAdditional.names.front(), files + file});
}

}  // namespace pedzone
