#include "sumo/files/scenario.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "core/input_files.hpp"
#include "core/xml_stream.hpp"
#include "sumo/files/file_list.hpp"
#include "sumo/files/net_reader.hpp"
#include "sumo/files/said_options.hpp"

namespace pedzone {
namespace {

namespace fs = std::filesystem;

const SumoOption kNetFile{{"net-file", "n", "net"}};
const SumoOption kAdditional{{"additional-files", "a", "additional"}};
const SumoOption kRoutes{{"route-files", "r", "routes"}};
const SumoOption kModel{{"pedestrian.model"}};
const SumoOption kSeed{{"seed", "srand"}};
const SumoOption kRandom{{"random", "abs-rand"}};
const SumoOption kBegin{{"begin", "b"}};
const SumoOption kEnd{{"end", "e"}};
const SumoOption kDawdling{{"pedestrian.striping.dawdling"}};
const SumoOption kNoStepLog{{"no-step-log"}};
const SumoOption kMesoscopic{{"mesosim"}};

// What pedzone cannot go along with, and why.
struct Refused {
  SumoOption option;
  std::string_view problem, allowed;
};
constexpr std::string_view kOtherWork = "makes SUMO do something else than simulate";
constexpr std::string_view kUseSumo = "what `sumo` itself is for";
constexpr std::string_view kStates =
    "is about saved states, which do not hold whom pedzone walks or how";
constexpr std::string_view kNoStates = "a run from its begin to its end";
const Refused kRefused[] = {
    {{{"configuration-file", "c", "configuration"}},
     "names a second configuration",
     "the one before --"},
    {{{"help", "?"}}, kOtherWork, kUseSumo},
    {{{"version", "V"}}, kOtherWork, kUseSumo},
    {{{"save-configuration", "C", "save-config"}}, kOtherWork, kUseSumo},
    {{{"save-template"}}, kOtherWork, kUseSumo},
    {{{"save-schema"}}, kOtherWork, kUseSumo},
    {{{"remote-port"}},
     "waits for other programs to run SUMO",
     "--clients N --port P before --, or `sumo` with it and then `pedzone attach`"},
    {{{"load-state"}}, kStates, kNoStates},
    {{{"save-state.times"}}, kStates, kNoStates},
    {{{"save-state.period"}}, kStates, kNoStates},
    {{{"save-state.files"}}, kStates, kNoStates},
};

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

double number_of(const SaidOptions& said, const SumoOption& option, double otherwise) {
  const auto text = said.value(option);
  if (!text) return otherwise;
  if (const auto number = parse_time(*text)) return *number;
  throw said.error(option, "is not a number", *text, "a number");
}

std::vector<std::string> split_files(const std::string& list, const fs::path& folder) {
  std::vector<std::string> files;
  for (const std::string& word : split_file_list(list)) {
    const fs::path path(word);
    files.push_back(path.is_absolute() || folder.empty() ? word : (folder / path).string());
  }
  return files;
}

std::vector<std::string> files_of(const SaidOptions& said, const SumoOption& option) {
  const fs::path folder =
      said.on_command_line(option) ? fs::path() : fs::path(said.config().file()).parent_path();
  const std::vector<std::string> files = split_files(said.value(option).value_or(""), folder);
  for (const std::string& file : files) {
    if (fs::is_regular_file(file)) continue;
    throw said.error(option, "does not exist", file, "a file that can be read");
  }
  for (const std::string& file : files) note_input(file);
  return files;
}

void require_microscopic_striping(const SaidOptions& said) {
  if (said.is_true(kMesoscopic)) {
    throw said.error(kMesoscopic, "has vehicles without a place on their lane", "true", "false");
  }
  if (const auto model = said.value(kModel); model && *model != "striping") {
    throw said.error(kModel, "is a pedestrian model that pedzone cannot take persons over from",
                     *model, "striping");
  }
}

/// An empty value, false and a negative number switch an option off.
void require_simulation(const SaidOptions& said) {
  for (const Refused& refused : kRefused) {
    const auto value = said.value(refused.option);
    double number = 0.0;
    if (!value || value->empty() || *value == "false" || *value == "0") continue;
    if (parse_number(*value, number) && number < 0.0) continue;
    throw said.error(refused.option, std::string(refused.problem), *value,
                     std::string(refused.allowed));
  }
}

/// Whether a file, gzipped or not, or one that it includes, has a person or a flow of them. Read in
/// pieces: route files can be too large to hold.
bool has_person(const std::string& name) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(name.c_str(), "rb"), gzclose);
  if (!file) return false;
  constexpr std::string_view kPerson = "<person", kInclude = "<include";
  std::string text;
  bool includes = false;
  std::array<char, 1 << 16> piece;
  for (int got = 0; (got = gzread(file.get(), piece.data(), piece.size())) > 0;) {
    text.append(piece.data(), static_cast<std::size_t>(got));
    if (text.find(kPerson) != std::string::npos) return true;
    includes |= text.find(kInclude) != std::string::npos;
    text.erase(0, text.size() - std::min(text.size(), kInclude.size()));
  }
  bool any = false;
  if (!includes) return any;
  visit_elements(name, "", [&](const XmlElement& element) {
    any |= element.name() == "person" || element.name() == "personFlow";
  });
  return any;
}

