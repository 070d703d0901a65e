#include "study/study_file.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "core/xml.hpp"
#include "study/seed_list.hpp"
#include "study/setting.hpp"
#include "study/sumo_options.hpp"
#include "sumo/scenario.hpp"
#include "world/model_names.hpp"
#include "zone/zone_file.hpp"

namespace pedzone {
namespace {

namespace fs = std::filesystem;

constexpr NumberRange kEnds{0.001, 1e9};      // [s] simulated
constexpr NumberRange kTimeLimits{1.0, 1e7};  // [s] wall clock
constexpr std::size_t kMostRuns = 1'000'000;  // numerical: a plan is held
constexpr const char* kDefaultSeeds = "1-10";
constexpr const char* kDefaultModels = "striping heuristic";
constexpr SettingKind kKinds[] = {SettingKind::kSumo, SettingKind::kPanel, SettingKind::kParameter,
                                  SettingKind::kZone};

/// A file's name without folder and endings: "old-town" of "a/old-town.study.xml".
std::string stem_of(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  return name.substr(0, name.find('.', 1));
}

template <class List, class Name = std::identity>
std::string joined(const List& list, Name name = {}) {
  std::string text;
  for (const auto& item : list) {
    text += (text.empty() ? "" : ", ") + std::string(std::invoke(name, item));
  }
  return text;
}

/// Whether the bytes are UTF-8 (RFC 3629), but for what only a decoder of characters finds.
bool is_utf8(std::string_view text) {
  std::size_t more = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xC0u) == 0x80u;
    if (continues != (more > 0)) return false;
    if (continues) {
      --more;
    } else {
      more = byte < 0x80         ? 0
             : (byte >> 5) == 6  ? 1
             : (byte >> 4) == 14 ? 2
             : (byte >> 3) == 30 ? 3
                                 : 4;
      if (more == 4) return false;
    }
  }
  return more == 0;
}

/// Reads one study file.
class Reader {
 public:
  Reader(const std::string& file, const std::string& folder) : file_(file, {"study"}) {
    study_.file = file;
    const fs::path place = folder.empty() ? fs::absolute(file).parent_path() : fs::absolute(folder);
    study_.folder = place.lexically_normal().string();
  }

  Study read() {
    const pugi::xml_node root = file_.root();
    check_encoding();
    file_.check_names(
        root, {"id", "title", "question", "seeds", "models", "reference", "end", "timeLimit"},
        {"scenario", "factor", "combination"});
    study_.id = word(root, "id", stem_of(study_.file));
    study_.title = root.attribute("title").value();
    study_.question = root.attribute("question").value();
    read_seeds(root);
    read_models(root);
    if (root.attribute("end")) study_.end = file_.number(root, "end", kEnds);
    study_.time_limit = file_.number(root, "timeLimit", kTimeLimits, study_.time_limit);
    for (const pugi::xml_node& node : root.children("scenario")) read_scenario_of(node);
    if (study_.scenarios.empty()) {
      throw file_.error("has no <scenario>", root, "", "", "one <scenario file=\"...\"/> or more");
    }
    for (const pugi::xml_node& node : root.children("factor")) read_factor(node);
    require_one_setter();
    for (const pugi::xml_node& node : root.children("combination")) read_combination(node);
    if (study_.combinations.empty()) study_.combinations = all_combinations();
    limit_runs();
    return study_;
  }

 private:
  std::string word(const pugi::xml_node& node, const char* attribute,
                   const std::string& otherwise) const {
    return node.attribute(attribute) ? file_.required(node, attribute) : otherwise;
  }

  /// Everything ends up in JSON and HTML, which know no other encoding.
  void check_encoding() const {
    struct Walker : pugi::xml_tree_walker {
      const XmlFile& file;
      explicit Walker(const XmlFile& of) : file(of) {}
      bool for_each(pugi::xml_node& node) override {
        for (const pugi::xml_attribute& attribute : node.attributes()) {
          if (!is_utf8(attribute.value())) {
            throw file.error("is no text", node, attribute.name(), "", "UTF-8");
          }
        }
        return true;
      }
    } walker(file_);
    pugi::xml_node root = file_.root();
    walker.for_each(root);
    root.traverse(walker);
  }

  void read_seeds(const pugi::xml_node& root) {
    try {
      study_.seeds =
          parse_seeds(root.attribute("seeds") ? root.attribute("seeds").value() : kDefaultSeeds);
    } catch (const SeedListError& error) {
      throw file_.error(error.problem, root, "seeds", error.value, error.allowed);
    }
  }

