#include "study/plan/factors.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "core/text.hpp"
#include "study/plan/setting.hpp"

namespace pedzone::study {
namespace {

constexpr SettingKind kKinds[] = {SettingKind::kSumo, SettingKind::kPanel, SettingKind::kParameter,
                                  SettingKind::kZone, SettingKind::kClient};

/// Whether both set the same thing somewhere.
bool clash(const Setting& a, const Setting& b) {
  const bool apart = !a.scenario.empty() && !b.scenario.empty() && a.scenario != b.scenario;
  return a.kind == b.kind && a.key == b.key && !apart;
}

/// What an element sets, by one of its attributes; the value is to come.
Setting read_key(const XmlFile& file, const pugi::xml_node& node) {
  Setting setting{SettingKind::kSumo, "", "", "", file.line(node)};
  int given = 0;
  for (const SettingKind kind : kKinds) {
    const std::string attribute = attribute_of(kind);
    if (!node.attribute(attribute.c_str())) continue;
    setting.kind = kind;
    setting.key = file.required(node, attribute.c_str());
    ++given;
  }
  if (given == 1) return setting;
  throw file.error(given == 0 ? "does not say what it sets" : "sets several things", node, "", "",
                   "one of the attributes sumo, panel, parameter, zone, client");
}

/// `values`: attribute that the value is from.
void check(const XmlFile& file, const pugi::xml_node& node, const char* values, Setting& setting) {
  try {
    check_setting(setting);
  } catch (const SettingError& error) {
    throw file.error(error.problem, node, error.of_key ? attribute_of(setting.kind) : values,
                     error.value, error.allowed);
  }
}

Setting read_setting(const XmlFile& file, const pugi::xml_node& node, const Study& study) {
  file.check_names(node, {"sumo", "panel", "parameter", "zone", "client", "value", "scenario"}, {});
  Setting setting = read_key(file, node);
  setting.value = file.required(node, "value");
  if (node.attribute("scenario")) setting.scenario = file.required(node, "scenario");
  const auto& known = study.scenarios;
  if (!setting.scenario.empty() &&
      std::ranges::find(known, setting.scenario, &StudyScenario::id) == known.end()) {
    throw file.error("is no scenario", node, "scenario", setting.scenario,
                     comma_list(known, &StudyScenario::id));
  }
  check(file, node, "value", setting);
  return setting;
}

Level read_level(const XmlFile& file, const pugi::xml_node& node, const Study& study) {
  file.check_names(node, {"name"}, {"set"});
  Level level{file.required(node, "name"), {}};
  if (split_words(level.name) != std::vector{level.name}) {
    throw file.error("is no name", node, "name", level.name, "a name without spaces");
  }
  for (const pugi::xml_node& child : node.children("set")) {
    Setting setting = read_setting(file, child, study);
    if (std::ranges::any_of(level.settings, [&](const auto& is) { return clash(is, setting); })) {
      throw file.error("is set twice", child, attribute_of(setting.kind), setting.key,
                       "each at most once in a level");
    }
    level.settings.push_back(std::move(setting));
  }
  return level;
}

/// One setting over a list of values.
std::vector<Level> read_values(const XmlFile& file, const pugi::xml_node& node) {
  std::vector<Level> levels;
  for (const std::string& value : split_words(file.required(node, "values"))) {
    Setting setting = read_key(file, node);
    setting.value = value;
    check(file, node, "values", setting);
    levels.push_back({value, {std::move(setting)}});
  }
  return levels;
}

/// Levels that set this and that.
std::vector<Level> read_levels(const XmlFile& file, const pugi::xml_node& node,
                               const Study& study) {
  for (const SettingKind kind : kKinds) {
    const pugi::xml_attribute key = node.attribute(attribute_of(kind).c_str());
    if (!key) continue;
    throw file.error("needs attribute values", node, key.name(), key.value(),
                     "values=\"...\" with it, or <level>s without it");
  }
  std::vector<Level> levels;
  for (const pugi::xml_node& child : node.children("level")) {
    levels.push_back(read_level(file, child, study));
  }
  return levels;
}

Factor read_factor(const XmlFile& file, const pugi::xml_node& node, const Study& study) {
  file.check_names(node, {"id", "values", "sumo", "panel", "parameter", "zone", "client"},
                   {"level"});
  const std::string id = file.required(node, "id");
  if (std::ranges::find(study.factors, id, &Factor::id) != study.factors.end()) {
    throw file.error("is used twice", node, "id", id, "a new id");
  }
  const bool by_values = node.attribute("values");
  if (by_values && node.child("level")) {
    throw file.error("has levels, too", node, "values", node.attribute("values").value(),
                     "values or <level>s");
  }
  Factor factor{id, by_values ? read_values(file, node) : read_levels(file, node, study)};
  if (factor.levels.empty()) {
    throw file.error("has no level", node, "", "", "attribute values, or <level>s");
  }
  std::set<std::string> names;
  for (const Level& level : factor.levels) {
    if (names.insert(level.name).second) continue;
    throw file.error("names a level twice", node, by_values ? "values" : "", level.name,
                     "each level once");
  }
  return factor;
}

/// Somebody has to understand the options of a client.
void require_client(const XmlFile& file, const pugi::xml_node& node, const Factor& factor,
                    const Study& study) {
  for (const Level& level : factor.levels) {
    for (const Setting& setting : level.settings) {
      const bool heard = std::ranges::any_of(study.scenarios, [&](const StudyScenario& scenario) {
        return !scenario.client.empty() &&
               (setting.scenario.empty() || setting.scenario == scenario.id);
      });
      if (heard || setting.kind != SettingKind::kClient) continue;
      throw file.error("is an option of a client, and there is none", node, "client", setting.key,
                       "<scenario client=\"...\"/>");
    }
  }
}

/// What the factor sets in one level or another.
std::set<std::tuple<SettingKind, std::string, std::string>> keys_of(const Factor& factor) {
  std::set<std::tuple<SettingKind, std::string, std::string>> keys;
  for (const Level& level : factor.levels) {
    for (const Setting& setting : level.settings) {
      keys.emplace(setting.kind, setting.key, setting.scenario);
    }
  }
  return keys;
}

/// Nothing may be set by two factors: which of them would win?
void require_apart(const XmlFile& file, const pugi::xml_node& node, const Factor& factor,
                   const Factor& other) {
  for (const auto& [kind, key, scenario] : keys_of(factor)) {
    for (const auto& [other_kind, other_key, other_scenario] : keys_of(other)) {
      if (!clash({kind, key, "", scenario}, {other_kind, other_key, "", other_scenario})) continue;
      throw file.error("is set by factor " + other.id + ", too", node, attribute_of(kind), key,
                       "each by one factor");
    }
  }
}

/// The levels that a combination names, as indices.
std::vector<std::size_t> read_combination(const XmlFile& file, const pugi::xml_node& node,
                                          const Study& study) {
  file.check_names(node, {"levels"}, {});
  const std::string value = file.required(node, "levels");
  const auto names = split_words(value);
  if (names.size() != study.factors.size()) {
    throw file.error("does not name one level of each factor", node, "levels", value,
                     study.factors.empty()
                         ? "no <combination> without a <factor>"
                         : "a level of each of " + comma_list(study.factors, &Factor::id));
  }
  std::vector<std::size_t> levels;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& known = study.factors[i].levels;
    const auto found = std::ranges::find(known, names[i], &Level::name);
    if (found == known.end()) {
      throw file.error("is no level of factor " + study.factors[i].id, node, "levels", names[i],
                       comma_list(known, &Level::name));
    }
    levels.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  if (std::ranges::find(study.combinations, levels) != study.combinations.end()) {
    throw file.error("is given twice", node, "levels", value, "each combination once");
  }
  return levels;
}

/// The last factor changes first.
std::vector<std::vector<std::size_t>> all_combinations(const XmlFile& file, const Study& study) {
  std::vector<std::vector<std::size_t>> combinations{{}};
  for (const Factor& factor : study.factors) {
    if (combinations.size() * factor.levels.size() > kMostRuns) {
      throw file.error("make too many combinations", file.root(), "", "<factor>s",
                       std::to_string(kMostRuns) + ", or list them as <combination>s");
    }
    std::vector<std::vector<std::size_t>> longer;
    for (const auto& start : combinations) {
      for (std::size_t level = 0; level < factor.levels.size(); ++level) {
        longer.push_back(start);
        longer.back().push_back(level);
      }
    }
    combinations = std::move(longer);
  }
  return combinations;
}

}  // namespace

void read_factors(const XmlFile& file, Study& study) {
  for (const pugi::xml_node& node : file.root().children("factor")) {
    Factor factor = read_factor(file, node, study);
    require_client(file, node, factor, study);
    for (const Factor& other : study.factors) require_apart(file, node, factor, other);
    study.factors.push_back(std::move(factor));
  }
  for (const pugi::xml_node& node : file.root().children("combination")) {
    study.combinations.push_back(read_combination(file, node, study));
  }
  if (study.combinations.empty()) study.combinations = all_combinations(file, study);
}

}  // namespace pedzone::study