/// `sumo_options`: the words of `said`.
Scenario scenario_of(const SaidOptions& said, const std::vector<std::string>& sumo_options) {
  Scenario scenario;
  scenario.config = said.config().file();
  scenario.sumo_options = sumo_options;
  const std::vector<std::string> nets = files_of(said, kNetFile);
  if (nets.size() != 1) {
    throw said.config().error("names no network", said.config().root(), "", "",
                              "a SUMO configuration with <net-file value=\"...\"/>");
  }
  scenario.net_file = nets.front();
  scenario.additional_files = files_of(said, kAdditional);
  scenario.route_files = files_of(said, kRoutes);
  return scenario;
}

}  // namespace

Scenario read_scenario(const std::string& config, const std::vector<std::string>& sumo_options) {
  const SaidOptions said(config, sumo_options);
  require_microscopic_striping(said);
  require_simulation(said);
  return scenario_of(said, sumo_options);
}

Scenario read_any_scenario(const std::string& config,
                           const std::vector<std::string>& sumo_options) {
  return scenario_of(SaidOptions(config, sumo_options), sumo_options);
}

std::vector<std::string> words_for_sumo(const Scenario& scenario,
                                        const std::optional<std::uint64_t>& seed,
                                        const std::optional<double>& end) {
  const SaidOptions said(scenario.config, scenario.sumo_options);
  std::vector<std::string> words = scenario.sumo_options;
  const auto add = [&](const SumoOption& option, const std::string& value) {
    if (said.on_command_line(option)) {
      throw said.error(option, "is said twice", *said.value(option),
                       "--" + option.names.front() + " before -- or after it");
    }
    words.insert(words.end(), {"--" + option.names.front(), value});
  };
  if (seed) {
    add(kSeed, std::to_string(*seed));
    if (said.is_true(kRandom)) add(kRandom, "false");
  }
  if (end) add(kEnd, std::to_string(*end));
  if (!said.value(kNoStepLog)) add(kNoStepLog, "true");
  return words;
}

bool has_step_log(const Scenario& scenario) {
  const SaidOptions said(scenario.config, scenario.sumo_options);
  return said.value(kNoStepLog) && !said.is_true(kNoStepLog);
}

Network read_scenario_network(const Scenario& scenario) {
  Network network = read_network(scenario.net_file);
  for (const std::string& file : scenario.additional_files) read_shapes(file, network);
  return network;
}

bool names_person(const Scenario& scenario) {
  const auto any = [](const std::vector<std::string>& files) {
    return std::any_of(files.begin(), files.end(), has_person);
  };
  return any(scenario.route_files) || any(scenario.additional_files);
}

InputError no_person(const Scenario& scenario) {
  return {"names no person",
          {scenario.config, 0, "<route-files>", "",
           "route or additional files with <person> or <personFlow>"}};
}

ScenarioNumbers read_numbers(const Scenario& scenario) {
  constexpr double kSumoSeed = 23423, kSumoDawdling = 0.2;  // SUMO's defaults
  const SaidOptions said(scenario.config, scenario.sumo_options);
  return {static_cast<std::uint64_t>(std::max(0.0, number_of(said, kSeed, kSumoSeed))),
          number_of(said, kBegin, 0.0),
          std::clamp(number_of(said, kDawdling, kSumoDawdling), 0.0, 1.0)};
}

void require_later_end(const Scenario& scenario, double end, const InputPlace& what) {
  const double begin = read_numbers(scenario).begin;
  if (end > begin) return;
  InputPlace place = what;
  place.allowed = "a time after the begin that " + scenario.config + " says";
  throw InputError("is not later than the run's begin", place);
}

void add_additional_file(Scenario& scenario, const std::string& file) {
  std::string files;
  for (const std::string& other : scenario.additional_files) files += other + ",";
  set_option(scenario.sumo_options, kAdditional, files + file);
}

}  // namespace pedzone