  void read_models(const pugi::xml_node& root) {
    study_.models = split_words(word(root, "models", kDefaultModels));
    if (study_.models.empty()) throw file_.error("names no model", root, "models");
    std::set<std::string> known;
    for (const std::string& model : study_.models) {
      if (!is_sumo_model(model) && !may_be_model(model)) {
        throw file_.error(
            "is no walking model", root, "models", model,
            std::string(kStriping) + ", " + kNonInteracting + ", " + allowed_models());
      }
      if (names_plugin(model) && !fs::is_regular_file(study_.resolve(model))) {
        throw file_.error("does not exist", root, "models", study_.resolve(model),
                          "a shared library with a walking model");
      }
      if (!known.insert(model).second) {
        throw file_.error("is named twice", root, "models", model, "each model once");
      }
    }
    const bool striping = known.contains(kStriping);
    study_.reference = word(root, "reference", striping ? kStriping : study_.models.front());
    if (!known.contains(study_.reference)) {
      throw file_.error("is none of the study's models", root, "reference", study_.reference,
                        joined(study_.models));
    }
  }

  void read_scenario_of(const pugi::xml_node& node) {
    file_.check_names(node, {"id", "file", "zone", "options"}, {});
    StudyScenario scenario;
    scenario.file = file_.required(node, "file");
    scenario.id = word(node, "id", stem_of(scenario.file));
    for (const StudyScenario& other : study_.scenarios) {
      if (other.id != scenario.id) continue;
      throw file_.error("is used twice", node, "id", scenario.id, "a new id");
    }
    require_file(node, "file", scenario.file);
    scenario.zone_file = word(node, "zone", "");
    if (!scenario.zone_file.empty()) {
      require_file(node, "zone", scenario.zone_file);
      read_zone_file(study_.resolve(scenario.zone_file));  // for what it refuses
    }
    try {
      const auto words = split_words(node.attribute("options").value());
      scenario.sumo_options = parse_sumo_options(words).words();
    } catch (const SumoOptionError& error) {
      throw file_.error(error.problem, node, "options", error.value, error.allowed);
    }
    require_end(node, scenario);
    study_.scenarios.push_back(std::move(scenario));
  }

  void require_file(const pugi::xml_node& node, const char* attribute,
                    const std::string& path) const {
    if (fs::is_regular_file(study_.resolve(path))) return;
    throw file_.error("does not exist", node, attribute, study_.resolve(path),
                      "a file, relative to " + study_.folder);
  }

  /// People who jam would keep a run without one going for ever.
  void require_end(const pugi::xml_node& node, const StudyScenario& scenario) const {
    const XmlFile config(study_.resolve(scenario.file));
    if (study_.end) return;
    const pugi::xml_node end = config.root().find_node([](const pugi::xml_node& inner) {
      return inner.name() == std::string_view("end") || inner.name() == std::string_view("e");
    });
    double number = 0.0;
    const std::string value = end.attribute("value").value();
    if (end && !(parse_number(value, number) && number <= 0.0)) return;
    throw file_.error("does not end", node, "file", scenario.file,
                      "a scenario with <end value=\"...\"/>, or attribute end of <study>");
  }

  void read_factor(const pugi::xml_node& node) {
    file_.check_names(node, {"id", "values", "sumo", "panel", "parameter", "zone"}, {"level"});
    Factor factor;
    factor.id = file_.required(node, "id");
    if (std::ranges::find(study_.factors, factor.id, &Factor::id) != study_.factors.end()) {
      throw file_.error("is used twice", node, "id", factor.id, "a new id");
    }
    if (node.attribute("values")) {
      read_values(node, factor);
    } else {
      for (const pugi::xml_node& child : node.children("level")) read_level(child, factor);
    }
    if (factor.levels.empty()) {
      throw file_.error("has no level", node, "", "", "attribute values, or <level>s");
    }
    study_.factors.push_back(std::move(factor));
  }

  void read_values(const pugi::xml_node& node, Factor& factor) {
    if (node.child("level")) {
      throw file_.error("has values and levels", node, "values", "", "one of the two");
    }
    for (const std::string& value : split_words(file_.required(node, "values"))) {
      Setting setting = read_key(node);
      setting.value = value;
      check(node, setting, "values");
      add_level(node, "values", {value, {std::move(setting)}}, factor);
    }
  }

  void read_level(const pugi::xml_node& node, Factor& factor) {
    for (const SettingKind kind : kKinds) {
      const std::string key = attribute_of(kind);
      if (!node.parent().attribute(key.c_str())) continue;
      throw file_.error("needs attribute values", node.parent(), key,
                        node.parent().attribute(key.c_str()).value(),
                        "values=\"...\", or <level>s without it");
    }
    file_.check_names(node, {"name"}, {"set"});
    Level level{file_.required(node, "name"), {}};
    if (split_words(level.name) != std::vector{level.name}) {
      throw file_.error("is no name", node, "name", level.name, "a name without spaces");
    }
    for (const pugi::xml_node& child : node.children("set")) {
      file_.check_names(child, {"sumo", "panel", "parameter", "zone", "value", "scenario"}, {});
      Setting setting = read_key(child);
      setting.value = file_.required(child, "value");
      setting.scenario = word(child, "scenario", "");
      const auto& scenarios = study_.scenarios;
      if (!setting.scenario.empty() &&
          std::ranges::find(scenarios, setting.scenario, &StudyScenario::id) == scenarios.end()) {
        throw file_.error("is no scenario", child, "scenario", setting.scenario,
                          joined(scenarios, &StudyScenario::id));
      }
      check(child, setting, "value");
      level.settings.push_back(std::move(setting));
    }
    add_level(node, "name", std::move(level), factor);
  }

  void add_level(const pugi::xml_node& node, const char* attribute, Level level, Factor& factor) {
    if (std::ranges::find(factor.levels, level.name, &Level::name) != factor.levels.end()) {
      throw file_.error("is named twice", node, attribute, level.name, "each level once");
    }
    factor.levels.push_back(std::move(level));
  }

  /// What is set; the value is still to come.
  Setting read_key(const pugi::xml_node& node) const {
    Setting setting{SettingKind::kSumo, "", "", "", file_.line(node)};
    int given = 0;
    for (const SettingKind kind : kKinds) {
      const std::string attribute = attribute_of(kind);
      if (!node.attribute(attribute.c_str())) continue;
      setting.kind = kind;
      setting.key = file_.required(node, attribute.c_str());
      ++given;
    }
    if (given == 1) return setting;
    throw file_.error(given == 0 ? "says not what it sets" : "sets several things", node, "", "",
                      "one of the attributes sumo, panel, parameter, zone");
  }

  void check(const pugi::xml_node& node, Setting& setting, const char* values) const {
    try {
      check_setting(setting);
    } catch (const SettingError& error) {
      throw file_.error(error.problem, node, error.of_key ? attribute_of(setting.kind) : values,
                        error.value, error.allowed);
    }
  }

  /// One thing must not be set by two factors, nor twice by a level.
  void require_one_setter() const {
    struct Setter {
      const Factor* factor;
      const Level* level;
      const Setting* setting;
    };
    std::vector<Setter> setters;
    for (const Factor& factor : study_.factors) {
      for (const Level& level : factor.levels) {
        for (const Setting& setting : level.settings)
          setters.push_back({&factor, &level, &setting});
      }
    }
    std::map<std::pair<SettingKind, std::string>, std::vector<Setter>> by_key;
    for (const Setter& setter : setters) {
      auto& others = by_key[{setter.setting->kind, setter.setting->key}];
      for (const Setter& other : others) {
        const std::string &a = other.setting->scenario, &b = setter.setting->scenario;
        const bool together = other.factor != setter.factor || other.level == setter.level;
        if (!together || (!a.empty() && !b.empty() && a != b)) continue;
        throw InputError("is set twice in one combination",
                         {study_.file, setter.setting->line,
                          "<factor id=\"" + setter.factor->id + "\"> attribute " +
                              attribute_of(setter.setting->kind),
                          setter.setting->key, "once, by one factor"});
      }
      others.push_back(setter);
    }
  }

  void read_combination(const pugi::xml_node& node) {
    file_.check_names(node, {"levels"}, {});
    const auto names = split_words(file_.required(node, "levels"));
    if (names.size() != study_.factors.size()) {
      throw file_.error(
          "names not a level of each factor", node, "levels", node.attribute("levels").value(),
          study_.factors.empty() ? "no <combination> without a <factor>"
                                 : "a level of each of " + joined(study_.factors, &Factor::id));
    }
    std::vector<std::size_t> levels;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto& known = study_.factors[i].levels;
      const auto found = std::ranges::find(known, names[i], &Level::name);
      if (found == known.end()) {
        throw file_.error("is no level of factor " + study_.factors[i].id, node, "levels", names[i],
                          joined(known, &Level::name));
      }
      levels.push_back(static_cast<std::size_t>(found - known.begin()));
    }
    if (std::ranges::find(study_.combinations, levels) != study_.combinations.end()) {
      throw file_.error("is given twice", node, "levels", node.attribute("levels").value(),
                        "each combination once");
    }
    study_.combinations.push_back(std::move(levels));
  }

  /// The last factor changes first.
  std::vector<std::vector<std::size_t>> all_combinations() const {
    std::vector<std::vector<std::size_t>> combinations{{}};
    for (const Factor& factor : study_.factors) {
      if (combinations.size() * factor.levels.size() > kMostRuns) throw too_many();
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

  void limit_runs() const {
    const double runs = static_cast<double>(study_.combinations.size()) *
                        static_cast<double>(study_.scenarios.size()) *
                        static_cast<double>(study_.models.size()) *
                        static_cast<double>(study_.seeds.size());
    if (runs > static_cast<double>(kMostRuns)) throw too_many();
  }

  InputError too_many() const {
    return file_.error("asks for too many runs", file_.root(), "", "",
                       std::to_string(kMostRuns) + " in all: fewer seeds, models or levels");
  }

  XmlFile file_;
  Study study_;
};

}  // namespace

bool is_sumo_model(const std::string& model) {
  return model == kStriping || model == kNonInteracting;
}

std::string Study::resolve(const std::string& path) const {
  return (fs::path(folder) / path).lexically_normal().string();
}

Study read_study(const std::string& file, const std::string& folder) {
  return Reader(file, folder).read();
}

}  // namespace pedzone
